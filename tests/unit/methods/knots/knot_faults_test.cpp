// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When it loses itself: it says so, finds itself again, or begins a segment of its own.
// benchmarks/reliability does many more faults, to simulated scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>

#include "fault_walk.hpp"
#include "geometry/so3.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

/// Left and right changed: its beams turn the other way.
void make_mirrored(Scan& scan) {
  for (Eigen::Vector3f& point : scan.points) point.y() = -point.y();
}

TEST(KnotFaults, TheVerdictOnlyObserves) {
  Config unjudged;
  unjudged.knots.lost_probability = 1.0;
  Odometry with, without(unjudged);
  for (const Scan& scan : walk_scans()) {
    const Estimate a = with.add_scan(scan), b = without.add_scan(scan);
    ASSERT_TRUE(a.trusted()) << a.message;
    EXPECT_EQ(a.T_world_lidar.translation, b.T_world_lidar.translation);
    EXPECT_EQ(a.T_world_lidar.rotation.coeffs(), b.T_world_lidar.rotation.coeffs());
    EXPECT_EQ(a.covariance, b.covariance);
    if (a.status == Status::ok) {
      EXPECT_LT(a.wrong_probability, 0.1);
    }
  }
}

TEST(KnotFaults, CarriedItFindsItselfAgainInItsMap) {
  for (const Pose& by : {Pose{Eigen::Quaterniond::Identity(), {2.0, 1.5, 0.0}},
                         Pose{so3_exp({0.0, 0.0, 1.0}), {1.0, -0.5, 0.0}}}) {
    const MotionFunction motion = carried(by);
    const std::vector<Scan> scans = take_scans(furnished_hall(), motion, kFaultScans);
    Odometry odometry;
    std::vector<Estimate> all;
    int again = -1;
    for (int i = 0; i < kFaultScans; ++i) {
      all.push_back(odometry.add_scan(scans[static_cast<std::size_t>(i)]));
      const Estimate& estimate = all.back();
      if (estimate.status == Status::ok) {
        EXPECT_LT(end_error(all, estimate, motion), 0.1) << i;
      }
      if (i >= kEvent && again < 0 && estimate.trusted()) again = i;
    }
    std::printf("carried: lost at %d, right again at %d: %s\n", kEvent, again,
                statuses(all).c_str());
    EXPECT_FALSE(all[kEvent].trusted());
    EXPECT_GT(all[kEvent].evidence.rival, 0.3) << "where it is now, the scan fits better";
    EXPECT_EQ(all.back().segment, 0);
    EXPECT_TRUE(all.back().trusted());
    EXPECT_LE(again - kEvent, 5);
  }
}

// For 3 s. At a walker's speed the scan after it begins where that led; at 1.5 m/s it is looked
// for, farther away than any registration may move a scan.
TEST(KnotFaults, WhoWalksOnUnseenIsFoundAtOnce) {
  for (const double speed : {1.2, 1.5}) {
    const MotionFunction motion =
        constant_velocity(kFaultStart, (Twist() << speed, 0, 0, 0, 0, 0).finished());
    std::vector<Scan> scans = take_scans(furnished_hall(), motion, 56);
    scans.erase(scans.begin() + kEvent, scans.begin() + kEvent + 30);
    Odometry odometry;
    const auto all = add_scans(odometry, scans);
    std::printf("walked on unseen: %s\n", statuses(all).c_str());
    EXPECT_TRUE(all[speed > 1.3 ? kEvent + 3 : kEvent].trusted());
    EXPECT_EQ(all.back().segment, 0);
    EXPECT_LT(end_error(all, all.back(), motion), 0.15) << statuses(all);
  }
}

const Eigen::Vector3d kMountsDeg[] = {{180, 0, 0}, {0, 25, 0}};  // roll pitch yaw

Config of_mount(const Eigen::Vector3d& mount_deg) {
  Config config;
  config.level.mode = LevelMode::mount;
  config.level.mount_roll_deg = mount_deg.x();
  config.level.mount_pitch_deg = mount_deg.y();
  return config;
}

/// However it is mounted, the carrier stands on the ground: where it would be had it walked
/// straight on is the first place that is looked at, for who stumbles, too.
TEST(KnotFaults, WhoWalksOnUnseenIsFoundHoweverItIsMounted) {
  for (const Eigen::Vector3d& mount_deg : kMountsDeg) {
    const Config config = of_mount(mount_deg);
    const MotionFunction motion =
        mounted(trotting(kFaultStart, 1.2, 2.0), mount_pose(config.level));
    std::vector<Scan> scans = take_scans(furnished_hall(), motion, kEvent);
    for (Scan& scan : take_scans(furnished_hall(), motion, 6, {}, kEvent + 20)) {
      scans.push_back(std::move(scan));
    }
    Odometry odometry(config);
    const auto all = add_scans(odometry, scans);
    std::printf("%g %g: %s\n", mount_deg.x(), mount_deg.y(), statuses(all).c_str());
    EXPECT_TRUE(all[kEvent].trusted()) << mount_deg.transpose();
    EXPECT_LT(end_error(all, all.back(), motion), 0.1) << mount_deg.transpose();
  }
}

/// However it is mounted, its carrier turns about the ground's up, and the LiDAR with it.
TEST(KnotFaults, CarriedItFindsItselfAgainHoweverItIsMounted) {
  const MotionFunction upright = carried({so3_exp({0.0, 0.0, 1.0}), {1.0, -0.5, 0.0}});
  for (const Eigen::Vector3d& mount_deg : kMountsDeg) {
    const Config config = of_mount(mount_deg);
    const MotionFunction motion = mounted(upright, mount_pose(config.level));
    Odometry odometry(config);
    const auto all = add_scans(odometry, take_scans(furnished_hall(), motion, kFaultScans));
    EXPECT_FALSE(all[kEvent].trusted()) << mount_deg.transpose();
    EXPECT_TRUE(all[kEvent + 6].trusted()) << mount_deg.transpose() << ": " << statuses(all);
    EXPECT_EQ(all.back().segment, 0);
    EXPECT_LT(end_error(all, all.back(), motion), 0.1) << mount_deg.transpose();
  }
}

TEST(KnotFaults, AGarbageFirstScanIsDropped) {
  std::vector<Scan> scans = walk_scans();
  make_garbage(scans.front());
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  EXPECT_TRUE(all[6].trusted()) << statuses(all);
  EXPECT_GT(all.back().segment, 0);
  EXPECT_EQ(all.back().segment, all[6].segment) << statuses(all);
  EXPECT_LT(end_error({all.begin() + 6, all.end()}, all.back(), walk()), 0.05);
}

// Of two scans that do not fit, neither is believed: where the third speaks against the map of the
// first, that is dropped at once, and nothing is lost for long.
TEST(KnotFaults, AMapOfOneScanFromElsewhereIsDropped) {
  const std::pair<double, double> moved[] = {
      {0.5, 0.0}, {0.5, 0.2}, {0.7, 0.5}, {0.7, 1.0}, {1.0, 0.2}};  // [m], [rad]
  for (const auto& [aside, yaw] : moved) {
    const Pose by{so3_exp({0.0, 0.0, yaw}), {0.0, aside, 0.0}};
    const Pose before = walk()(0.1);
    const MotionFunction motion = [=](double t) {
      return t < 0.1 ? before * by * before.inverse() * walk()(t) : walk()(t);
    };
    Odometry odometry;
    const auto all = add_scans(odometry, take_scans(furnished_hall(), motion, 12));
    for (std::size_t i = 4; i < all.size(); ++i) {
      EXPECT_TRUE(all[i].trusted()) << i << ' ' << statuses(all);
      // Measured: at most 0.053, when the young map is straightened (0.042 before it was).
      EXPECT_LT(end_error(all, all[i], motion), 0.055) << i << ' ' << statuses(all);
    }
  }
}

TEST(KnotFaults, OneScanOfGarbageDoesNotLoseIt) {
  std::vector<Scan> scans = walk_scans();
  make_garbage(scans[kEvent]);
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (int i = 1; i < kFaultScans; ++i) {
    const Estimate& estimate = all[static_cast<std::size_t>(i)];
    EXPECT_EQ(estimate.trusted(), i != kEvent) << statuses(all);
    EXPECT_EQ(estimate.segment, 0);
  }
  EXPECT_LT(end_error(all, all.back(), walk()), 0.05);
}

// Scans that are refused since the clock was set back by a second are a hole of a second, whatever
// the stamps say of it.
TEST(KnotFaults, AClockThatIsSetBackLeavesAHole) {
  std::vector<Scan> scans = walk_scans();
  for (std::size_t i = kEvent; i < scans.size(); ++i) scans[i].stamp_ns -= 1'000'000'000;
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (std::size_t i = kEvent; i < kEvent + 10; ++i) {
    EXPECT_EQ(all[i].status, Status::rejected) << i;
  }
  const Estimate& next = all[kEvent + 10];
  EXPECT_TRUE(next.trusted());
  EXPECT_NEAR(next.evidence.gap, std::log(11.0), 1e-6);
  EXPECT_LT(all[kEvent + 11].evidence.gap, 1e-6);
  const Pose moved = all[kEvent - 1].T_world_lidar.inverse() * next.T_world_lidar;
  EXPECT_NEAR(moved.translation.norm(), 0.5 * 1.1, 0.05);
}

// One scan from a clock that was an hour ahead: a second later the odometry follows the true time.
TEST(KnotFaults, OneStampFarAheadIsNotWaitedFor) {
  constexpr std::int64_t kHourNs = 3'600'000'000'000;
  std::vector<Scan> scans = walk_scans();
  scans[kEvent].stamp_ns += kHourNs;
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (std::size_t i = kEvent + 1; i < kEvent + 11; ++i) {
    EXPECT_EQ(all[i].status, Status::rejected) << i;
  }
  EXPECT_NEAR(all[kEvent + 11].evidence.gap, std::log(11.0), 1e-6);
  for (std::size_t i = kEvent + 11; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].trusted()) << statuses(all);
    EXPECT_EQ(all[i].segment, 0);
    EXPECT_LE(std::abs(all[i].stamp_ns - scans[i].stamp_ns), 100'000'000) << i;
    EXPECT_LT(all[i].evidence.gap, i == kEvent + 11 ? 3.0 : 1e-6) << i;
  }
  EXPECT_LT(end_error(all, all.back(), walk()), 0.05);
}

// Stamps that stand, or jump about, tell no time that could be followed.
TEST(KnotFaults, StampsThatDoNotRiseAreNotFollowed) {
  std::vector<Scan> scans = walk_scans();
  for (std::size_t i = kEvent; i < scans.size(); ++i) scans[i].stamp_ns = 0;
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (std::size_t i = kEvent; i < all.size(); ++i) EXPECT_EQ(all[i].status, Status::rejected);
}

// Sent late or twice, a scan takes no time of its own.
TEST(KnotFaults, AScanThatComesLateOrTwiceLeavesNone) {
  std::vector<Scan> scans = walk_scans();
  std::swap(scans[kEvent], scans[kEvent + 1]);
  scans.insert(scans.begin() + kEvent + 5, scans[kEvent + 4]);
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  EXPECT_EQ(all[kEvent + 1].status, Status::rejected);
  EXPECT_EQ(all[kEvent + 5].status, Status::rejected);
  EXPECT_LT(all[kEvent + 2].evidence.gap, 1e-6);
  EXPECT_LT(all[kEvent + 6].evidence.gap, 1e-6);
}

// As one who looks about with a sensor in the hand, of which every fifth scan was kept.
TEST(KnotFaults, TurnsByHandAreRightOrNotOk) {
  std::vector<Scan> scans(walk_scans().begin(), walk_scans().begin() + kEvent);
  std::vector<Pose> turns(kEvent);
  double yaw = 0.0;
  for (int i = kEvent; i < kFaultScans; i += 5) {
    yaw += i % 2 == 0 ? 0.6 : -0.5;
    turns.push_back({so3_exp({0.0, 0.0, yaw}), {0.0, 0.0, 0.0}});
    scans.push_back(walk_scans()[static_cast<std::size_t>(i)]);
    for (Eigen::Vector3f& p : scans.back().points) {
      p = (turns.back().inverse() * p.cast<double>()).cast<float>();
    }
  }
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  const auto truth = [&](std::size_t i) {
    return walk()(1e-9 * static_cast<double>(all[i].stamp_ns)) * turns[i];
  };
  std::printf("turned by hand: %s\n", statuses(all).c_str());
  EXPECT_TRUE(all[kEvent].status == Status::lost || all[kEvent].status == Status::ok);
  for (std::size_t i = kEvent; i < all.size(); ++i) {
    if (all[i].status != Status::ok) continue;
    const Pose off = (truth(1).inverse() * truth(i)).inverse() *
                     (all[1].T_world_lidar.inverse() * all[i].T_world_lidar);
    EXPECT_LT(off.translation.norm(), 0.2) << i;
    EXPECT_LT(so3_log(off.rotation).norm(), 0.05) << i;
  }
}

TEST(KnotFaults, AFrozenSensorIsLost) {
  std::vector<Scan> scans = walk_scans();
  for (int i = kEvent; i < kEvent + 10; ++i) {
    Scan& scan = scans[static_cast<std::size_t>(i)];
    const std::int64_t stamp_ns = scan.stamp_ns;
    scan = scans[kEvent - 1];
    scan.stamp_ns = stamp_ns;
  }
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (int i = kEvent + 3; i < kEvent + 10; ++i) {
    EXPECT_FALSE(all[static_cast<std::size_t>(i)].trusted());
  }
  EXPECT_TRUE(all.back().trusted()) << statuses(all);
  EXPECT_LT(end_error(all, all.back(), walk()), 0.05);
}

// The hall's mirror image is a hall as well, and times that run backwards bend a scan by little: it
// is how the beams turn that tells.
TEST(KnotFaults, WhatIsSweptTheOtherWayIsNotBelieved) {
  std::vector<Scan> backwards = walk_scans(), mirrored = walk_scans();
  for (std::size_t i = kEvent; i < kEvent + 10; ++i) {
    for (std::int32_t& time : backwards[i].times_ns) time = 100'000'000 - time;
    make_mirrored(mirrored[i]);
  }
  for (const std::vector<Scan>& scans : {backwards, mirrored}) {
    Odometry odometry;
    const auto all = add_scans(odometry, scans);
    EXPECT_NE(all[kEvent].message.find("turn the other way"), std::string::npos);
    for (std::size_t i = kEvent; i < kEvent + 10; ++i) EXPECT_FALSE(all[i].trusted()) << i;
    EXPECT_TRUE(all.back().trusted()) << statuses(all);
    EXPECT_EQ(all.back().segment, 0) << statuses(all);
    EXPECT_LT(end_error(all, all.back(), walk()), 0.05);
  }
}

TEST(KnotFaults, WhatStaysMirroredIsASegmentOfItsOwn) {
  Config config;
  config.knots.search_scans = 5;
  Odometry odometry(config);
  std::vector<Scan> scans = walk_scans();
  for (std::size_t i = kEvent; i < kFaultScans; ++i) make_mirrored(scans[i]);
  const auto all = add_scans(odometry, scans);
  EXPECT_EQ(all.back().segment, 1) << statuses(all);
  EXPECT_TRUE(all.back().trusted()) << statuses(all);
}

TEST(KnotFaults, WhatIsNotFoundAgainBeginsASegment) {
  Config config;
  config.knots.search_scans = 5;
  Odometry odometry(config);
  std::vector<Scan> scans = walk_scans();
  for (int i = kEvent; i < kFaultScans; ++i) {
    for (Eigen::Vector3f& point : scans[static_cast<std::size_t>(i)].points) {
      point = Eigen::Vector3f(2.5F * point.x(), 0.4F * point.y(), point.z());
    }
  }
  const auto all = add_scans(odometry, scans);
  EXPECT_EQ(all[kEvent - 1].segment, 0);
  EXPECT_EQ(all.back().segment, 1) << statuses(all);
  EXPECT_TRUE(all.back().trusted()) << statuses(all);
  for (int i = kEvent; i < kEvent + 5; ++i) {
    EXPECT_FALSE(all[static_cast<std::size_t>(i)].trusted());
  }
}

/// Which way is up was lost, too: the ground tells.
TEST(KnotFaults, ASegmentThatBeginsAfterASearchIsLevelAgain) {
  Config config;
  config.knots.search_scans = 5;
  Odometry odometry(config);
  std::vector<Scan> scans = walk_scans();
  const Eigen::Quaternionf tilt(Eigen::AngleAxisf(0.3F, Eigen::Vector3f::UnitX()));
  for (int i = kEvent; i < kFaultScans; ++i) {
    for (Eigen::Vector3f& point : scans[static_cast<std::size_t>(i)].points) {
      point = tilt.conjugate() * Eigen::Vector3f(2.5F * point.x(), 0.4F * point.y(), point.z());
    }
  }
  const auto all = add_scans(odometry, scans);
  ASSERT_EQ(all.back().segment, 1) << statuses(all);
  const Eigen::Vector3d ground = tilt.cast<double>().conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_GT((all.back().T_world_lidar.rotation * ground).z(), std::cos(0.05)) << statuses(all);
}

/// Whoever stood in the hall and left is emptied; who asks after a scan that is not trusted is not
/// told so again.
TEST(KnotFaults, AScanThatIsNotTrustedEmptiesNothing) {
  Scene visited = furnished_hall();
  visited.add(box_between({0.0, 0.2, 0.0}, {0.5, 0.8, 1.8}));
  std::vector<Scan> scans = take_scans(visited, walk(), 10);
  const std::vector<Scan> alone = take_scans(furnished_hall(), walk(), 20, {}, 10);
  scans.insert(scans.end(), alone.begin(), alone.end());
  for (const int threads : {1, 2}) {
    Odometry odometry({}, threads);
    std::size_t next = 0;
    do {
      ASSERT_LT(next + 1, scans.size());
      ASSERT_TRUE(odometry.add_scan(scans[next++]).trusted());
    } while (odometry.emptied_cubes().centres.empty());
    Scan garbage = scans[next];
    make_garbage(garbage);
    ASSERT_FALSE(odometry.add_scan(garbage).trusted());
    EXPECT_TRUE(odometry.emptied_cubes().centres.empty()) << threads;
  }
}

}  // namespace
}  // namespace surefoot
