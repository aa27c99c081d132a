// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// Where the sensor was within reach of the map: how high it stands at a place, and which way is up
/// there. One who was carried stands on the same ground.
class WalkedWay {
 public:
  void add(const Pose& T_map_lidar);
  void remove_far(const Eigen::Vector3d& sensor, double reach);
  void clear();

  /// The pose over or under a place, turned by `yaw` about its own up, of a sensor that stands on
  /// the ground where it stood nearest to there. It must have stood somewhere.
  [[nodiscard]] Pose stand_at(const Eigen::Vector3d& place, double yaw) const;

 private:
  struct Stand {
    Eigen::Vector3d position;
    Eigen::Vector3d up;  // of the ground: the gait's swing is averaged away
  };

  std::vector<Stand> stands_;                     // about one a metre
  Eigen::Vector3d up_ = Eigen::Vector3d::Zero();  // fading mean
};

}  // namespace surefoot
