// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>

#include "io/scan_fields.hpp"

namespace surefoot::io {

enum class PlyFlavour { ascii, binary };  ///< binary is little-endian

/// PLY 1.0 has no integers of 64 bits; lists, which it has, are not written.
[[nodiscard]] bool fits_ply(const Column& column);
/// Columns that fit, as PLY 1.0.
[[nodiscard]] std::string format_ply(std::span<const Column> columns, std::size_t points,
                                     PlyFlavour flavour);

/// A float of every point.
struct PlyColumn {
  std::string name;
  std::span<const float> values;
};

/// Points [m] and the columns that have values, without any points all of them, as PLY 1.0. Throws
/// std::invalid_argument where a column has values but not as many as there are points.
[[nodiscard]] std::string format_ply(std::span<const Eigen::Vector3f> points,
                                     std::span<const PlyColumn> columns, PlyFlavour flavour);
/// The same with one column at most: intensity.
[[nodiscard]] std::string format_ply(std::span<const Eigen::Vector3f> points,
                                     std::span<const float> intensities, PlyFlavour flavour);
/// Throw WriteError.
void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const PlyColumn> columns);
void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const float> intensities = {}, PlyFlavour flavour = PlyFlavour::binary);

}  // namespace surefoot::io
