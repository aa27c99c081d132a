// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/baseline_front_end.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "core/information.hpp"
#include "core/level.hpp"
#include "geometry/so3.hpp"
#include "geometry/triangular_solves.hpp"

namespace surefoot {

std::optional<StampedPose> BaselineFrontEnd::last_pose() const {
  if (!started_) return std::nullopt;
  return motion_.last;
}

Pose BaselineFrontEnd::first_pose(const std::vector<Eigen::Vector3f>& points) {
  return level_pose(points, config().level, level_);
}

void BaselineFrontEnd::keep_scan(std::vector<Eigen::Vector3f> points, const PreparedScan& scan) {
  last_scan_ = {std::move(points), scan.intensities};
}

Estimate BaselineFrontEnd::report_first(const ScanTrajectory& trajectory) {
  Estimate estimate;
  estimate.status = Status::first_scan;
  estimate.message =
      started_ ? "the map was empty: it begins anew at the predicted pose" : level_.message;
  if (started_) {
    ++segment_;
    estimate.covariance = unregistered_covariance(config().health);
  }
  motion_ = {{trajectory.mid_ns(), trajectory.at(0.5)}, Twist::Zero()};
  return publish(trajectory, std::move(estimate));
}

Estimate BaselineFrontEnd::report(const Alignment& alignment, const ScanTrajectory& trajectory) {
  Estimate estimate;
  estimate.converged = alignment.converged;
  estimate.registered_points = alignment.points;
  estimate.stages = StageReport{"registration", alignment.iterations, alignment.equations.count,
                                alignment.equations.rms()};
  judge(alignment, estimate);
  const StampedPose pose{trajectory.mid_ns(), trajectory.at(0.5)};
  estimate.covariance = estimate.trusted() ? covariance(alignment, pose.pose)
                                           : unregistered_covariance(config().health);
  motion_ = next_motion(motion_, pose);
  return publish(trajectory, std::move(estimate));
}

void BaselineFrontEnd::judge(const Alignment& alignment, Estimate& estimate) const {
  const Config::Health& health = config().health;
  const int matches = alignment.equations.count;
  const double ratio = static_cast<double>(matches) / std::max(alignment.points, 1);
  estimate.status = Status::ok;
  if (!alignment.finite) {
    estimate.status = Status::diverged;
    estimate.message = "the registration gave no finite pose; the prediction stands";
  } else if (!alignment.refusal.empty()) {
    estimate.status = matches < health.min_matches ? Status::too_few_matches : Status::diverged;
    estimate.message = alignment.refusal;
  } else if (matches < health.min_matches || ratio < health.min_match_ratio) {
    estimate.status = Status::degenerate;
    estimate.message = std::to_string(matches) + " of " + std::to_string(alignment.points) +
                       " points have a match; expected at least " +
                       std::to_string(health.min_matches) + " and a share of " +
                       std::to_string(health.min_match_ratio) +
                       "; the pose is used all the same, as by the original";
  } else if (!alignment.converged) {
    estimate.message =
        "not converged after " + std::to_string(alignment.iterations) + " iterations";
  }
}

/// s^2 H^-1 of the registration's own normal equations, from about the map's origin to about the
/// sensor, with the prior that a pose stays within what a registration may correct.
Matrix6 BaselineFrontEnd::covariance(const Alignment& alignment, const Pose& T_map_lidar) const {
  const NormalEquations<6>& equations = alignment.equations;
  // A twist u about the sensor is B u about the origin.
  Matrix6 B = Matrix6::Identity();
  B.topRightCorner<3, 3>() = hat(T_map_lidar.translation);
  const Matrix6 H = B.transpose() * equations.H * B;
  const double variance = std::max(equations.rms() * equations.rms(), 1e-8);
  const Matrix6 prior = unregistered_covariance(config().health).inverse();
  return inverse(Eigen::LLT<Matrix6>(H / variance + prior));
}

Estimate BaselineFrontEnd::publish(const ScanTrajectory& trajectory, Estimate estimate) {
  started_ = true;
  estimate.trajectory = trajectory;
  estimate.twist = motion_.velocity;
  estimate.segment = segment_;
  return estimate;
}

}  // namespace surefoot
