// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// What the map's surface looks like around a place, eqs. (21)-(22).
struct Surface {
  int neighbours = 0;                                 ///< |N_i|
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< n_i, unit length, either sign
  double planarity = 0.0;                             ///< 1 for a plane, 0 for a ball or a line
  double flatness = 0.0;  ///< 1 for a plane, also a long one; 0 for a ball or a line
};

/// The map points nearest to a place, nearest first.
struct Nearby {
  static constexpr int kMost = 6;

  int count = 0;
  std::array<Eigen::Vector3f, kMost> offsets;  ///< from the place to each point [m]
  float clearance = 0.0F;                      ///< all other points are at least this far away [m]
};

/// The map around the sensor: points in cubic voxels, a bounded number in each, with their moments.
///
/// Coordinates come in and go out in the map frame [m]. Inside, each voxel holds its points
/// relative to its own corner, as floats in contiguous x, y and z arrays: precise to 0.1 um
/// wherever the map lies, and ready for vector instructions.
class LocalMap {
 public:
  /// Voxels each way that a search may have to look at.
  static constexpr int kMaxReach = 10;

  /// `max_radius`: the largest that nearby() will be asked for [m], at most kMaxReach voxels.
  LocalMap(const PaperParameters::Map& config, double max_radius);

  /// Adds a point, unless its voxel is full or holds a point nearer than min_spacing.
  void insert(const Eigen::Vector3d& point);
  /// Drops the voxels that lie farther than `radius` [m] from the sensor.
  void remove_far(const Eigen::Vector3d& sensor, double radius);
  void clear();

  /// The points nearer to a place than `radius` [m], or the nearest of them. Exact. A radius beyond
  /// what the map was made for is cut to that; the answer's clearance says how far it holds.
  [[nodiscard]] Nearby nearby(const Eigen::Vector3d& place, double radius) const;

  /// Voxel that holds a place; surface() is the same for all places of one voxel.
  [[nodiscard]] VoxelIndex voxel_of(const Eigen::Vector3d& place) const {
    return voxel_index(place, inverse_size_);
  }
  /// The surface around a voxel: mean and covariance of the points in the 3 x 3 x 3 voxels about
  /// it, eqs. (21)-(22), from the voxels' moments.
  [[nodiscard]] Surface surface(const VoxelIndex& voxel) const;

  [[nodiscard]] std::size_t voxels() const { return voxels_.size(); }
  [[nodiscard]] bool empty() const { return voxels_.empty(); }
  /// All points, map frame [m].
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;

 private:
  class NearestList;
  /// Sums over a voxel's points p, relative to the voxel's corner.
  struct Moments {
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();       // sum of p
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  // sum of p p^T, lower triangle
    void add(const Eigen::Vector3d& p);
    void add(const Moments& other, const Eigen::Vector3d& offset);  // other's corner - ours
  };
  struct Voxel {
    VoxelIndex index;
    Moments moments;
  };
  /// A neighbouring voxel, in the order in which nearby() visits them.
  struct Neighbour {
    VoxelIndex offset;
    float squared_gap;  // least squared distance [m^2] to it from anywhere in the middle voxel
  };

  [[nodiscard]] Eigen::Vector3d corner(const VoxelIndex& index) const {
    return index.cast<double>() * size_;
  }
  [[nodiscard]] std::uint32_t find(const VoxelIndex& index) const {
    return table_.find(voxel_key(index));
  }
  [[nodiscard]] const float* block(std::uint32_t voxel) const {
    return &coordinates_[3 * stride_ * voxel];
  }
  [[nodiscard]] float* block(std::uint32_t voxel) { return &coordinates_[3 * stride_ * voxel]; }
  std::uint32_t voxel_at(const VoxelIndex& index);
  void search_voxel(std::uint32_t voxel, const Eigen::Vector3f& place, NearestList& list) const;
  [[nodiscard]] bool crowded(std::uint32_t voxel, const Eigen::Vector3f& local) const;

  double size_;
  double inverse_size_;
  float min_spacing2_;
  std::uint32_t capacity_;
  std::size_t stride_;                 // capacity, rounded up to whole vectors
  int reach_;                          // voxels to look at each way
  std::vector<Neighbour> neighbours_;  // by rising gap

  std::vector<Voxel> voxels_;
  std::vector<std::uint8_t> counts_;  // points per voxel; apart, since every search reads them
  std::vector<float> coordinates_;    // per voxel: x[stride], y[stride], z[stride]
  VoxelTable table_;
  std::optional<Eigen::Vector3d> cleaned_at_;
};

}  // namespace surefoot
