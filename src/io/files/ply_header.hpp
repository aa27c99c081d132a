// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_table.hpp"

namespace surefoot::io {

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::f32;          ///< of the number, or of a list's items
  std::optional<ScalarType> list_count_type;  ///< set for a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool has_lists() const;
  /// Size of the properties that are no lists [bytes].
  [[nodiscard]] std::size_t scalar_step() const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;        ///< of the header
  std::size_t data_offset = 0;  ///< where the data begin [bytes]
};

/// Throws ReadError naming the line.
[[nodiscard]] PlyHeader parse_ply_header(std::string_view file);

}  // namespace surefoot::io
