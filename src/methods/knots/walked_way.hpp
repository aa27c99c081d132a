// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// Where the sensor was within reach of the map: how high it stands at a place, and which way is up
/// there. One who was carried stands on the same ground. Its poses are an upright carrier's:
/// however the LiDAR is mounted, their z axis is up where the ground is level.
class WalkedWay {
 public:
  /// Begins anew. In a map that is not levelled, which is as tilted as the sensor was, a slope may
  /// rise as stairs do: no way there is known to lead to another storey.
  void begin(const Pose& T_map_carrier, bool is_levelled);
  void add(const Pose& T_map_carrier);
  void remove_far(const Eigen::Vector3d& sensor, double reach);

  /// The poses at a place in the plane, turned by `yaw` about their own up, of a sensor that stands
  /// on the ground where it stood nearest to there: one, or one a storey where ways cross. It must
  /// have stood somewhere.
  [[nodiscard]] std::vector<Pose> stands_at(const Eigen::Vector2d& place, double yaw) const;
  /// That of them whose height is nearest to the place's.
  [[nodiscard]] Pose stand_at(const Eigen::Vector3d& place, double yaw) const;
  /// Where it stood, the last place first, none nearer than so much to one before [m].
  [[nodiscard]] std::vector<Eigen::Vector3d> places_apart(double distance) const;
  /// Whether it led over itself or up a flight of stairs so near to a place in the plane [m].
  [[nodiscard]] bool has_storeys(const Eigen::Vector3d& place, double within) const;
  /// How much higher it ends than it was some metres, a flight and its landing, before [m]: above
  /// zero for who climbs, below for who goes down, zero where neither is sure.
  [[nodiscard]] double climb_of_late() const;

 private:
  struct Stand {
    Eigen::Vector3d position;
    Eigen::Vector3d up;  // of the ground: the gait's swing is averaged away
  };

  static Pose on_ground_of(const Stand& stand, const Eigen::Vector2d& place, double yaw);

  std::vector<Stand> stands_;                     // about one a metre
  std::vector<Eigen::Vector3d> lately_;           // closer, also where it had been before
  Eigen::Vector3d up_ = Eigen::Vector3d::Zero();  // fading mean
  bool is_levelled_ = true;
};

}  // namespace surefoot
