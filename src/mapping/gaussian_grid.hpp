// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Points as planes, poles and clouds: what another cloud is registered with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"

namespace surefoot::mapping {

/// What the points of a cube lie on.
struct Gaussian {
  Eigen::Vector3d mean;  ///< [m]
  /// Of a difference from the mean, what counts: along a plane's normal, across a pole; all of it,
  /// with less weight, where it is a cloud. The first `counted` of them, times their weights'
  /// roots.
  std::array<Eigen::Vector3d, 3> across;
  int counted = 1;
  Eigen::Vector3d
      facing;            ///< the mean of unit vectors from its points to where they were seen from
  bool level = false;    ///< a plane that lies: ground, ceiling
  double grazing = 1.0;  ///< cosine of directions that lie so near to a plane, as well as its
                         ///< normal is known, that its side is not told

  /// Whether it is a plane of which something that was seen in this direction (to the eye, unit) is
  /// the other side: a slab from above and from below, a wall from two rooms.
  [[nodiscard]] bool other_side(const Eigen::Vector3d& to_eye) const {
    const double one = across[0].dot(facing);
    const double other = across[0].dot(to_eye);
    return counted == 1 && one * other < 0.0 && std::abs(one) > grazing &&
           std::abs(other) > grazing;
  }
  /// [m^2] of a place from what the points lie on.
  [[nodiscard]] double distance2(const Eigen::Vector3d& place) const {
    double sum = 0.0;
    for (int i = 0; i < counted; ++i) {
      const double part = across[static_cast<std::size_t>(i)].dot(place - mean);
      sum += part * part;
    }
    return sum;
  }
};

/// Cubes of one size, each with its points' Gaussian.
class GaussianGrid {
 public:
  /// `eyes`: of each point, from where it was seen.
  GaussianGrid(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& eyes,
               double size);

  /// The Gaussian of the cube about the place or of the six beside it whose mean is nearest; null
  /// if there is none.
  [[nodiscard]] const Gaussian* find(const Eigen::Vector3d& place) const;
  /// Of the cube about the place alone.
  [[nodiscard]] const Gaussian* inside(const Eigen::Vector3d& place) const;
  [[nodiscard]] double size() const { return size_; }

 private:
  [[nodiscard]] const Gaussian* at(const VoxelIndex& index) const;

  double size_;
  double inverse_size_;
  VoxelTable table_;
  std::vector<Gaussian> gaussians_;
};

}  // namespace surefoot::mapping
