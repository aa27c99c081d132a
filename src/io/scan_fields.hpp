// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fields that points are written with, whatever the format: those of a scan, and those that a
// recording has besides.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/point_table.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// A field of a recording that a Scan has no room for.
struct FurtherField {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t count = 1;          ///< numbers of each point
  std::vector<std::byte> values;  ///< point after point, in this machine's byte order
};

/// Of a table's points in `kept` (empty: all), the columns that are not in `used`. Of several that
/// share bytes there is one, so that they take no more than the table does; the names of the others
/// go to `left_out`, where it is not null.
[[nodiscard]] std::vector<FurtherField> further_fields(
    const PointTable& table, std::span<const Column* const> used,
    const std::vector<std::size_t>& kept, std::vector<std::string>* left_out = nullptr);

/// x y z of points [m].
[[nodiscard]] std::vector<Column> coordinate_columns(std::span<const Eigen::Vector3f> points);

/// x y z f32, and where the scan has them intensity f32, t (ns after the scan's stamp, u32, or i32
/// where some are negative) and ring u16; then the further ones, whose names are made words, and
/// differ. They look into both arguments. Throws std::invalid_argument where arrays differ in
/// length.
[[nodiscard]] std::vector<Column> written_columns(const Scan& scan,
                                                  std::span<const FurtherField> further = {});

/// What a point takes [bytes].
[[nodiscard]] std::size_t point_bytes(std::span<const Column> columns);
/// Point after point, without padding. Columns are in this machine's byte order.
void append_points(std::string& out, std::span<const Column> columns, std::size_t points);
/// A line a point, numbers apart by a blank; floats in the fewest digits that read back the same.
void append_rows_of_text(std::string& out, std::span<const Column> columns, std::size_t points);

}  // namespace surefoot::io
