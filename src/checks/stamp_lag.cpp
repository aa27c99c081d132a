// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/stamp_lag.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "checks/time_trials.hpp"

namespace surefoot::checks {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kSteps = 60;  // to either side
// Poses that are farther apart than this are not interpolated [ns].
constexpr std::int64_t kLongest = 500'000'000;

std::optional<Eigen::Quaterniond> rotation_at(const Trajectory& trajectory, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(
      trajectory.begin(), trajectory.end(), stamp_ns,
      [](const StampedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == trajectory.begin() || after == trajectory.end()) return std::nullopt;
  const StampedPose& before = *std::prev(after);
  const std::int64_t gap = after->stamp_ns - before.stamp_ns;
  if (gap <= 0 || gap > kLongest) return std::nullopt;
  const double share = static_cast<double>(stamp_ns - before.stamp_ns) / static_cast<double>(gap);
  return before.pose.rotation.slerp(share, after->pose.rotation);
}

using Angles = std::vector<std::optional<double>>;

// [deg] turned from pose to pose of the estimate, as the reference has it so much later.
Angles angles_of(const Trajectory& estimate, const Trajectory& reference, double lag_s) {
  const auto lag_ns = static_cast<std::int64_t>(std::llround(1e9 * lag_s));
  Angles angles;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    const auto a = rotation_at(reference, estimate[i - 1].stamp_ns + lag_ns);
    const auto b = rotation_at(reference, estimate[i].stamp_ns + lag_ns);
    angles.push_back(a && b ? std::optional(a->angularDistance(*b) / kDegree) : std::nullopt);
  }
  return angles;
}

}  // namespace

StampLag find_stamp_lag(const Trajectory& estimate, const Trajectory& reference, double most_s) {
  StampLag result;
  std::vector<Angles> tried;
  for (int k = -kSteps; k <= kSteps; ++k) {
    tried.push_back(angles_of(estimate, reference, most_s * k / kSteps));
  }
  std::vector<double> turned;
  std::vector<std::size_t> usable;  // motions that the reference covers at every lag
  for (std::size_t i = 0; i + 1 < estimate.size(); ++i) {
    turned.push_back(estimate[i].pose.rotation.angularDistance(estimate[i + 1].pose.rotation) /
                     kDegree);
    const bool covered =
        std::all_of(tried.begin(), tried.end(), [i](const Angles& a) { return a[i].has_value(); });
    if (covered) usable.push_back(i);
  }
  result.pairs = usable.size();
  if (usable.empty()) return result;
  const auto error = [&](const Angles& angles) {
    double sum = 0.0;
    for (const std::size_t i : usable) sum += std::pow(*angles[i] - turned[i], 2);
    return std::sqrt(sum / static_cast<double>(usable.size()));
  };
  std::size_t best = kSteps;
  for (std::size_t k = 0; k < tried.size(); ++k) {
    if (error(tried[k]) < error(tried[best])) best = k;
  }
  const Angles& here = tried[kSteps];
  result.lag_s = most_s * (static_cast<double>(best) - kSteps) / kSteps;
  result.error_deg = error(here);
  result.best_deg = error(tried[best]);
  for (const std::size_t i : usable) {
    const double as_is = std::abs(*here[i] - turned[i]);
    const double moved = std::abs(*tried[best][i] - turned[i]);
    result.better += moved < as_is ? 1 : 0;
    result.worse += moved > as_is ? 1 : 0;
  }
  result.chance = chance_of(result.better, result.worse);
  return result;
}

}  // namespace surefoot::checks
