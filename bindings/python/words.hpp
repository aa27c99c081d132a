// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Choices by their names, as on the command line.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace surefoot::python {

/// The choice of a name. Throws std::invalid_argument naming the ones there are.
template <typename Names>
auto choice_of(const Names& names, std::string_view option, std::string_view given) {
  std::string known;
  for (const auto& [name, choice] : names) {
    if (name == given) return choice;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  throw std::invalid_argument(std::string(option) + ": got '" + std::string(given) +
                              "', expected one of: " + known);
}

}  // namespace surefoot::python
