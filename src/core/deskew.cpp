// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/deskew.hpp"

#include <algorithm>

namespace surefoot {

Deskewing::Deskewing(const ScanTrajectory& trajectory) {
  const Pose T_lidar_map = trajectory.at(0.5).inverse();
  for (std::size_t k = 0; k < trajectory.segments(); ++k) {
    segments_.emplace_back(T_lidar_map * trajectory.boundary(k), trajectory.segment_twist(k));
  }
}

Eigen::Vector3f Deskewing::operator()(const Eigen::Vector3f& point, float tau) const {
  const double scaled = static_cast<double>(tau) * static_cast<double>(segments_.size());
  const std::size_t k = std::min(static_cast<std::size_t>(scaled), segments_.size() - 1);
  const double u = scaled - static_cast<double>(k);  // [Eq 10]
  // [Eq 11] and [Eq 12]: p* = T_mid^-1 T(tau) p, with T(tau) = T_k exp(u xi_k).
  return segments_[k](u, point.cast<double>()).cast<float>();
}

std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan, const ScanTrajectory& trajectory,
                                    const Workers& workers) {
  if (scan.taus.empty()) return scan.points;

  const Deskewing deskewing(trajectory);
  std::vector<Eigen::Vector3f> deskewed(scan.points.size());
  workers.for_chunks(scan.points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      deskewed[i] = deskewing(scan.points[i], scan.taus[i]);
    }
  });
  return deskewed;
}

}  // namespace surefoot
