// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a map holds as triangles: for simulators, for planners, to look at.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "mapping/piece.hpp"

namespace surefoot::mapping {

struct SurfaceMesh {
  std::vector<Eigen::Vector3d> vertices;  ///< [m] the map's frame
  /// Anticlockwise, looked at from the side that was seen.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct MeshOptions {
  double cell = 0.2;    ///< edges are about as long [m]
  double block = 50.0;  ///< the map is meshed in blocks of this side, one after the other [m]
};
/// Told after each block: how many of how many are done.
using MeshProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Surfaces of pieces that lie where they belong: floors, walls, whatever is smooth within half a
/// metre; where nothing was seen it is open. A surface of signed distances (SignedDistance) by
/// naive surface nets (Gibson, Constrained elastic surface nets, MICCAI 1998): a vertex in each
/// cell that the surface goes through. The same for any size of blocks, but for the order.
[[nodiscard]] SurfaceMesh draw_mesh(const std::vector<Piece>& pieces, const MeshOptions& options,
                                    const MeshProgress& progress = {});

}  // namespace surefoot::mapping
