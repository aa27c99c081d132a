// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/voxel_table.hpp"
#include "methods/shared/cell_index.hpp"

namespace surefoot {

/// The shifts to a cell and its 26 neighbours, nearest kinds first.
[[nodiscard]] const std::array<VoxelIndex, 27>& neighbour_shifts();

/// The map of KISS-ICP and its descendants: a few points per cell of a grid, searched in a cell and
/// its 26 neighbours. Points beyond those are not found, however near the search may reach.
class VoxelMap {
 public:
  struct Options {
    double voxel_size;     ///< [m]
    int points_per_voxel;  ///< a full cell takes no more
    double min_spacing;    ///< [m] nor one nearer than this to a point of its cell
    double radius;         ///< [m] for remove_far()
    CellRounding rounding = CellRounding::down;
  };

  explicit VoxelMap(const Options& options) : options_(options) {}

  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] bool empty() const { return filled_ == 0; }
  void insert(const Eigen::Vector3d& point);
  /// Empties the cells whose first point is `radius` or farther away.
  void remove_far(const Eigen::Vector3d& sensor);

  /// The nearest point in the query's cell and its neighbours that is nearer than max_distance [m];
  /// null if there is none. Valid until the map changes.
  [[nodiscard]] const Eigen::Vector3d* nearest(const Eigen::Vector3d& query,
                                               double max_distance) const;
  /// The points of one cell.
  [[nodiscard]] std::span<const Eigen::Vector3d> cell(const VoxelIndex& index) const;
  [[nodiscard]] VoxelIndex index_of(const Eigen::Vector3d& point) const {
    return cell_index(point, options_.voxel_size, options_.rounding);
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;

 private:
  struct Cell {
    std::uint64_t key;
    int count;
  };

  [[nodiscard]] std::size_t first_point(std::size_t cell) const {
    return cell * static_cast<std::size_t>(options_.points_per_voxel);
  }
  void drop_empty_cells();

  Options options_;
  VoxelTable table_;
  std::vector<Cell> cells_;              // emptied ones keep their place until they are many
  std::vector<Eigen::Vector3d> points_;  // points_per_voxel places for every cell
  std::size_t filled_ = 0;               // cells that are not empty
};

}  // namespace surefoot
