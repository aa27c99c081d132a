// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What PCD and PLY have in common once their text is understood: named columns of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sensors/bytes.hpp"

namespace surefoot::io {

enum class ScalarType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

[[nodiscard]] std::size_t size_of(ScalarType type);
/// "f32", "u16", ...
[[nodiscard]] const char* name_of(ScalarType type);
[[nodiscard]] constexpr bool is_float(ScalarType type) {
  return type == ScalarType::f32 || type == ScalarType::f64;
}

/// A field of every point: the value of point i lies at first + i * stride. Where there are
/// several, the first counts and the others follow it.
struct Column {
  std::string name;
  ScalarType type = ScalarType::f32;
  const std::byte* first = nullptr;
  std::size_t stride = 0;  ///< [bytes]
  bool swapped = false;    ///< stored in the other byte order than this machine's
  std::size_t count = 1;   ///< numbers of every point
};

/// Points as columns. They look into `storage` or into the bytes that the table was parsed from,
/// which must outlive the table. Movable; a copy would look into the original.
struct PointTable {
  PointTable() = default;
  ~PointTable() = default;
  PointTable(PointTable&&) = default;
  PointTable& operator=(PointTable&&) = default;
  PointTable(const PointTable&) = delete;
  PointTable& operator=(const PointTable&) = delete;

  std::size_t size = 0;
  std::vector<Column> columns;
  std::vector<std::byte> storage;
  std::string format;  ///< "PCD binary", "PLY ascii", ...
  std::string lost;    ///< what the file says of its points that the columns do not; mostly empty

  [[nodiscard]] const Column* find(std::string_view name) const;
  /// "PCD binary: x f32, y f32, ...".
  [[nodiscard]] std::string layout() const;
};

/// Calls visitor(i, value) for the values of points 0..count-1, with the value in its stored type.
/// Type and byte order are looked at once, not once a point.
template <typename Visitor>
void for_each_value(const Column& column, std::size_t count, Visitor&& visitor) {
  const auto run = [&]<typename T>(T) {
    const auto in_order = [&](auto swapped) {
      const std::byte* at = column.first;
      for (std::size_t i = 0; i < count; ++i, at += column.stride) visitor(i, load<T>(at, swapped));
    };
    column.swapped ? in_order(std::true_type{}) : in_order(std::false_type{});
  };
  switch (column.type) {
    case ScalarType::i8:
      return run(std::int8_t{});
    case ScalarType::u8:
      return run(std::uint8_t{});
    case ScalarType::i16:
      return run(std::int16_t{});
    case ScalarType::u16:
      return run(std::uint16_t{});
    case ScalarType::i32:
      return run(std::int32_t{});
    case ScalarType::u32:
      return run(std::uint32_t{});
    case ScalarType::i64:
      return run(std::int64_t{});
    case ScalarType::u64:
      return run(std::uint64_t{});
    case ScalarType::f32:
      return run(float{});
    case ScalarType::f64:
      return run(double{});
  }
}

}  // namespace surefoot::io
