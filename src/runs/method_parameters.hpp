// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Setting a parameter that the method does not read changes nothing, which whoever sets it does not
// expect.
#pragma once

#include <string_view>

#include "surefoot/config.hpp"

namespace surefoot::runs {

/// Throws ConfigError naming the methods that read the parameter if config.method does not. What
/// nobody reads does not exist, which set_parameter() says better.
void require_parameter(const Config& config, std::string_view parameter);

}  // namespace surefoot::runs
