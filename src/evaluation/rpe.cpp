// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/rpe.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/so3.hpp"

namespace surefoot::evaluation {

namespace {

/// Nanoseconds for seconds, whose sums are exact: a tenth of a second has no exact double, and ten
/// of them are less than one.
double in_unit_of_steps(const PairOptions& options) {
  return options.unit == DeltaUnit::seconds ? std::round(1e9 * options.delta) : options.delta;
}

/// How far each pose is from the one before, in the unit of steps.
std::vector<double> steps(const Trajectory& trajectory, DeltaUnit unit) {
  std::vector<double> result;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const StampedPose &from = trajectory[i - 1], &to = trajectory[i];
    switch (unit) {
      case DeltaUnit::frames:
        result.push_back(1.0);
        break;
      case DeltaUnit::metres:
        result.push_back((to.pose.translation - from.pose.translation).norm());
        break;
      case DeltaUnit::seconds:
        result.push_back(static_cast<double>(to.stamp_ns - from.stamp_ns));
        break;
      case DeltaUnit::degrees:
        result.push_back(degrees(turn_angle(from.pose.rotation.conjugate() * to.pose.rotation)));
        break;
    }
  }
  return result;
}

void check(const PairOptions& options) {
  const double delta = options.delta;
  const bool possible = std::isfinite(delta) && delta > 0.0 &&
                        (options.unit != DeltaUnit::frames || delta == std::floor(delta)) &&
                        (options.unit != DeltaUnit::degrees || delta <= 180.0);
  if (possible) return;
  throw std::invalid_argument("a stretch of " + std::to_string(delta) +
                              " is not possible: expected a positive number, whole for frames, "
                              "at most 180 for degrees");
}

std::vector<IndexPair> one_after_the_other(const Trajectory& trajectory,
                                           const PairOptions& options) {
  std::vector<std::size_t> ends;
  if (options.unit != DeltaUnit::metres) ends.push_back(0);
  double length = 0.0;
  const double delta = in_unit_of_steps(options);
  const std::vector<double> step = steps(trajectory, options.unit);
  for (std::size_t i = 0; i < step.size(); ++i) {
    length += step[i];
    if (length < delta) continue;
    ends.push_back(i + 1);
    length = 0.0;
  }
  std::vector<IndexPair> pairs;
  for (std::size_t i = 1; i < ends.size(); ++i) pairs.push_back({ends[i - 1], ends[i]});
  return pairs;
}

/// From every pose to the one that is nearest to delta along the trajectory.
std::vector<IndexPair> nearest_to_delta(const Trajectory& trajectory, const PairOptions& options) {
  std::vector<double> along = {0.0};
  for (const double step : steps(trajectory, options.unit)) along.push_back(along.back() + step);
  const double delta = in_unit_of_steps(options);
  const double limit = options.unit == DeltaUnit::frames ? 0.0 : options.tolerance * delta;
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const auto first_at = [&](double length) {
      return std::partition_point(along.begin() + static_cast<std::ptrdiff_t>(i) + 1, along.end(),
                                  [&](double value) { return value - along[i] < length; });
    };
    auto best = first_at(delta);
    if (best != along.begin() + static_cast<std::ptrdiff_t>(i) + 1) {
      const auto before = first_at(*std::prev(best) - along[i]);
      const auto off = [&](auto at) { return std::abs(*at - along[i] - delta); };
      if (best == along.end() || off(before) <= off(best)) best = before;
    }
    if (std::abs(*best - along[i] - delta) > limit) continue;
    pairs.push_back({i, static_cast<std::size_t>(best - along.begin())});
  }
  return pairs;
}

/// From every pose to all later ones that are turned by delta against it.
std::vector<IndexPair> turned_by_delta(const Trajectory& trajectory, const PairOptions& options) {
  const double low = options.delta * (1.0 - options.tolerance);
  const double high = options.delta * (1.0 + options.tolerance);
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Eigen::Quaterniond back = trajectory[i].pose.rotation.conjugate();
    for (std::size_t j = i + 1; j < trajectory.size(); ++j) {
      const double turn = degrees(turn_angle(back * trajectory[j].pose.rotation));
      if (low <= turn && turn <= high) pairs.push_back({i, j});
    }
  }
  return pairs;
}

// [m] No truth resolves less, and a share of it says nothing.
constexpr double kShortestDistance = 1e-5;

/// Both motions over one stretch.
struct Motions {
  Pose reference, estimate;  // T_i_j
};

Motions motions(const AssociatedTrajectories& pairs, const IndexPair& stretch) {
  const auto& [i, j] = stretch;
  return {pairs.reference[i].pose.inverse() * pairs.reference[j].pose,
          pairs.estimate[i].pose.inverse() * pairs.estimate[j].pose};
}

}  // namespace

std::vector<IndexPair> find_pairs(const Trajectory& trajectory, const PairOptions& options) {
  check(options);
  if (!options.all_pairs) return one_after_the_other(trajectory, options);
  if (options.unit == DeltaUnit::degrees) return turned_by_delta(trajectory, options);
  return nearest_to_delta(trajectory, options);
}

std::vector<double> relative_errors(const AssociatedTrajectories& pairs,
                                    const std::vector<IndexPair>& stretches, Relation relation) {
  std::vector<double> errors;
  errors.reserve(stretches.size());
  for (const IndexPair& stretch : stretches) {
    const Motions motion = motions(pairs, stretch);
    errors.push_back(size_of(motion.reference.inverse() * motion.estimate, relation));
  }
  return errors;
}

std::vector<double> relative_distance_errors(const AssociatedTrajectories& pairs,
                                             const std::vector<IndexPair>& stretches) {
  std::vector<double> errors;
  errors.reserve(stretches.size());
  for (const IndexPair& stretch : stretches) {
    const Motions motion = motions(pairs, stretch);
    errors.push_back(
        std::abs(motion.reference.translation.norm() - motion.estimate.translation.norm()));
  }
  return errors;
}

std::vector<double> relative_distance_error_percents(const AssociatedTrajectories& pairs,
                                                     const std::vector<IndexPair>& stretches) {
  std::vector<double> errors;
  for (const IndexPair& stretch : stretches) {
    const Motions motion = motions(pairs, stretch);
    const double distance = motion.reference.translation.norm();
    if (distance < kShortestDistance) continue;
    errors.push_back(100.0 * std::abs(distance - motion.estimate.translation.norm()) / distance);
  }
  return errors;
}

}  // namespace surefoot::evaluation
