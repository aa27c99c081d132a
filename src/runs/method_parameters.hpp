// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which of all parameters a method reads. Setting another one changes nothing, which whoever sets
// it does not expect.
#pragma once

#include <string>
#include <string_view>

#include "surefoot/config.hpp"

namespace surefoot::runs {

[[nodiscard]] bool reads_parameter(Method method, std::string_view parameter);

/// Throws ConfigError naming the methods that read the parameter if this one does not.
void require_parameter(Method method, std::string_view parameter);

}  // namespace surefoot::runs
