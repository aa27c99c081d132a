// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Choices by their names, and numbers in their ranges, as on the command line.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "io/option_ranges.hpp"

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

/// Throws std::invalid_argument for a number that is not in its range, as NaN is in none.
inline void require_within(const char* option, double given, const io::NumberRange& range) {
  if (given >= range.low && given <= range.high) return;
  const auto text = [](double number) {
    return pybind11::str("{:g}").attr("format")(number).cast<std::string>();
  };
  throw std::invalid_argument(std::string(option) + ": got " + text(given) + ", expected " +
                              text(range.low) + " .. " + text(range.high));
}

}  // namespace surefoot::python
