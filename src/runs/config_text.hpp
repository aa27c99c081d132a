// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The parameters to read.
#pragma once

#include <string>

#include "surefoot/config.hpp"

namespace surefoot::runs {

/// What the config's method reads: value, meaning, range, default, source.
[[nodiscard]] std::string config_text(const Config& config);
/// The same as a file for `surefoot run --config`.
[[nodiscard]] std::string config_yaml(const std::string& method, const Config& config);
/// Every parameter there is: docs/config.md.
[[nodiscard]] std::string config_page();

}  // namespace surefoot::runs
