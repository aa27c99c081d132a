// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Maps for planners, drawn from pieces where they belong after all loops.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "mapping/piece.hpp"

namespace surefoot::mapping {

/// Where a robot of some height can go: cells along the map's axes.
struct OccupancyGrid {
  double cell = 0.1;                              ///< [m]
  Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< the lower left cell's outer corner [m]
  int width = 0, height = 0;
  enum Cell : std::uint8_t { kUnknown, kFree, kOccupied };
  std::vector<std::uint8_t> cells;  ///< row by row, the lowest y first

  [[nodiscard]] std::uint8_t at(int x, int y) const {
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)];
  }
};

struct GridOptions {
  double cell = 0.1;    ///< [m]
  double low = 0.2;     ///< above the ground under the robot: what is lower is stepped over [m]
  double high = 1.2;    ///< what is higher is passed under [m]
  double range = 20.0;  ///< beams tell nothing beyond [m]
};

/// Throws std::invalid_argument if the map would have more than 400 million cells, or has no
/// points.
[[nodiscard]] OccupancyGrid draw_occupancy(const std::vector<Piece>& pieces,
                                           const GridOptions& options);

/// As map_server reads it: an image (PGM, 254 free, 0 occupied, 205 unknown) and its YAML, which
/// has the image's name as it stands.
[[nodiscard]] std::string format_pgm(const OccupancyGrid& grid);
[[nodiscard]] std::string format_grid_yaml(const OccupancyGrid& grid, const std::string& image);

/// Height of the ground, cell by cell, and how far its points scatter.
struct ElevationGrid {
  double cell = 0.2;  ///< [m]
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  int width = 0, height = 0;
  std::vector<float> heights;    ///< row by row, the lowest y first; NaN: not seen
  std::vector<float> variances;  ///< [m^2]
};
/// Of the points below a robot's height above the ground that it walked on. Throws as above.
[[nodiscard]] ElevationGrid draw_elevation(const std::vector<Piece>& pieces, double cell = 0.2);

/// ESRI ASCII grid: GDAL, QGIS and `surefoot simulate` read it.
[[nodiscard]] std::string format_asc(const ElevationGrid& grid, const std::vector<float>& values);

}  // namespace surefoot::mapping
