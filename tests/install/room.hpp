// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the smallest users of the library look at.
#pragma once

#include <surefoot/scan.hpp>

/// Floor and walls of a room of 12 x 8 x 3 m around the sensor.
inline surefoot::Scan scan_room(std::int64_t stamp_ns) {
  constexpr double kSpacing = 0.2;  // [m] between points
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
