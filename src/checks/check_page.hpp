// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checks/recording_check.hpp"

namespace surefoot::checks {

/// A page of its own, without scripts: the verdict, what was found, and the scans drawn one by one.
[[nodiscard]] std::string to_html(const RecordingCheck& check, const std::string& name);

}  // namespace surefoot::checks
