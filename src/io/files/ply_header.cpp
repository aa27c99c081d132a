// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/ply_header.hpp"

#include "io/ascii_values.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

using Words = std::vector<std::string_view>;

// No driver's points have as many properties; a header of millions would take gigabytes.
constexpr std::size_t kMostLines = 1000;
constexpr std::size_t kLongestPlyLine = 100'000;

[[noreturn]] void fail_at(std::size_t line, const std::string& what) {
  throw ReadError("PLY header line " + std::to_string(line) + ": " + what);
}

ScalarType ply_scalar_type(std::string_view word, std::size_t line) {
  struct Known {
    std::string_view name, sized_name;
    ScalarType type;
  };
  static constexpr Known kKnown[] = {
      {"char", "int8", ScalarType::i8},      {"uchar", "uint8", ScalarType::u8},
      {"short", "int16", ScalarType::i16},   {"ushort", "uint16", ScalarType::u16},
      {"int", "int32", ScalarType::i32},     {"uint", "uint32", ScalarType::u32},
      {"long", "int64", ScalarType::i64},    {"ulong", "uint64", ScalarType::u64},
      {"float", "float32", ScalarType::f32}, {"double", "float64", ScalarType::f64}};
  for (const Known& known : kKnown) {
    if (word == known.name || word == known.sized_name) {
      return known.type;
    }
  }
  fail_at(line,
          "property type " + in_quotes(word) + "; expected char .. double or int8 .. float64");
}

PlyFormat format_of(const Words& words, std::size_t line) {
  if (words.size() == 3 && words[2] == "1.0") {
    if (words[1] == "ascii") {
      return PlyFormat::ascii;
    }
    if (words[1] == "binary_little_endian") {
      return PlyFormat::little_endian;
    }
    if (words[1] == "binary_big_endian") {
      return PlyFormat::big_endian;
    }
  }
  fail_at(line, "format " + in_quotes(words.size() > 1 ? words[1] : std::string_view{}) +
                    "; expected ascii, binary_little_endian or binary_big_endian, version 1.0");
}

PlyElement element_of(const Words& words, std::size_t line) {
  PlyElement element;
  if (words.size() != 3 || !parse_count(words[2], element.count)) {
    fail_at(line, "expected 'element NAME COUNT'");
  }
  element.name = words[1];
  return element;
}

PlyProperty property_of(const Words& words, std::size_t line) {
  PlyProperty property;
  if (words.size() == 5 && words[1] == "list") {
    property.list_count_type = ply_scalar_type(words[2], line);
    if (is_float(*property.list_count_type)) {
      fail_at(line,
              "a list is counted by " + in_quotes(words[2]) + "; expected a whole number's type");
    }
    property.type = ply_scalar_type(words[3], line);
    property.name = words[4];
    return property;
  }
  if (words.size() != 3) {
    fail_at(line, "expected 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
  }
  property.type = ply_scalar_type(words[1], line);
  property.name = words[2];
  return property;
}

}  // namespace

bool PlyElement::has_lists() const {
  for (const PlyProperty& property : properties) {
    if (property.list_count_type) {
      return true;
    }
  }
  return false;
}

std::size_t PlyElement::scalar_step() const {
  std::size_t step = 0;
  for (const PlyProperty& property : properties) {
    step += property.list_count_type ? 0 : size_of(property.type);
  }
  return step;
}

PlyHeader parse_ply_header(std::string_view file) {
  LineReader reader(file);
  std::string_view line;
  if (!reader.next(line) || line != "ply") {
    throw ReadError("PLY: begins with " + in_quotes(line) + "; expected 'ply'");
  }
  PlyHeader header;
  bool format_given = false;
  std::size_t lines = 0;
  while (reader.next(line)) {
    if (line.size() > kLongestPlyLine || ++lines > kMostLines) {
      fail_at(reader.line_number(),
              "a header of so many lines, or so long ones; expected at most " +
                  std::to_string(kMostLines) + " and " + std::to_string(kLongestPlyLine) +
                  " characters");
    }
    const Words words = words_of(line);
    const std::string_view key = words.empty() ? std::string_view{} : words[0];
    if (key == "format") {
      header.format = format_of(words, reader.line_number());
      format_given = true;
    } else if (key == "element") {
      header.elements.push_back(element_of(words, reader.line_number()));
    } else if (key == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(words, reader.line_number()));
    } else if (key == "end_header" && format_given) {
      header.lines = reader.line_number();
      header.data_offset = reader.offset();
      return header;
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      fail_at(reader.line_number(), in_quotes(key) + " is not expected here");
    }
  }
  throw ReadError("PLY header: " + std::to_string(reader.line_number()) +
                  " lines without 'end_header'");
}

}  // namespace surefoot::io
