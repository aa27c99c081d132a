// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How sharp a map becomes of scans that are laid into it: where the points of each lie beside the
// surfaces that those before have left.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot::checks {

class MapBlur {
 public:
  /// Lays a scan into the map. @returns the mean distance of its points from the planes through
  /// what lay about them before [m]; nothing while there is too little of that.
  std::optional<double> add(const std::vector<Eigen::Vector3f>& points, const Pose& T_world_lidar);

 private:
  struct Moments {
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  };
  [[nodiscard]] std::optional<double> distance(const Eigen::Vector3d& point) const;

  std::unordered_map<std::uint64_t, Moments> cells_;
};

}  // namespace surefoot::checks
