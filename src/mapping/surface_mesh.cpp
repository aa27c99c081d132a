// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/surface_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mapping/signed_distance.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kSurfaceRadius = 0.5;  // what a point's surface is told by [m]
constexpr std::uint32_t kNoVertex = VoxelTable::kNone;

/// Corner k of the cell whose lowest one this is.
VoxelIndex corner_of(const VoxelIndex& cell, int k) {
  return cell + VoxelIndex(k & 1, k >> 1 & 1, k >> 2 & 1);
}

/// A part of the map seen from above: columns of corners from the lowest to below the highest.
struct Block {
  Eigen::Vector2i low, high;
  [[nodiscard]] bool holds(const VoxelIndex& corner) const {
    return corner.x() >= low.x() && corner.x() < high.x() && corner.y() >= low.y() &&
           corner.y() < high.y();
  }
};

/// Where the surface goes through a cell: the mean of where it cuts the cell's edges; none if it
/// does not, or if the distance is not known at all corners.
std::optional<Eigen::Vector3d> vertex_in(const SignedDistance& field, const VoxelIndex& cell,
                                         double size) {
  std::array<double, 8> distances{};
  for (int k = 0; k < 8; ++k) {
    distances[static_cast<std::size_t>(k)] = field.at(corner_of(cell, k));
    if (std::isnan(distances[static_cast<std::size_t>(k)])) return std::nullopt;
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int cuts = 0;
  for (int k = 0; k < 8; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const int other = k | 1 << axis;
      const double here = distances[static_cast<std::size_t>(k)];
      const double there = distances[static_cast<std::size_t>(other)];
      if (other == k || (here < 0.0) == (there < 0.0)) continue;
      sum +=
          corner_of(cell, k).cast<double>() + here / (here - there) * Eigen::Vector3d::Unit(axis);
      ++cuts;
    }
  }
  if (cuts == 0) return std::nullopt;
  return size * sum / cuts;
}

class Mesher {
 public:
  explicit Mesher(double cell) : cell_(cell) {}

  void add_block(const SignedDistance& field, const Block& block) {
    inner_.clear();
    for (const VoxelIndex& corner : field.corners()) {
      if (!block.holds(corner)) continue;
      for (int axis = 0; axis < 3; ++axis) add_faces(field, block, corner, axis);
    }
  }

  SurfaceMesh mesh;

 private:
  /// The two triangles across the edge from a corner along an axis, if the surface cuts it.
  void add_faces(const SignedDistance& field, const Block& block, const VoxelIndex& corner,
                 int axis) {
    const double here = field.at(corner);
    const double there = field.at(corner + VoxelIndex::Unit(axis));
    if (std::isnan(here) || std::isnan(there) || (here < 0.0) == (there < 0.0)) return;
    const VoxelIndex across = VoxelIndex::Unit((axis + 1) % 3);
    const VoxelIndex onward = VoxelIndex::Unit((axis + 2) % 3);
    // Anticlockwise about the axis.
    const std::array<VoxelIndex, 4> cells = {corner - across - onward, corner - onward, corner,
                                             corner - across};
    std::array<std::uint32_t, 4> ring{};
    if (!find_vertices(field, block, cells, ring)) return;
    if (here > 0.0) std::reverse(ring.begin(), ring.end());
    mesh.triangles.push_back({ring[0], ring[1], ring[2]});
    mesh.triangles.push_back({ring[0], ring[2], ring[3]});
  }

  /// False where a cell has none; then none is made for the others, which may be of no triangle.
  bool find_vertices(const SignedDistance& field, const Block& block,
                     const std::array<VoxelIndex, 4>& cells, std::array<std::uint32_t, 4>& ring) {
    std::array<std::optional<Eigen::Vector3d>, 4> fresh;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ring[i] = known_in(block, cells[i]).find(voxel_key(cells[i]));
      if (ring[i] != kNoVertex) continue;
      fresh[i] = vertex_in(field, cells[i], cell_);
      if (!fresh[i]) return false;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!fresh[i]) continue;
      ring[i] = static_cast<std::uint32_t>(mesh.vertices.size());
      known_in(block, cells[i]).find_or_insert(voxel_key(cells[i]), ring[i]);
      mesh.vertices.push_back(*fresh[i]);
    }
    return true;
  }

  /// Blocks share the vertices of cells at their borders, others are forgotten with the block.
  VoxelTable& known_in(const Block& block, const VoxelIndex& cell) {
    const bool inside =
        block.holds(cell - VoxelIndex(1, 1, 0)) && block.holds(cell + VoxelIndex(1, 1, 0));
    return inside ? inner_ : border_;
  }

  double cell_;
  VoxelTable inner_, border_;
};

/// [m] Of points beyond a block's border those that its border's distances and normals hang on: a
/// cell, its corners' reach, what the planes there are fitted to, and that thinned over whole
/// cubes.
double margin_of(double cell) { return 4.0 * cell + kSurfaceRadius; }

Eigen::Vector2d along_ground(const Piece& piece, const Eigen::Vector3f& point) {
  return (piece.T_world_piece * point.cast<double>()).head<2>();
}

/// What of the pieces lies in a block or near it.
SignedDistance distances_about(const std::vector<Piece>& pieces,
                               const std::vector<std::size_t>& chosen, const Block& block,
                               double cell) {
  const Eigen::Array2d low = cell * block.low.cast<double>().array() - margin_of(cell);
  const Eigen::Array2d high = cell * block.high.cast<double>().array() + margin_of(cell);
  PointOrientation orientation(cell, kSurfaceRadius);
  for (const std::size_t i : chosen) {
    const Piece& piece = pieces[i];
    const auto cloud = cloud_of(piece);
    for (std::size_t k = 0; k < cloud->points.size(); ++k) {
      const Eigen::Vector3d place = piece.T_world_piece * cloud->points[k].cast<double>();
      const Eigen::Array2d on_ground = place.head<2>().array();
      if ((on_ground < low).any() || (on_ground > high).any()) continue;
      const Eigen::Vector3f& eye = cloud->eyes[cloud->seen_from[k]];
      orientation.add(place, piece.T_world_piece * eye.cast<double>());
    }
  }
  SignedDistance field(cell);
  for (const OrientedPoint& point : orientation.oriented()) field.add(point);
  return field;
}

/// Blocks by their place, each with the pieces from which something in it or near it was seen.
std::map<std::pair<int, int>, std::vector<std::size_t>> blocks_of(const std::vector<Piece>& pieces,
                                                                  double size, double margin) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> blocks;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Eigen::AlignedBox2d box;
    const auto cloud = cloud_of(pieces[i]);
    for (const Eigen::Vector3f& point : cloud->points) box.extend(along_ground(pieces[i], point));
    if (box.isEmpty()) continue;
    const Eigen::Array2d low = ((box.min().array() - margin) / size).floor();
    const Eigen::Array2d high = ((box.max().array() + margin) / size).floor();
    for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x) {
      for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y) {
        blocks[{x, y}].push_back(i);
      }
    }
  }
  return blocks;
}

}  // namespace

SurfaceMesh draw_mesh(const std::vector<Piece>& pieces, const MeshOptions& options,
                      const MeshProgress& progress) {
  const int side = std::max(4, static_cast<int>(std::lround(options.block / options.cell)));
  Mesher mesher(options.cell);
  const auto blocks = blocks_of(pieces, side * options.cell, margin_of(options.cell));
  std::size_t done = 0;
  for (const auto& [place, chosen] : blocks) {
    const Eigen::Vector2i low(side * place.first, side * place.second);
    const Block block{low, low + Eigen::Vector2i(side, side)};
    mesher.add_block(distances_about(pieces, chosen, block, options.cell), block);
    if (progress) progress(++done, blocks.size());
  }
  return std::move(mesher.mesh);
}

}  // namespace surefoot::mapping
