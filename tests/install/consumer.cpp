// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The smallest user of the library: a sensor that stands still in a room stays where it is.
#include <surefoot/odometry.hpp>

#include <cstdio>

namespace {

constexpr double kSpacing = 0.2;  // [m] between points
// Not every point of a scan is kept in the map; those that are not find partners beside them.
constexpr double kMaxError = 0.05;  // [m]

/// Floor and walls of a room of 12 x 8 x 3 m around the sensor.
surefoot::Scan scan_room(std::int64_t stamp_ns) {
  const Eigen::Vector3d low(-6.0, -4.0, -0.5);
  const Eigen::Vector3d high(6.0, 4.0, 2.5);
  surefoot::Scan scan;
  scan.stamp_ns = stamp_ns;
  const auto add = [&](double x, double y, double z) {
    scan.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
  };
  for (double x = low.x(); x < high.x(); x += kSpacing) {
    for (double y = low.y(); y < high.y(); y += kSpacing) add(x, y, low.z());
    for (double z = low.z(); z < high.z(); z += kSpacing) {
      add(x, low.y(), z);
      add(x, high.y(), z);
    }
  }
  for (double y = low.y(); y < high.y(); y += kSpacing) {
    for (double z = low.z(); z < high.z(); z += kSpacing) {
      add(low.x(), y, z);
      add(high.x(), y, z);
    }
  }
  return scan;
}

}  // namespace

int main() {
  surefoot::Odometry odometry;
  for (int i = 0; i < 3; ++i) {
    const surefoot::Estimate estimate = odometry.add_scan(scan_room(i * 100'000'000LL));
    const double moved = estimate.T_world_lidar.translation.norm();
    std::printf("scan %d: %s, %.6f m from the start\n", i,
                surefoot::to_string(estimate.status).data(), moved);
    if (!estimate.trusted() || moved > kMaxError) return 1;
  }
  return 0;
}
