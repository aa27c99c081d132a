// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The smallest user of the library: a sensor that stands still in a room stays where it is.
#include <surefoot/odometry.hpp>

#include <cstdio>

#include "room.hpp"

namespace {

// Not every point of a scan is kept in the map; those that are not find partners beside them.
constexpr double kMaxError = 0.05;  // [m]

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
