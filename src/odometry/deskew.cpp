// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "odometry/deskew.hpp"

#include <algorithm>
#include <cmath>

#include "odometry/segment_motion.hpp"

namespace surefoot {

Twist clamp_twist(const Twist& twist, const Config::Deskew& config) {
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
                                  std::int64_t end_ns, const Config::Deskew& config) {
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

std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan, const ScanTrajectory& trajectory,
                                    const Config::Deskew& config, const Workers& workers) {
  if (config.mode == DeskewMode::none || scan.taus.empty()) return scan.points;

  const Pose T_lidar_map = trajectory.at(0.5).inverse();
  std::vector<SegmentMotion> segments;
  for (std::size_t k = 0; k < trajectory.segments(); ++k) {
    segments.emplace_back(T_lidar_map * trajectory.boundary(k), trajectory.segment_twist(k));
  }
  const auto K = static_cast<double>(segments.size());
  std::vector<Eigen::Vector3f> deskewed(scan.points.size());
  workers.for_chunks(scan.points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double scaled = static_cast<double>(scan.taus[i]) * K;
      const std::size_t k = std::min(static_cast<std::size_t>(scaled), segments.size() - 1);
      const double u = scaled - static_cast<double>(k);  // [Eq 10]
      // [Eq 11] and [Eq 12]: p* = T_mid^-1 T(tau) p, with T(tau) = T_k exp(u xi_k).
      deskewed[i] = segments[k](u, scan.points[i].cast<double>()).cast<float>();
    }
  });
  return deskewed;
}

}  // namespace surefoot
