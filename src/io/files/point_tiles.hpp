// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Points as 3D Tiles: a tree of cubes, each half as wide and twice as dense as the one it lies in,
// so that a viewer loads what it shows.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <span>

namespace surefoot::io {

/// Where a map lies on the earth (WGS84).
struct EarthPlace {
  double latitude_deg = 0.0, longitude_deg = 0.0;
  double height = 0.0;        ///< of the map's origin above the ellipsoid [m]
  double azimuth_deg = 90.0;  ///< of the map's x axis, clockwise from north
};

/// Column by column, from the map's frame, z up, to the earth-centred one [m].
[[nodiscard]] Eigen::Matrix4d T_earth_map(const EarthPlace& place);

struct TileCounts {
  std::size_t tiles = 0;
  std::size_t points = 0;
  int levels = 0;
};

/// Tiles have a folder of their own: throws WriteError where something else has its name. To be
/// called before all the work.
void require_tiles_folder(const std::filesystem::path& folder);

/// Writes `folder`/tileset.json (3D Tiles 1.1) and a binary glTF per tile. A tile holds the points
/// that those above it do not (additive refinement), each point stands in one. `points`: [m] from
/// `origin`, in another order afterwards: brought into that of the tiles in place, so they may well
/// be a file's. No more than one tile is held besides them. Throws WriteError,
/// std::invalid_argument where there is no point or one that is not finite.
TileCounts write_point_tiles(const std::filesystem::path& folder, const Eigen::Vector3d& origin,
                             std::span<Eigen::Vector3f> points,
                             const std::optional<EarthPlace>& place = {});

}  // namespace surefoot::io
