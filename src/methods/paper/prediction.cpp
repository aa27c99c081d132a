// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/prediction.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "surefoot/seconds.hpp"

namespace surefoot {

MotionPrior predict_motion(const LastMotion& motion, std::int64_t start_ns, std::int64_t end_ns,
                           double max_extrapolation) {
  const double to_start = seconds(start_ns - motion.last.stamp_ns);
  const double duration = seconds(end_ns - start_ns);
  const Pose T_start =
      motion.last.pose * se3_exp(std::min(to_start, max_extrapolation) * motion.velocity);
  return {T_start, T_start * se3_exp(duration * motion.velocity)};
}

Twist clamp_twist(const Twist& twist, const PaperParameters::Deskew& config) {
  Twist clamped = twist;  // [Eq 6]
  clamped[2] = std::clamp(twist[2], -config.clamp_z, config.clamp_z);
  clamped[3] = std::clamp(twist[3], -config.clamp_roll, config.clamp_roll);
  clamped[4] = std::clamp(twist[4], -config.clamp_pitch, config.clamp_pitch);
  return clamped;
}

Pose interpolate(const Pose& T_a, const Pose& T_b, double u) {
  return {T_a.rotation.slerp(u, T_b.rotation),
          T_a.translation + u * (T_b.translation - T_a.translation)};
}

ScanTrajectory predict_trajectory(const MotionPrior& prior, std::int64_t start_ns,
                                  std::int64_t end_ns, const PaperParameters::Deskew& config) {
  const Pose& T_s = prior.T_start;
  if (config.mode != DeskewMode::piecewise) {
    return ScanTrajectory({T_s, prior.T_end}, start_ns, end_ns);
  }
  const Twist xi = se3_log(T_s.inverse() * prior.T_end);    // [Eq 5]
  const Pose T_f = T_s * se3_exp(clamp_twist(xi, config));  // [Eq 7]
  const int K = config.segments;
  std::vector<Pose> boundaries;
  boundaries.reserve(static_cast<std::size_t>(K) + 1);
  for (int k = 0; k <= K; ++k) {
    boundaries.push_back(interpolate(T_s, T_f, static_cast<double>(k) / K));  // [Eq 8]
  }
  return ScanTrajectory(std::move(boundaries), start_ns, end_ns);  // [Eq 9] inside
}

}  // namespace surefoot
