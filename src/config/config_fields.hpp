// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a row of the table of parameters is: name, place in a Config, default, unit, range, help,
// source. Every method has the rows of its own; config_fields() are all of them.
#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "surefoot/config.hpp"

namespace surefoot {

/// A value that is one of some words: a bool or an enum, whatever its type.
struct WordSlot {
  std::span<const char* const> words;
  void* value;
  std::size_t (*get)(const void* value);  ///< which of the words
  void (*set)(void* value, std::size_t word);
};

/// Where a parameter lives in a Config.
using FieldSlot = std::variant<double*, int*, WordSlot>;

[[nodiscard]] inline FieldSlot field_slot(double& value) { return &value; }
[[nodiscard]] inline FieldSlot field_slot(int& value) { return &value; }
[[nodiscard]] FieldSlot field_slot(bool& value);
/// `words`: of the enumerators 0, 1, 2, ...
template <typename Enum>
[[nodiscard]] FieldSlot field_slot(Enum& value, std::span<const char* const> words) {
  return WordSlot{
      words, &value,
      [](const void* at) { return static_cast<std::size_t>(*static_cast<const Enum*>(at)); },
      [](void* at, std::size_t word) { *static_cast<Enum*>(at) = static_cast<Enum>(word); }};
}

struct ConfigField {
  const char* name;
  FieldSlot (*slot)(Config&);
  const char* default_value;
  const char* unit;
  double min, max;  // numbers only
  const char* help;
  const char* source;
};

/// A default's source: chosen by hand.
inline constexpr const char* kChosen = "chosen";

/// What every method may read: of a scan and its level frame, and
[[nodiscard]] std::span<const ConfigField> input_fields();
/// of what a registration is worth.
[[nodiscard]] std::span<const ConfigField> health_fields();

/// All rows, in the order in which they are printed.
[[nodiscard]] const std::vector<ConfigField>& config_fields();

}  // namespace surefoot
