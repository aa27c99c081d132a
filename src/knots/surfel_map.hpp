// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "odometry/parallel.hpp"
#include "odometry/voxel_key.hpp"
#include "odometry/voxel_table.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// What a voxel's points lie on: a plane (one direction across it) or a pole (two).
struct Surfel {
  int directions = 0;                              ///< 0: neither plane nor pole
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< map frame [m]
  Eigen::Vector3d across[2];                       ///< unit vectors; a plane's: to who sees it
  double variance[2] = {0.0, 0.0};                 ///< of the points along them [m^2]
};

/// The upper triangle of a sum of v v^T, row by row.
using Products = Eigen::Matrix<double, 6, 1>;

/// The map around the sensor at several scales: grids of voxels, each twice as coarse as the one
/// before, each voxel with its points' moments and the surfel fitted to them.
///
/// A wall or a flight of stairs has two sides, a hand apart. A voxel whose plane is later hit from
/// behind keeps those points apart, as its back, and a point is only ever compared with the side
/// that its ray can have hit.
///
/// Where points are dense (a staircase, a corridor) the finest grid answers; far away, or between
/// the LiDAR's rings, a coarser one. So one set of parameters serves every scale of scene.
class SurfelMap {
 public:
  explicit SurfelMap(const Config::Knots& config, double radius);

  /// Where a surfel was found, so that it can be known again without a search.
  struct Place {
    int level = -1;                         ///< -1: no surfel
    int asked = -1;                         ///< the finest level that was asked for
    VoxelIndex voxel = VoxelIndex::Zero();  ///< of the finest level asked
    std::uint32_t index = 0;
  };

  /// The surfel of the finest grid, from `finest` on, whose voxel about a place has one that `ray`
  /// (of any length, from the sensor) can have hit; null if none has. `last` is what the last call
  /// for this point left, and is brought up to date: the map must not change in between.
  [[nodiscard]] const Surfel* find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray,
                                   int finest, Place& last) const;

  /// Adds points [m, map frame] that were seen from `sensor`, then fits the voxels that changed.
  void insert(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& sensor,
              const Workers& workers = Workers(1));
  /// Drops the voxels that lie farther than the radius from the sensor.
  void remove_far(const Eigen::Vector3d& sensor);
  void clear();

  [[nodiscard]] bool empty() const { return grids_.front().moments.empty(); }
  /// The finest grid whose voxels are at least so large [m], or the coarsest.
  [[nodiscard]] int level_of(double size) const;
  /// The means of the finest grid's voxels [m].
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;

 private:
  /// Sums over a voxel's points.
  struct Moments {
    std::uint64_t key = 0;
    VoxelIndex index = VoxelIndex::Zero();
    int count = 0;
    int fitted_at = 0;  // count when the surfel was fitted
    bool stale = false;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();      // from the voxel's corner
    Products products = Products::Zero();               // likewise
    Eigen::Vector3d ray_sum = Eigen::Vector3d::Zero();  // of the rays' directions
    Products rays = Products::Zero();                   // likewise
  };
  /// A voxel's side is one index into three arrays: what is searched, what is added to, and the
  /// little that tells that nothing more is.
  struct Grid {
    double size;
    double inverse_size;
    VoxelTable table;
    std::vector<Surfel> surfels;
    std::deque<Moments> moments;  // the large ones: never copied to grow
    std::vector<bool> full;
    std::vector<std::uint32_t> stale;  // voxels to fit anew
  };

  [[nodiscard]] static std::uint32_t side_of(Grid& grid, const VoxelIndex& index,
                                             const Eigen::Vector3d& ray);
  void add(Grid& grid, const Eigen::Vector3d& point, const Eigen::Vector3d& ray) const;
  [[nodiscard]] Surfel fit(const Moments& moments, double size) const;

  Config::Knots config_;
  double radius_;
  std::vector<Grid> grids_;
  std::optional<Eigen::Vector3d> cleaned_at_;
};

}  // namespace surefoot
