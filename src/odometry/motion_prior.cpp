// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "odometry/motion_prior.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kSecond = 1e-9;  // [s/ns]
}

MotionPrior predict_motion(const Motion& motion, std::int64_t start_ns, std::int64_t end_ns,
                           double max_extrapolation) {
  const double to_start = static_cast<double>(start_ns - motion.last.stamp_ns) * kSecond;
  const double duration = static_cast<double>(end_ns - start_ns) * kSecond;
  const Pose T_start =
      motion.last.pose * se3_exp(std::min(to_start, max_extrapolation) * motion.velocity);
  return {T_start, T_start * se3_exp(duration * motion.velocity)};
}

Motion next_motion(const Motion& motion, const StampedPose& pose) {
  const double elapsed = static_cast<double>(pose.stamp_ns - motion.last.stamp_ns) * kSecond;
  return {pose, se3_log(motion.last.pose.inverse() * pose.pose) / elapsed};
}

}  // namespace surefoot
