// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checks/recording_check.hpp"

namespace surefoot::checks {

/// Everything that was found, without the scans one by one.
[[nodiscard]] std::string to_json(const RecordingCheck& check);

}  // namespace surefoot::checks
