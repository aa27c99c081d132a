// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/information.hpp"

#include <cmath>
#include <numbers>

#include "geometry/decompositions.hpp"

namespace surefoot {

namespace {

std::vector<DegenerateDirection> weak_directions(const NormalEquations<6>& equations,
                                                 double squared_distance, const Pose& T_map_lidar,
                                                 double min_information) {
  // Rotations in metres at the matches' RMS distance, so that all six compare.
  const double weight = std::max(equations.weight, 1e-12);
  const double lever = std::max(std::sqrt(squared_distance / weight), 1e-3);
  Twist scale = Twist::Ones();
  scale.tail<3>().setConstant(1.0 / lever);
  const Matrix6 H = scale.asDiagonal() * equations.H * scale.asDiagonal();
  const SymmetricEigen<6> eigen = symmetric_eigen(H);
  std::vector<DegenerateDirection> weak;
  for (int i = 0; i < 6; ++i) {
    // Normals spread evenly over the sphere give each translation a third of the weight.
    const double share = 3.0 * eigen.values[i] / weight;
    if (share >= min_information) break;
    const Twist direction = eigen.vectors.col(i);
    weak.push_back({direction, std::max(share, 0.0), {}});
  }
  name_directions(T_map_lidar, weak);
  return weak;
}

constexpr const char* kNames[] = {"forward", "lateral", "up", "roll", "pitch", "yaw"};

/// Sizes of a direction's parts, in axes turned by the sensor's heading.
Twist parts_of(const Twist& direction, const Pose& T_map_lidar) {
  const double yaw = roll_pitch_yaw(T_map_lidar.rotation).z();
  const Eigen::Matrix3d to_heading =
      Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Twist turned;
  turned << to_heading * direction.head<3>(), to_heading * direction.tail<3>();
  return turned.cwiseAbs();
}

}  // namespace

std::string name_direction(const Twist& direction, const Pose& T_map_lidar) {
  Eigen::Index largest = 0;
  parts_of(direction, T_map_lidar).maxCoeff(&largest);
  return kNames[largest];
}

/// Directions that are equally weak are mixed as it happens, so that several may have the same
/// largest part.
void name_directions(const Pose& T_map_lidar, std::vector<DegenerateDirection>& directions) {
  Twist taken = Twist::Zero();
  for (DegenerateDirection& direction : directions) {
    Eigen::Index largest = 0;
    (parts_of(direction.direction, T_map_lidar) - taken).maxCoeff(&largest);
    taken[largest] = 2.0;  // more than any part, as directions are of length one
    direction.name = kNames[largest];
  }
}

Matrix6 unregistered_covariance(const Config::Health& config) {
  const double angle = config.max_correction_deg * std::numbers::pi / 180.0;
  Twist variances;
  variances.head<3>().setConstant(config.max_correction * config.max_correction);
  variances.tail<3>().setConstant(angle * angle);
  return variances.asDiagonal();
}

void report_weak_directions(const NormalEquations<6>& equations, double squared_distance,
                            const Pose& T_map_lidar, const Config::Health& config,
                            Estimate& estimate) {
  estimate.degenerate =
      weak_directions(equations, squared_distance, T_map_lidar, config.min_information);
  if (estimate.degenerate.empty()) return;
  estimate.status = Status::degenerate;
  estimate.message = "the scan hardly constrains:";
  for (const DegenerateDirection& weak : estimate.degenerate) estimate.message += ' ' + weak.name;
}

}  // namespace surefoot
