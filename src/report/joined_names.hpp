// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace surefoot::report {

/// Of weak directions or stages, between blanks.
template <typename Named>
[[nodiscard]] std::string joined_names(const Named& all) {
  std::string names;
  for (const auto& one : all) {
    if (!names.empty()) names += ' ';
    names += one.name;
  }
  return names;
}

}  // namespace surefoot::report
