// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a person reads of a recording: a row for each thing, its name first.
#pragma once

#include <string>

#include "checks/recording_check.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

[[nodiscard]] std::string to_text(const io::RecordingSummary& summary);
[[nodiscard]] std::string to_text(const RecordingCheck& check);

}  // namespace surefoot::checks
