// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/association.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "surefoot/seconds.hpp"

namespace surefoot::evaluation {

namespace {

/// Differences of stamps within it fit 64 bits: 146 years before and after 1970.
constexpr std::int64_t kFarthestStamp = (std::int64_t{1} << 62) - 1;

constexpr double kLongest = 4.6e9;  // [s], below kFarthestStamp

bool is_far(std::int64_t stamp_ns) {
  return stamp_ns > kFarthestStamp || stamp_ns < -kFarthestStamp;
}

void check(const Trajectory& trajectory, const std::string& name, bool stamps_matter) {
  if (trajectory.empty()) throw std::invalid_argument("the " + name + " has no poses");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Pose& pose = trajectory[i].pose;
    if (!pose.translation.allFinite() || !pose.rotation.coeffs().allFinite()) {
      throw std::invalid_argument("pose " + std::to_string(i) + " of the " + name +
                                  " is not finite");
    }
    if (stamps_matter && is_far(trajectory[i].stamp_ns)) {
      throw std::invalid_argument("pose " + std::to_string(i) + " of the " + name + " is stamped " +
                                  std::to_string(seconds(trajectory[i].stamp_ns)) +
                                  " s, which is no time since 1970");
    }
    if (stamps_matter && i > 0 && trajectory[i].stamp_ns < trajectory[i - 1].stamp_ns) {
      throw std::invalid_argument(
          "pose " + std::to_string(i) + " of the " + name + " is stamped " +
          std::to_string(seconds(trajectory[i - 1].stamp_ns - trajectory[i].stamp_ns)) +
          " s before the pose that precedes it");
    }
  }
}

/// First pose whose stamp is not before `stamp_ns`.
Trajectory::const_iterator not_before(const Trajectory& trajectory, std::int64_t stamp_ns) {
  return std::lower_bound(
      trajectory.begin(), trajectory.end(), stamp_ns,
      [](const StampedPose& stamped, std::int64_t stamp) { return stamped.stamp_ns < stamp; });
}

/// Nearest pose in time; of two at the same distance the earlier one.
const StampedPose& nearest(const Trajectory& trajectory, std::int64_t stamp_ns) {
  const auto after = not_before(trajectory, stamp_ns);
  if (after == trajectory.begin()) return *after;
  const auto before = not_before(trajectory, std::prev(after)->stamp_ns);
  if (after == trajectory.end()) return *before;
  return after->stamp_ns - stamp_ns < stamp_ns - before->stamp_ns ? *after : *before;
}

AssociatedTrajectories by_nearest(const Trajectory& reference, const Trajectory& estimate,
                                  std::int64_t offset_ns, std::int64_t limit_ns) {
  const bool estimate_longer = estimate.size() > reference.size();
  const Trajectory& shorter = estimate_longer ? reference : estimate;
  const Trajectory& longer = estimate_longer ? estimate : reference;
  const std::int64_t shift_ns = estimate_longer ? -offset_ns : offset_ns;
  AssociatedTrajectories result;
  for (const StampedPose& stamped : shorter) {
    const std::int64_t stamp_ns = stamped.stamp_ns + shift_ns;
    if (is_far(stamp_ns)) continue;
    const StampedPose& partner = nearest(longer, stamp_ns);
    if (std::abs(partner.stamp_ns - stamp_ns) > limit_ns) continue;
    result.reference.push_back(estimate_longer ? stamped : partner);
    result.estimate.push_back(estimate_longer ? partner : stamped);
  }
  return result;
}

Pose interpolate(const StampedPose& before, const StampedPose& after, std::int64_t stamp_ns) {
  if (after.stamp_ns == before.stamp_ns) return after.pose;
  const double share = static_cast<double>(stamp_ns - before.stamp_ns) /
                       static_cast<double>(after.stamp_ns - before.stamp_ns);
  return {before.pose.rotation.slerp(share, after.pose.rotation),
          (1.0 - share) * before.pose.translation + share * after.pose.translation};
}

AssociatedTrajectories by_interpolation(const Trajectory& reference, const Trajectory& estimate,
                                        std::int64_t offset_ns, std::int64_t max_gap_ns) {
  AssociatedTrajectories result;
  for (const StampedPose& stamped : estimate) {
    const std::int64_t stamp_ns = stamped.stamp_ns + offset_ns;
    if (is_far(stamp_ns)) continue;
    const auto after = not_before(reference, stamp_ns);
    if (after == reference.end()) break;
    const bool exact = after->stamp_ns == stamp_ns;
    if (after == reference.begin() && !exact) continue;
    const auto before = exact ? after : std::prev(after);
    if (after->stamp_ns - before->stamp_ns > max_gap_ns) continue;
    result.reference.push_back({stamp_ns, interpolate(*before, *after, stamp_ns)});
    result.estimate.push_back(stamped);
  }
  return result;
}

AssociatedTrajectories by_index(const Trajectory& reference, const Trajectory& estimate) {
  if (reference.size() != estimate.size()) {
    throw std::runtime_error("the reference has " + std::to_string(reference.size()) +
                             " poses and the estimate " + std::to_string(estimate.size()) +
                             ": poses without stamps can only be paired one to one");
  }
  return {reference, estimate};
}

std::string times_of(const Trajectory& trajectory, double offset) {
  return std::to_string(seconds(trajectory.front().stamp_ns) + offset) + " .. " +
         std::to_string(seconds(trajectory.back().stamp_ns) + offset) + " s";
}

std::string moved_text(const Trajectory& estimate, double offset) {
  if (offset == 0.0) return {};
  return ", moved by the offset of " + std::to_string(offset) + " s to " +
         times_of(estimate, offset);
}

}  // namespace

AssociatedTrajectories associate(const Trajectory& reference, const Trajectory& estimate,
                                 const AssociationOptions& options) {
  const bool stamps_matter = options.method != AssociationMethod::index;
  check(reference, "reference", stamps_matter);
  check(estimate, "estimate", stamps_matter);
  // Nothing of use is longer, and added to a stamp it still fits 64 bits.
  const auto nanoseconds = [](double value) {
    return static_cast<std::int64_t>(std::llround(1e9 * std::clamp(value, -kLongest, kLongest)));
  };
  const std::int64_t offset_ns = nanoseconds(options.offset);
  AssociatedTrajectories result;
  switch (options.method) {
    case AssociationMethod::nearest:
      result = by_nearest(reference, estimate, offset_ns, nanoseconds(options.max_difference));
      break;
    case AssociationMethod::interpolate:
      result = by_interpolation(reference, estimate, offset_ns, nanoseconds(options.max_gap));
      break;
    case AssociationMethod::index:
      result = by_index(reference, estimate);
      break;
  }
  if (result.estimate.empty()) {
    throw std::runtime_error("no pose of the estimate (" + times_of(estimate, 0.0) +
                             moved_text(estimate, options.offset) +
                             ") has a partner in the reference (" + times_of(reference, 0.0) + ")");
  }
  return result;
}

}  // namespace surefoot::evaluation
