// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Points that lie on a surface, each with the normal of what it lies on, towards who saw it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/voxel_table.hpp"

namespace surefoot::mapping {

struct OrientedPoint {
  Eigen::Vector3d place;   ///< [m]
  Eigen::Vector3d normal;  ///< unit; to the side from which it was seen
};

/// Thins what is seen again and again, and finds what it lies on. Leaves, wires and poles lie on no
/// surface and are left out, and so is what was seen so flatly that its side is not told.
class PointOrientation {
 public:
  /// `cube`: points of a cube of this side [m] that were seen from about the same side become one.
  /// `radius`: a surface is what lies within it [m].
  PointOrientation(double cube, double radius);

  void add(const Eigen::Vector3d& place, const Eigen::Vector3d& eye);
  /// Of all that was added, in the order in which their cubes were first met.
  [[nodiscard]] std::vector<OrientedPoint> oriented();

 private:
  struct Seen {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();   // sum, then mean
    Eigen::Vector3d to_eye = Eigen::Vector3d::Zero();  // sum of unit vectors
    std::size_t count = 0;
  };
  /// What lies about the point that is asked for.
  struct Near {
    Eigen::Vector3d from_point;  // [m]
    Eigen::Vector3d to_eye;
    double weight;  // by how near it is
  };
  struct Plane {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // from the point
    double support = 0.0;   // share of what lies near, on the point's side, that lies on it
    bool extended = false;  // along two directions, as a pole is not
  };

  void gather(const Seen& point);
  [[nodiscard]] Plane fit(const Eigen::Vector3d& to_eye, const Plane& before) const;
  [[nodiscard]] Plane surface_at(const Seen& point);

  double cube_, radius_;
  VoxelTable cubes_;
  std::vector<Seen> seen_;
  VoxelTable buckets_;                                 // of the radius' side
  std::vector<std::vector<std::uint32_t>> in_bucket_;  // of each: whose mean lies in it
  std::vector<Near> near_;
};

}  // namespace surefoot::mapping
