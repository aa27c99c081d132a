// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/drift.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::evaluation {

namespace {

constexpr double kLongestStep = 3.0;  // in median steps; a longer one is a hole
// [m] Who went less far did not move: a truth's last digits are no way to have a share of.
constexpr double kShortestPath = 0.01;

std::vector<std::int64_t> stamps_of(const Trajectory& trajectory) {
  std::vector<std::int64_t> stamps;
  for (const StampedPose& pose : trajectory) stamps.push_back(pose.stamp_ns);
  return stamps;
}

}  // namespace

std::int64_t median_step_ns(const std::vector<std::int64_t>& stamps_ns) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) {
    const std::int64_t step = stamps_ns[i] - stamps_ns[i - 1];
    if (step > 0) steps.push_back(step);  // a stamp that comes twice is no pace
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<double> path_lengths(const Trajectory& trajectory) {
  std::vector<double> lengths;
  lengths.reserve(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    lengths.push_back(
        i == 0 ? 0.0
               : lengths.back() +
                     (trajectory[i].pose.translation - trajectory[i - 1].pose.translation).norm());
  }
  return lengths;
}

EndDrift drift_of(const Eigen::Vector3d& error, double path_length) {
  EndDrift drift;
  drift.path_length = path_length;
  drift.total = error.norm();
  drift.horizontal = error.head<2>().norm();
  drift.vertical = error.z();
  drift.percent = path_length < kShortestPath ? 0.0 : 100.0 * drift.total / path_length;
  return drift;
}

EndDrift end_drift(const AssociatedTrajectories& pairs) {
  const Pose estimate_motion = pairs.estimate.front().pose.inverse() * pairs.estimate.back().pose;
  const Eigen::Vector3d estimated_end =
      (pairs.reference.front().pose * estimate_motion).translation;
  const Eigen::Vector3d error = estimated_end - pairs.reference.back().pose.translation;
  return drift_of(error, path_lengths(pairs.reference).back());
}

double coverage(const Trajectory& reference, const Trajectory& estimate, double offset,
                std::int64_t usual_step_ns) {
  if (reference.empty() || estimate.empty()) return 0.0;
  const std::int64_t offset_ns = std::llround(1e9 * offset);
  const std::int64_t begin = reference.front().stamp_ns, end = reference.back().stamp_ns;
  const auto inside = [&](const StampedPose& stamped) {
    return std::clamp(stamped.stamp_ns + offset_ns, begin, end);
  };
  if (begin == end) {
    return std::any_of(estimate.begin(), estimate.end(),
                       [&](const StampedPose& s) { return s.stamp_ns + offset_ns == begin; })
               ? 1.0
               : 0.0;
  }
  const std::int64_t usual =
      usual_step_ns > 0 ? usual_step_ns : median_step_ns(stamps_of(estimate));
  const double longest = kLongestStep * static_cast<double>(usual);
  double covered = 0.0;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    const auto step = static_cast<double>(estimate[i].stamp_ns - estimate[i - 1].stamp_ns);
    if (step > longest) continue;
    covered += static_cast<double>(inside(estimate[i]) - inside(estimate[i - 1]));
  }
  return covered / static_cast<double>(end - begin);
}

}  // namespace surefoot::evaluation
