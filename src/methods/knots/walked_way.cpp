// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/walked_way.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace surefoot {

namespace {

constexpr double kApart = 1.0;  // [m] between two that are kept
// Heights count twice: another storey is far, however near in the plane.
const Eigen::Vector3d kSteep(1.0, 1.0, 2.0);
constexpr double kRate = 0.1;  // of the mean: a second, which is two strides

}  // namespace

void WalkedWay::add(const Pose& T_map_lidar) {
  const Eigen::Vector3d up = T_map_lidar.rotation * Eigen::Vector3d::UnitZ();
  up_ = stands_.empty() ? up : Eigen::Vector3d(up_ + kRate * (up - up_));
  const Eigen::Vector3d& position = T_map_lidar.translation;
  const bool known = std::any_of(stands_.begin(), stands_.end(), [&](const Stand& stand) {
    return (stand.position - position).squaredNorm() < kApart * kApart;
  });
  if (!known) stands_.push_back({position, up_.normalized()});
}

void WalkedWay::remove_far(const Eigen::Vector3d& sensor, double reach) {
  std::erase_if(stands_, [&](const Stand& stand) {
    return (stand.position - sensor).squaredNorm() > reach * reach;
  });
}

void WalkedWay::clear() { stands_.clear(); }

Pose WalkedWay::stand_at(const Eigen::Vector3d& place, double yaw) const {
  const auto apart = [&](const Stand& stand) {
    return (stand.position - place).cwiseProduct(kSteep).squaredNorm();
  };
  const Stand& nearest =
      *std::min_element(stands_.begin(), stands_.end(),
                        [&](const Stand& a, const Stand& b) { return apart(a) < apart(b); });
  const Eigen::Vector2d aside = (place - nearest.position).head<2>();
  const double rise = -nearest.up.head<2>().dot(aside) / nearest.up.z();
  const Eigen::Quaterniond tilt =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), nearest.up);
  return {tilt * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()),
          {place.x(), place.y(), nearest.position.z() + rise}};
}

}  // namespace surefoot
