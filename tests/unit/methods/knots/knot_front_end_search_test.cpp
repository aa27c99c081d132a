// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Who is lost looks for his place: what tells of one, and what does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "fault_walk.hpp"
#include "geometry/so3.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

/// Carried back along the way and turned round, farther than any walker comes meanwhile: a place
/// there fits at least e times as well, and is asked for.
TEST(KnotFrontEndSearch, CarriedFarBackItSeesThatItFitsThere) {
  constexpr int kWalked = 40;
  const MotionFunction motion =
      constant_velocity(kFaultStart, (Twist() << 1.5, 0, 0, 0, 0, 0).finished());
  std::vector<Scan> scans = take_scans(furnished_hall(), motion, kWalked);
  const MotionFunction away = standing({so3_exp({0.0, 0.0, 3.1}), {-4.5, 2.5, 0.45}});
  scans.push_back(take_scans(furnished_hall(), away, 1, {}, kWalked)[0]);
  Odometry odometry;
  const Estimate last = add_scans(odometry, scans).back();
  EXPECT_EQ(last.status, Status::lost);
  EXPECT_GT(last.evidence.rival, 1.0);
}

/// The same scan once more tells nothing new: not that the search for its place is in vain.
TEST(KnotFrontEndSearch, AFrozenSensorBeginsNoSegment) {
  Config config;
  config.knots.search_scans = 5;
  std::vector<Scan> scans = walk_scans();
  constexpr std::size_t kThaws = kEvent + 15;
  for (std::size_t i = kEvent; i < scans.size(); ++i) {
    if (i > kEvent && i < kThaws) scans[i].points = scans[kEvent].points;
    if (i > kEvent && i < kThaws) continue;
    for (Eigen::Vector3f& p : scans[i].points) {
      p = Eigen::Vector3f(2.5F * p.x(), 0.4F * p.y(), p.z());
    }
  }
  Odometry odometry(config);
  const auto all = add_scans(odometry, scans);
  for (std::size_t i = kEvent; i < kThaws; ++i) {
    EXPECT_FALSE(all[i].trusted()) << i;
    EXPECT_EQ(all[i].segment, 0) << i;
  }
  EXPECT_EQ(all.back().segment, 1) << statuses(all);
}

/// A place is believed that so many scans in a row name.
TEST(KnotFrontEndSearch, AScanThatNamesNoPlaceIsBetweenThoseThatAgree) {
  const MotionFunction motion = carried({Eigen::Quaterniond::Identity(), {2.0, 1.5, 0.0}});
  std::vector<Scan> scans = take_scans(furnished_hall(), motion, kEvent + 8);
  const auto found_at = [&] {
    Odometry odometry;
    const auto all = add_scans(odometry, scans);
    const auto found = std::find_if(all.begin(), all.end(), [](const Estimate& estimate) {
      return estimate.message == "found itself again";
    });
    return found - all.begin();
  };
  const auto usually = found_at();
  ASSERT_LT(usually, kEvent + 5);
  const auto garbage = static_cast<std::size_t>(usually) - 1;
  make_garbage(scans[garbage]);
  EXPECT_GE(found_at(), garbage + 3);
}

/// In a hall no other place fits nearly as well as the true one: that speaks for it.
TEST(KnotFrontEndSearch, ThatNoOtherPlaceFitsSpeaksForOne) {
  const MotionFunction motion = carried({so3_exp({0.0, 0.0, 1.0}), {-1.5, 1.0, 0.0}});
  Odometry odometry;
  const auto all = add_scans(odometry, take_scans(furnished_hall(), motion, kEvent + 15));
  const auto found = std::find_if(all.begin(), all.end(), [](const Estimate& estimate) {
    return estimate.message == "found itself again";
  });
  ASSERT_NE(found, all.end()) << statuses(all);
  EXPECT_LT(found->evidence.rival, -0.5);
  EXPECT_GE((found + 1)->evidence.rival, 0.0) << "it is not lost any more";
}

/// A hall that looks the same turned by half a turn: every place has its twin, as good as it.
Scene half_turned_hall() {
  Scene hall;
  hall.add(box_between({-12.0, -8.0, 0.0}, {12.0, 8.0, 6.0}));
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d half(0.3 + 0.1 * (i % 2), 0.4, 1.0 + 0.2 * (i % 4));
    const Pose stand{so3_exp({0.0, 0.0, 0.3 * i}), {1.0 + 1.7 * i, 2.0 + 0.9 * (i % 3), half.z()}};
    hall.add({stand, half}).add({Pose{so3_exp({0.0, 0.0, std::numbers::pi})} * stand, half});
  }
  return hall;
}

/// Who was carried there may be at either place, and is told to be at neither. Put back, no single
/// scan is believed for being where who goes straight on would be, as after one scan of garbage.
TEST(KnotFrontEndSearch, WhoMayBeAtATwinIsBelievedAtNeither) {
  constexpr int kCarried = 4;
  const MotionFunction ahead =
      constant_velocity({Eigen::Quaterniond::Identity(), {-0.5, 0.0, 0.45}},
                        (Twist() << 0.5, 0, 0, 0, 0, 0).finished());
  const Pose there{so3_exp({0.0, 0.0, 0.5}), {0.0, 0.9, 0.45}}, back = ahead(0.1 * kEvent);
  const MotionFunction motion = [&](double t) {
    if (t < 0.1 * kEvent) return ahead(t);
    return t < 0.1 * (kEvent + kCarried) ? there : back;
  };
  Odometry odometry;
  const auto all =
      add_scans(odometry, take_scans(half_turned_hall(), motion, kEvent + kCarried + 10));
  for (std::size_t i = kEvent; i < kEvent + kCarried + 2; ++i) {
    EXPECT_FALSE(all[i].trusted()) << i << ": " << statuses(all);
  }
  EXPECT_TRUE(all.back().trusted()) << statuses(all);
  const Pose moved = all.front().T_world_lidar.inverse() * all.back().T_world_lidar;
  EXPECT_LT(distance(moved, motion(0.05).inverse() * back), 0.05);
}

}  // namespace
}  // namespace surefoot
