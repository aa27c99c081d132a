// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace surefoot::simulation {
namespace {

constexpr std::int64_t kPeriod = 100'000'000;

/// Ten scans a second of a ring of points, walked along x at 1 m/s.
FaultSource walk() {
  FaultSource source;
  source.scan = [](std::uint64_t index) {
    Scan scan;
    scan.stamp_ns = static_cast<std::int64_t>(index) * kPeriod;
    for (int i = 0; i < 2000; ++i) {
      const float azimuth = 0.00314F * static_cast<float>(i);
      scan.points.emplace_back(8.0F * std::cos(azimuth), 8.0F * std::sin(azimuth),
                               i % 2 == 0 ? -0.5F : 0.5F);
      scan.times_ns.push_back(i * 49'000);
      scan.rings.push_back(static_cast<std::uint16_t>(i % 2));
      scan.intensities.push_back(static_cast<float>(index));
    }
    return scan;
  };
  source.T_map_lidar = [](std::int64_t instant_ns) {
    return Pose{Eigen::Quaterniond::Identity(), {1e-9 * static_cast<double>(instant_ns), 0.0, 0.0}};
  };
  return source;
}

const Fault& fault_called(const std::string& name) {
  const auto& all = fault_catalogue();
  return *std::find_if(all.begin(), all.end(), [&](const Fault& f) { return f.name == name; });
}

TEST(Faults, ThereAreSixtyAndTheFirstDoesNothing) {
  std::set<std::string> names;
  for (const Fault& fault : fault_catalogue()) {
    EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
    EXPECT_FALSE(fault.what.empty()) << fault.name;
  }
  EXPECT_GT(names.size(), 60U);
  const Scan scan = walk().scan(35);
  const FaultyScan shown = fault_catalogue().front().scan(35, walk(), walk());
  EXPECT_EQ(shown.scan.points, scan.points);
  EXPECT_EQ(shown.scan.stamp_ns, scan.stamp_ns);
  EXPECT_NEAR(shown.T_map_lidar.translation.x(), 3.5 + 0.5 * 1999 * 49e-6, 1e-9);
}

/// All but those that mean to break it leave whole scans, and all but who leaps from the first scan
/// on leave the walk alone before.
TEST(Faults, LeaveWholeScans) {
  for (const Fault& fault : fault_catalogue()) {
    for (const std::uint64_t n : {0U, 10U, 30U, 31U, 49U, 50U, 99U}) {
      const Scan scan = fault.scan(n, walk(), walk()).scan;
      EXPECT_TRUE(scan.times_ns.empty() || scan.times_ns.size() == scan.points.size())
          << fault.name;
      EXPECT_EQ(scan.rings.size(), scan.points.size()) << fault.name;
      EXPECT_EQ(scan.intensities.size(), scan.points.size()) << fault.name;
      if (n == 10 && fault.name != "leaps") {
        EXPECT_EQ(scan.stamp_ns, 10 * kPeriod) << fault.name;
      }
    }
  }
}

TEST(Faults, WhatIsCarriedIsSomewhereElseAtTheNextStamp) {
  const Fault& carried = fault_called("carried 5 m");
  const FaultyScan before = carried.scan(kFaultBegins - 1, walk(), walk());
  const FaultyScan after = carried.scan(kFaultBegins, walk(), walk());
  EXPECT_EQ(after.scan.stamp_ns - before.scan.stamp_ns, kPeriod);
  EXPECT_NEAR(after.T_map_lidar.translation.x() - before.T_map_lidar.translation.x(), 5.1, 0.11);
}

TEST(Faults, AHoleIsInTheStamps) {
  const Fault& hole = fault_called("hole 3 s");
  const FaultyScan before = hole.scan(kFaultBegins - 1, walk(), walk());
  const FaultyScan after = hole.scan(kFaultBegins, walk(), walk());
  EXPECT_EQ(after.scan.stamp_ns - before.scan.stamp_ns, 31 * kPeriod);
  EXPECT_NEAR(after.T_map_lidar.translation.x() - before.T_map_lidar.translation.x(), 3.1, 1e-9);
}

TEST(Faults, WhoTurnsTheSensorByHandTurnsItByNoMoreThanATurn) {
  const Fault& turned = fault_called("turned by hand");
  for (std::uint64_t n = kFaultBegins; n < kFaultBegins + 20; ++n) {
    const FaultyScan a = turned.scan(n, walk(), walk()), b = turned.scan(n + 1, walk(), walk());
    EXPECT_EQ(b.scan.stamp_ns - a.scan.stamp_ns, 5 * kPeriod);
    const double angle = a.T_map_lidar.rotation.angularDistance(b.T_map_lidar.rotation);
    EXPECT_GE(angle, 0.45);
    EXPECT_LE(angle, 0.72);
    const FaultyScan straight =
        fault_called("none").scan(kFaultBegins + 5 * (n - kFaultBegins), walk(), walk());
    const Eigen::Vector3d there = a.T_map_lidar * a.scan.points[7].cast<double>();
    EXPECT_LT((there - straight.T_map_lidar * straight.scan.points[7].cast<double>()).norm(), 1e-3);
  }
}

TEST(Faults, WhoLeapsIsFourSecondsFartherOnEachTime) {
  const Fault& leaps = fault_called("leaps");
  const FaultyScan a = leaps.scan(5, walk(), walk()), b = leaps.scan(6, walk(), walk());
  EXPECT_EQ(b.scan.stamp_ns - a.scan.stamp_ns, 8 * kPeriod);
  EXPECT_NEAR(b.T_map_lidar.translation.x() - a.T_map_lidar.translation.x(), 4.0, 1e-9);
}

TEST(Faults, AFrozenSensorShowsWhereItWasNotWhereItIs) {
  const Fault& frozen = fault_called("frozen");
  const FaultyScan shown = frozen.scan(60, walk(), walk());
  EXPECT_EQ(shown.scan.intensities.front(), static_cast<float>(kFaultBegins - 1));
  EXPECT_EQ(shown.scan.stamp_ns, 60 * kPeriod);
  EXPECT_NEAR(shown.T_map_lidar.translation.x(), 6.05, 0.01);
}

TEST(Faults, ATurnedMountTurnsPointsAndPose) {
  const FaultyScan shown = fault_called("mount turned 90").scan(40, walk(), walk());
  const Scan scan = walk().scan(40);
  const Pose before = walk().T_map_lidar(4'048'975'500);
  const Eigen::Vector3d there = shown.T_map_lidar * shown.scan.points[7].cast<double>();
  EXPECT_LT((there - before * scan.points[7].cast<double>()).norm(), 1e-3);
}

}  // namespace
}  // namespace surefoot::simulation
