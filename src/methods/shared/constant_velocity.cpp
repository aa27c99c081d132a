// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/constant_velocity.hpp"

#include "core/segment_motion.hpp"

namespace surefoot {

std::vector<Eigen::Vector3d> deskew_to(double tau, const PreparedScan& scan, const Twist& motion,
                                       const Workers& workers) {
  std::vector<Eigen::Vector3d> deskewed(scan.points.size());
  const SegmentMotion to_tau(se3_exp(-tau * motion), motion);
  workers.for_chunks(scan.points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      deskewed[i] = scan.points[i].cast<double>();
      if (scan.taus.empty()) continue;
      deskewed[i] = to_tau(static_cast<double>(scan.taus[i]), deskewed[i]);
    }
  });
  return deskewed;
}

ScanTrajectory constant_velocity_through(const Pose& T_map_lidar, double tau, const Twist& motion,
                                         const PreparedScan& scan) {
  return ScanTrajectory(
      {T_map_lidar * se3_exp(-tau * motion), T_map_lidar * se3_exp((1.0 - tau) * motion)},
      scan.start_ns, scan.end_ns);
}

std::vector<Eigen::Vector3f> to_float(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3f> result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points) result.push_back(point.cast<float>());
  return result;
}

std::vector<Eigen::Vector3d> transformed(const Pose& T,
                                         const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Matrix3d R = T.rotation.toRotationMatrix();
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points) result.emplace_back(R * point + T.translation);
  return result;
}

std::vector<Eigen::Vector3d> crop(const std::vector<Eigen::Vector3d>& points, double min_range,
                                  double max_range) {
  std::vector<Eigen::Vector3d> kept;
  kept.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    const double range = point.norm();
    if (range > min_range && range < max_range) kept.push_back(point);
  }
  return kept;
}

}  // namespace surefoot
