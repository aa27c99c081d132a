// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Numbers of things as they are said.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace surefoot::io {

/// "1 scan", "2 scans".
[[nodiscard]] inline std::string counted(std::size_t number, std::string_view thing) {
  return std::to_string(number).append(" ").append(thing).append(number == 1 ? "" : "s");
}

}  // namespace surefoot::io
