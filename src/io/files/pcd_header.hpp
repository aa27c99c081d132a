// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_table.hpp"

namespace surefoot::io {

enum class PcdData { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t count = 1;   ///< elements a point
  std::size_t offset = 0;  ///< from the point's first byte [bytes]
};

/// The text part of a PCD 0.7 file. COUNT, HEIGHT, VIEWPOINT and POINTS may be missing.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::size_t point_step = 0;  ///< [bytes] of one point in binary data
  PcdData data = PcdData::ascii;
  std::size_t lines = 0;        ///< of the header
  std::size_t data_offset = 0;  ///< where the data begin [bytes]
};

/// Throws ReadError naming the line. No number in the header is believed beyond the text's own
/// size.
[[nodiscard]] PcdHeader parse_pcd_header(std::string_view file);

}  // namespace surefoot::io
