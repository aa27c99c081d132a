// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/icp/icp.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

void PairSum::add(const Eigen::Vector3d& s, const Eigen::Vector3d& q) {
  ++count;
  source += s;
  target += q;
  target_source.noalias() += q * s.transpose();
  squares += (s - q).squaredNorm();
}

PairSum& PairSum::operator+=(const PairSum& other) {
  count += other.count;
  source += other.source;
  target += other.target;
  target_source += other.target_source;
  squares += other.squares;
  return *this;
}

Pose PairSum::motion() const {
  const double n = std::max(count, 1);
  const Eigen::Vector3d mean_source = source / n;
  const Eigen::Vector3d mean_target = target / n;
  const Eigen::Matrix3d covariance = target_source / n - mean_target * mean_source.transpose();
  const Eigen::Matrix3d R = nearest_rotation(covariance);
  return {Eigen::Quaterniond(R).normalized(), mean_target - R * mean_source};
}

namespace {

/// Points and what they are matched with.
struct Matching {
  std::vector<Eigen::Vector3d> points;
  std::vector<const Eigen::Vector3d*> targets;  // null: none
};

/// Matches every point anew. The last target bounds the search: the nearest cannot be farther.
/// Sums are about `centre`, so that they keep their digits far from the map's origin.
PairSum match(Matching& matching, const NearestTarget& nearest, const Eigen::Vector3d& centre,
              double max_distance, const Workers& workers) {
  return workers.sum<PairSum>(matching.points.size(), [&](std::size_t begin, std::size_t end) {
    PairSum sum;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& point = matching.points[i];
      const Eigen::Vector3d*& target = matching.targets[i];
      const double known = target ? (*target - point).norm() : max_distance;
      if (known >= max_distance) target = nullptr;
      if (const auto* found = nearest(point, std::min(known, max_distance))) target = found;
      if (target) sum.add(point - centre, *target - centre);
    }
    return sum;
  });
}

/// T with T p = motion (p - centre) + centre.
Pose about(const Eigen::Vector3d& centre, const Pose& motion) {
  return {motion.rotation, motion.translation + centre - motion.rotation * centre};
}

/// The equations that these matches would give: what the covariance is made of.
NormalEquations<6> equations_of(const Matching& matching) {
  PointToPointSum sum;
  for (std::size_t i = 0; i < matching.points.size(); ++i) {
    if (matching.targets[i]) sum.add(matching.points[i], *matching.targets[i], 1.0);
  }
  return sum.equations();
}

}  // namespace

Alignment icp(const std::vector<Eigen::Vector3d>& points, const NearestTarget& nearest,
              const Pose& initial_guess, const IcpParameters& config, const Workers& workers) {
  constexpr int kLeastPairs = 3;  // for a motion
  Alignment result;
  result.points = static_cast<int>(points.size());
  result.T_map_lidar = initial_guess;
  Matching matching{transformed(initial_guess, points), {}};
  matching.targets.assign(points.size(), nullptr);
  const double distance = config.max_correspondence_distance;
  const auto match_all = [&] {
    return match(matching, nearest, result.T_map_lidar.translation, distance, workers);
  };
  const double n = std::max(result.points, 1);
  PairSum pairs = match_all();
  while (result.iterations < config.max_iteration && !result.converged &&
         pairs.count >= kLeastPairs) {
    const double fitness = pairs.count / n;
    const double rmse = std::sqrt(pairs.squares / pairs.count);
    result.T_map_lidar = about(result.T_map_lidar.translation, pairs.motion()) * result.T_map_lidar;
    matching.points = transformed(result.T_map_lidar, points);
    ++result.iterations;
    pairs = match_all();
    const double new_rmse = std::sqrt(pairs.squares / std::max(pairs.count, 1));
    result.converged = std::abs(pairs.count / n - fitness) < config.relative_fitness &&
                       std::abs(new_rmse - rmse) < config.relative_rmse;
  }
  result.equations = equations_of(matching);
  return result;
}

}  // namespace surefoot
