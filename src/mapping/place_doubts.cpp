// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot::mapping {

namespace {

constexpr std::size_t kEnoughKnown = 100;  // points

double share(std::size_t part, std::size_t all, std::size_t least) {
  return all < least ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

struct Sightings {
  std::size_t missing = 0;
  std::size_t known = 0;

  void add(Outlook::Sight sight) {
    known += sight != Outlook::Sight::unknown ? 1 : 0;
    missing += sight == Outlook::Sight::missing ? 1 : 0;
  }
};

bool is_wall(const Gaussian* surface) {
  return surface != nullptr && surface->counted == 1 && !surface->level;
}

/// [m] From a place, seen in this direction (to the eye), to the nearest wall that runs the same
/// way.
double to_wall(const RegistrationSubmap& walls, const Eigen::Vector3d& place,
               const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye) {
  constexpr double kParallel = 0.97;
  constexpr double kStep = 0.25;  // half a small cube
  constexpr int kSteps = 6;
  double nearest = std::numeric_limits<double>::infinity();
  for (int step = -kSteps; step <= kSteps; ++step) {
    const Eigen::Vector3d at = place + step * kStep * normal;
    for (const std::size_t level : {2U, 1U}) {
      const Gaussian* wall = walls.grid(level).inside(at);
      if (!is_wall(wall) || wall->other_side(to_eye)) continue;
      if (std::abs(wall->across[0].dot(normal)) < kParallel) continue;
      nearest = std::min(nearest, std::abs(wall->across[0].dot(place - wall->mean)));
    }
  }
  return nearest;
}

}  // namespace

double missing_in(const Outlook& outlook, const RegistrationSubmap& seen,
                  const Pose& T_outlook_seen) {
  constexpr double kFarOff = 30.0;    // [m]
  constexpr double kFarCounts = 0.5;  // of right places 0.04 of it was missing at most
  // So many points are taken to be seen there anyway: some that are missing are no house.
  constexpr std::size_t kFewFar = 20;
  Sightings all, far;
  for (const SubmapPoint& point : seen.standing()) {
    const Gaussian* surface = seen.grid(2).inside(point.at);
    if (surface == nullptr) surface = seen.grid(1).inside(point.at);
    if (!is_wall(surface)) continue;  // leaves and wires are met by some beams only
    const Eigen::Vector3d at = T_outlook_seen * point.at;
    const Outlook::Sight sight = outlook.at(at);
    all.add(sight);
    if ((at - outlook.eye()).norm() > kFarOff) far.add(sight);
  }
  return std::max(share(all.missing, all.known, kEnoughKnown),
                  kFarCounts * share(far.missing, far.known + kFewFar, kFewFar));
}

double beside_walls(const RegistrationSubmap& other, const RegistrationSubmap& seen,
                    const Pose& T_other_seen) {
  constexpr double kOn = 0.2;       // [m]
  constexpr double kBeside = 0.25;  // [m]
  constexpr double kFar = 1.5;      // [m]
  const Eigen::Matrix3d R = T_other_seen.rotation.toRotationMatrix();
  std::size_t on = 0;
  std::size_t beside = 0;
  for (const SubmapPoint& point : seen.standing()) {
    const Gaussian* own = seen.grid(2).inside(point.at);
    if (!is_wall(own)) continue;
    const double apart =
        to_wall(other, T_other_seen * point.at, R * own->across[0], R * point.to_eye);
    on += apart <= kOn ? 1 : 0;
    beside += apart > kBeside && apart < kFar ? 1 : 0;
  }
  return share(beside, on + beside, kEnoughKnown);
}

}  // namespace surefoot::mapping
