// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The turning part of a spinning LiDAR. Its frame is the LiDAR's, turned clockwise seen from above.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/sine_cosine.hpp"

namespace surefoot::simulation {

/// R_lidar_rotor at one azimuth, without a matrix's zeros and ones.
class Rotor {
 public:
  Rotor() = default;
  /// @param azimuth clockwise [rad].
  explicit Rotor(double azimuth) : azimuth_(azimuth) {}
  explicit Rotor(const SineCosine& azimuth) : azimuth_(azimuth) {}

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {azimuth_.cosine * v.x() + azimuth_.sine * v.y(),
            azimuth_.cosine * v.y() - azimuth_.sine * v.x(), v.z()};
  }
  /// R_map_rotor of R_map_lidar.
  [[nodiscard]] Eigen::Matrix3d after(const Eigen::Matrix3d& R_map_lidar) const {
    Eigen::Matrix3d R_map_rotor;
    R_map_rotor.col(0) = azimuth_.cosine * R_map_lidar.col(0) - azimuth_.sine * R_map_lidar.col(1);
    R_map_rotor.col(1) = azimuth_.sine * R_map_lidar.col(0) + azimuth_.cosine * R_map_lidar.col(1);
    R_map_rotor.col(2) = R_map_lidar.col(2);
    return R_map_rotor;
  }

 private:
  SineCosine azimuth_;
};

/// Time since the turn began: std::fmod(time_ns, turn_ns) without its loop. Exact for times that
/// are not negative and turns of whole nanoseconds.
[[nodiscard]] inline double within_turn(double time_ns, double turn_ns) {
  const auto turns = static_cast<double>(static_cast<std::int64_t>(time_ns / turn_ns));
  const double rest = time_ns - turns * turn_ns;
  return rest < 0.0 ? rest + turn_ns : rest;  // the quotient was rounded up to a whole turn
}

}  // namespace surefoot::simulation
