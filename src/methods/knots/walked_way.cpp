// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/walked_way.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

constexpr double kApart = 1.0;  // [m] between two that are kept
constexpr double kRate = 0.1;   // of the mean: a second, which is two strides
// [m] Another storey is so much higher or lower, and its way as near in the plane but for so much.
constexpr double kStorey = 1.2, kBeside = 1.5;
// What rises by so much and is steeper than ground that is walked (28 deg) leads to another storey.
constexpr double kSteep = 0.53;
constexpr double kFlight = 0.8;  // [m] that a short one rises by
constexpr double kClimbs = 0.6;  // [m] of who is on one, or has just left it
// The last places, so near to each other [m] that a short flight has some, however fast it is run
// up.
constexpr std::size_t kLately = 13;
constexpr double kNear = 0.5;

/// Whether a way rises by so much [m], as stairs do.
bool is_steep(const Eigen::Vector3d& way, double rise) {
  return way.z() > rise && way.z() > kSteep * way.head<2>().norm();
}

}  // namespace

void WalkedWay::begin(const Pose& T_map_carrier, bool is_levelled) {
  stands_.clear();
  lately_.clear();
  is_levelled_ = is_levelled;
  add(T_map_carrier);
}

void WalkedWay::add(const Pose& T_map_carrier) {
  const Eigen::Vector3d up = T_map_carrier.rotation * Eigen::Vector3d::UnitZ();
  up_ = stands_.empty() ? up : Eigen::Vector3d(up_ + kRate * (up - up_));
  const Eigen::Vector3d& position = T_map_carrier.translation;
  if (lately_.empty() || (position - lately_.back()).norm() >= kNear) lately_.push_back(position);
  if (lately_.size() > kLately) lately_.erase(lately_.begin());
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

Pose WalkedWay::on_ground_of(const Stand& stand, const Eigen::Vector2d& place, double yaw) {
  const Eigen::Vector2d aside = place - stand.position.head<2>();
  const double rise = -stand.up.head<2>().dot(aside) / stand.up.z();
  const Eigen::Quaterniond tilt =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), stand.up);
  return {tilt * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()),
          {place.x(), place.y(), stand.position.z() + rise}};
}

std::vector<Pose> WalkedWay::stands_at(const Eigen::Vector2d& place, double yaw) const {
  const auto away = [&](const Stand& stand) { return (stand.position.head<2>() - place).norm(); };
  double nearest = std::numeric_limits<double>::max();
  for (const Stand& stand : stands_) nearest = std::min(nearest, away(stand));
  std::vector<const Stand*> beside;
  for (const Stand& stand : stands_) {
    if (away(stand) <= nearest + kBeside) beside.push_back(&stand);
  }
  std::stable_sort(beside.begin(), beside.end(),
                   [&](const Stand* a, const Stand* b) { return away(*a) < away(*b); });
  std::vector<Pose> storeys;
  for (const Stand* stand : beside) {
    const Pose pose = on_ground_of(*stand, place, yaw);
    const bool known = std::any_of(storeys.begin(), storeys.end(), [&](const Pose& other) {
      return std::abs(other.translation.z() - pose.translation.z()) < kStorey;
    });
    if (!known) storeys.push_back(pose);
  }
  return storeys;
}

Pose WalkedWay::stand_at(const Eigen::Vector3d& place, double yaw) const {
  const std::vector<Pose> storeys = stands_at(place.head<2>(), yaw);
  const auto apart = [&](const Pose& storey) {
    return std::abs(storey.translation.z() - place.z());
  };
  return *std::min_element(storeys.begin(), storeys.end(),
                           [&](const Pose& a, const Pose& b) { return apart(a) < apart(b); });
}

std::vector<Eigen::Vector3d> WalkedWay::places_apart(double distance) const {
  std::vector<Eigen::Vector3d> places;
  for (auto stand = stands_.rbegin(); stand != stands_.rend(); ++stand) {
    const bool near = std::any_of(places.begin(), places.end(), [&](const Eigen::Vector3d& place) {
      return (stand->position - place).norm() < distance;
    });
    if (!near) places.push_back(stand->position);
  }
  return places;
}

double WalkedWay::climb_of_late() const {
  if (!is_levelled_) return 0.0;
  const bool stairs = std::any_of(lately_.begin(), lately_.end(), [&](const auto& one) {
    return std::any_of(lately_.begin(), lately_.end(),
                       [&](const auto& other) { return is_steep(other - one, kFlight); });
  });
  if (!stairs) return 0.0;
  const double climb = lately_.back().z() - lately_.front().z();
  return std::abs(climb) > kClimbs ? climb : 0.0;
}

bool WalkedWay::has_storeys(const Eigen::Vector3d& place, double within) const {
  if (!is_levelled_) return false;
  std::vector<const Stand*> near;
  for (const Stand& stand : stands_) {
    if ((stand.position - place).head<2>().norm() <= within) near.push_back(&stand);
  }
  return std::any_of(near.begin(), near.end(), [&](const Stand* one) {
    return std::any_of(near.begin(), near.end(), [&](const Stand* other) {
      return is_steep(other->position - one->position, kStorey);
    });
  });
}

}  // namespace surefoot
