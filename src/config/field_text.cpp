// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/field_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace surefoot {

namespace {

template <typename Number>
std::string shortest_text(Number value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

[[noreturn]] void refuse(const ConfigField& field, Config& config, std::string_view value) {
  const std::string unit = *field.unit ? " " + std::string(field.unit) : "";
  throw ConfigError("parameter " + std::string(field.name) + ": got '" + std::string(value) +
                    "', expected " + range_text(field, config) + unit + " (" + field.help + ")");
}

/// False if the text is no number, or none in the field's range.
template <typename Number>
bool assign_number(const ConfigField& field, std::string_view text, Number& slot) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return false;
  const auto number = static_cast<double>(value);
  if (!std::isfinite(number) || number < field.min || number > field.max) return false;
  slot = value;
  return true;
}

bool assign_word(std::string_view text, const WordSlot& slot) {
  const auto found = std::find(slot.words.begin(), slot.words.end(), text);
  if (found == slot.words.end()) return false;
  slot.set(slot.value, static_cast<std::size_t>(found - slot.words.begin()));
  return true;
}

}  // namespace

std::string number_text(double value) { return shortest_text(value); }
std::string number_text(int value) { return shortest_text(value); }

std::string range_text(const ConfigField& field, Config& config) {
  const FieldSlot slot = field.slot(config);
  const auto* choice = std::get_if<WordSlot>(&slot);
  if (std::holds_alternative<int*>(slot)) {  // written as they are read
    return number_text(static_cast<int>(field.min)) + " .. " +
           number_text(static_cast<int>(field.max));
  }
  if (choice == nullptr) return number_text(field.min) + " .. " + number_text(field.max);
  std::string text;
  for (const char* word : choice->words) text += (text.empty() ? "" : " | ") + std::string(word);
  return text;
}

std::string value_text(const ConfigField& field, Config& config) {
  const FieldSlot slot = field.slot(config);
  if (const auto* number = std::get_if<double*>(&slot)) return number_text(**number);
  if (const auto* number = std::get_if<int*>(&slot)) return number_text(**number);
  const auto& choice = std::get<WordSlot>(slot);
  const std::size_t word = choice.get(choice.value);
  return word < choice.words.size() ? choice.words[word] : "?";
}

void assign(const ConfigField& field, Config& config, std::string_view text) {
  const FieldSlot slot = field.slot(config);
  bool assigned = false;
  if (const auto* number = std::get_if<double*>(&slot)) {
    assigned = assign_number(field, text, **number);
  } else if (const auto* whole = std::get_if<int*>(&slot)) {
    assigned = assign_number(field, text, **whole);
  } else {
    assigned = assign_word(text, std::get<WordSlot>(slot));
  }
  if (!assigned) refuse(field, config, text);
}

}  // namespace surefoot
