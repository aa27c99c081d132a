// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checks/recording_check.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

/// As JSON; of bytes in file names that are no UTF-8, U+FFFD.
[[nodiscard]] std::string to_json(const io::RecordingSummary& summary);
/// Everything that was found, without the scans one by one.
[[nodiscard]] std::string to_json(const RecordingCheck& check);

}  // namespace surefoot::checks
