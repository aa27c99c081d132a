// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "checks/recording_check.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

/// As JSON; of bytes in file names that are no UTF-8, U+FFFD.
/// `topics`: of a bag, also those that no scans are made of.
[[nodiscard]] std::string to_json(const io::RecordingSummary& summary,
                                  const std::vector<io::TopicSurvey>& topics = {});
/// Of a bag with several topics that scans can be made of: what there is to choose from.
[[nodiscard]] std::string to_json(const std::vector<io::TopicSurvey>& topics);
/// Everything that was found, without the scans one by one.
[[nodiscard]] std::string to_json(const RecordingCheck& check);

}  // namespace surefoot::checks
