// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "core/voxel_key.hpp"

namespace surefoot {

/// How a coordinate becomes the index of its cell.
enum class CellRounding {
  down,     ///< floor: all cells are equally large
  to_zero,  ///< a C cast: the cell at zero is twice as wide along each axis
};

/// Index of the cell of `size` [m] that holds a coordinate [m]. Absurdly far coordinates share the
/// outermost cell that voxel_key() tells apart.
[[nodiscard]] inline int cell_index(double coordinate, double size, CellRounding rounding) {
  constexpr double kOutermost = (1 << 20) - 2;
  const double scaled = std::clamp(coordinate / size, -kOutermost, kOutermost);
  const int truncated = static_cast<int>(scaled);
  if (rounding == CellRounding::to_zero) return truncated;
  return truncated - (static_cast<double>(truncated) > scaled ? 1 : 0);
}

/// What a cell's coordinates lie between [m].
struct CellSpan {
  double low, high;
};
[[nodiscard]] inline CellSpan cell_span(int index, double size, CellRounding rounding) {
  // Rounding to zero, the cell at zero reaches from -size to size.
  const bool down = rounding == CellRounding::down;
  const int low = down || index > 0 ? index : index - 1;
  const int high = down || index >= 0 ? index + 1 : index;
  return {low * size, high * size};
}

[[nodiscard]] inline VoxelIndex cell_index(const Eigen::Vector3d& point, double size,
                                           CellRounding rounding) {
  return {cell_index(point.x(), size, rounding), cell_index(point.y(), size, rounding),
          cell_index(point.z(), size, rounding)};
}

}  // namespace surefoot
