// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a measurement was made on.
#pragma once

#include <string>

namespace surefoot::process {

[[nodiscard]] std::string processor_name();
[[nodiscard]] int processor_cores();

}  // namespace surefoot::process
