// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/point_table.hpp"

#include <array>

namespace surefoot::io {
namespace {

struct TypeFacts {
  std::size_t size;
  const char* name;
};
// In the order of ScalarType.
constexpr std::array<TypeFacts, 10> kTypes = {{{1, "i8"},
                                               {1, "u8"},
                                               {2, "i16"},
                                               {2, "u16"},
                                               {4, "i32"},
                                               {4, "u32"},
                                               {8, "i64"},
                                               {8, "u64"},
                                               {4, "f32"},
                                               {8, "f64"}}};

}  // namespace

std::size_t size_of(ScalarType type) { return kTypes[static_cast<std::size_t>(type)].size; }

const char* name_of(ScalarType type) { return kTypes[static_cast<std::size_t>(type)].name; }

const Column* PointTable::find(std::string_view name) const {
  for (const Column& column : columns) {
    if (column.name == name) {
      return &column;
    }
  }
  return nullptr;
}

std::string PointTable::layout() const {
  std::string text = format + ":";
  for (const Column& column : columns) {
    text += (&column == &columns.front() ? " " : ", ") + column.name + " " + name_of(column.type);
  }
  return text;
}

}  // namespace surefoot::io
