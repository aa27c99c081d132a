// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The smallest user of surefoot::mapping: a map is made, saved, and asked where the sensor is.
#include <surefoot/localizer.hpp>
#include <surefoot/mapper.hpp>
#include <surefoot/odometry.hpp>

#include <cstdio>
#include <stdexcept>

#include "room.hpp"

int main() {
  constexpr int kScans = 12;
  surefoot::Odometry odometry;
  surefoot::Mapper mapper;
  for (int i = 0; i < kScans; ++i) {
    const surefoot::Estimate estimate = odometry.add_scan(scan_room(i * 100'000'000LL));
    mapper.add(estimate, odometry.deskewed_scan());
  }
  mapper.finish();
  mapper.save("map.surefoot");
  std::printf("%zu poses, %zu loops\n", mapper.trajectory().size(), mapper.loops());
  if (mapper.trajectory().size() != kScans) return 1;

  surefoot::Odometry other;
  surefoot::Localizer localizer("map.surefoot");
  for (int i = 0; i < kScans; ++i) {
    const surefoot::Estimate estimate = other.add_scan(scan_room(i * 100'000'000LL));
    localizer.add(estimate, other);
  }
  std::printf("%s\n", localizer.message().c_str());
  // The room is the same turned by half: a place that is known is the right one, or there is none.
  if (localizer.T_map_lidar() && localizer.T_map_lidar()->translation.norm() > 0.1) return 1;
  if (!localizer.T_map_lidar() && localizer.message().empty()) return 1;
  try {
    const surefoot::Localizer nowhere("no_such_map.surefoot");
  } catch (const std::runtime_error& error) {
    std::printf("%s\n", error.what());
    return 0;
  }
  return 1;
}
