// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a person reads of a recording: a row for each thing, its name first.
#pragma once

#include <string>
#include <vector>

#include "checks/recording_check.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

/// `topics`: of a bag, also those that no scans are made of.
[[nodiscard]] std::string to_text(const io::RecordingSummary& summary,
                                  const std::vector<io::TopicSurvey>& topics = {});
/// Of a bag with several topics that scans can be made of: what there is to choose from.
[[nodiscard]] std::string to_text(const std::vector<io::TopicSurvey>& topics);
[[nodiscard]] std::string to_text(const RecordingCheck& check);

}  // namespace surefoot::checks
