// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/walked_way.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/so3.hpp"

namespace surefoot {
namespace {

constexpr double kSlope = 0.3;  // [rad]

/// Up a slope along x, on which the robot sways.
Pose on_slope(double x, int scan) {
  const Eigen::Vector3d sway(0.06 * (scan % 2 == 0 ? 1.0 : -1.0), -kSlope, 0.0);
  return {so3_exp(sway), {x, 0.0, 0.45 + x * std::tan(kSlope)}};
}

WalkedWay way_up_the_slope() {
  WalkedWay way;
  for (int scan = 0; scan < 200; ++scan) way.add(on_slope(0.1 * scan, scan));
  return way;
}

TEST(WalkedWay, WhoIsPutDownBesideItStandsOnItsGround) {
  const WalkedWay way = way_up_the_slope();
  for (const double yaw : {0.0, 1.0, -2.5}) {
    const Pose pose = way.stand_at({12.4, 3.0, 4.0}, yaw);
    EXPECT_NEAR(pose.translation.x(), 12.4, 1e-12);
    EXPECT_NEAR(pose.translation.y(), 3.0, 1e-12);
    EXPECT_NEAR(pose.translation.z(), 0.45 + 12.4 * std::tan(kSlope), 0.15);
    const Eigen::Vector3d up = pose.rotation * Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(up.x(), -std::sin(kSlope), 0.02);
    EXPECT_NEAR(up.y(), 0.0, 0.03) << "the sway is averaged away";
    const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), yaw, 0.06);
  }
}

TEST(WalkedWay, BeyondItsEndTheGroundGoesOn) {
  const Pose pose = way_up_the_slope().stand_at({22.0, 0.0, 6.0}, 0.0);
  EXPECT_NEAR(pose.translation.z(), 0.45 + 22.0 * std::tan(kSlope), 0.15);
}

TEST(WalkedWay, ForgetsWhatIsFar) {
  WalkedWay way = way_up_the_slope();
  way.remove_far({0.0, 0.0, 0.0}, 5.0);
  // Of what is left the last stands 4 m up the way; from there the plane goes on.
  EXPECT_NEAR(way.stand_at({4.0, 0.0, 1.5}, 0.0).translation.z(), 0.45 + 4.0 * std::tan(kSlope),
              0.1);
  way.begin({Eigen::Quaterniond::Identity(), {1.0, 2.0, 7.0}}, true);
  EXPECT_EQ(way.stand_at({100.0, 50.0, 0.0}, 0.0).translation, Eigen::Vector3d(100.0, 50.0, 7.0));
}

TEST(WalkedWay, PlacesApartAreTheLastOneAndThoseBefore) {
  WalkedWay way;
  for (int scan = 0; scan <= 200; ++scan) {
    way.add({Eigen::Quaterniond::Identity(), {0.1 * scan, 0.0, 0.0}});
  }
  const auto places = way.places_apart(8.0);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0].x(), 20.0, 1.0);
  EXPECT_NEAR(places[1].x(), 12.0, 1.0);
  EXPECT_NEAR(places[2].x(), 4.0, 1.0);
  EXPECT_TRUE(WalkedWay().places_apart(8.0).empty());
}

TEST(WalkedWay, ItIsTheNearestInThePlaneHoweverHigh) {
  WalkedWay way;
  way.add({Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.4}});
  way.add({Eigen::Quaterniond::Identity(), {6.0, 0.0, 3.4}});
  EXPECT_EQ(way.stand_at({5.0, 0.0, 0.4}, 0.0).translation.z(), 3.4);
  EXPECT_EQ(way.stands_at({5.0, 0.0}, 0.0).size(), 1U);
}

TEST(WalkedWay, FlightsOverEachOtherAreStoreys) {
  WalkedWay way;
  for (int i = 0; i < 3; ++i) {  // side by side, each 1.6 m higher
    way.add({Eigen::Quaterniond::Identity(), {0.0, 1.2 * (i % 2), 0.4 + 1.6 * i}});
  }
  EXPECT_EQ(way.stands_at({0.0, 0.5}, 0.0).size(), 3U);
  EXPECT_EQ(way.stand_at({0.0, 0.5, 0.9}, 0.0).translation.z(), 0.4);
  EXPECT_EQ(way.stand_at({0.0, 0.5, 3.0}, 0.0).translation.z(), 3.6);
  EXPECT_TRUE(way.has_storeys({0.0, 0.0, 0.0}, 2.0));
  EXPECT_FALSE(way.has_storeys({5.0, 0.0, 0.0}, 2.0)) << "they are not near";
}

// What lies beyond the first one that is climbed looks as what lies before it, and is not known
// yet.
TEST(WalkedWay, AFlightOfStairsLeadsToAnother) {
  const auto flight = [](double slope) {
    WalkedWay way;
    for (int i = 0; i < 40; ++i) {
      const double x = 0.1 * i;
      way.add({Eigen::Quaterniond::Identity(), {x, 0.0, slope * x}});
    }
    return way;
  };
  EXPECT_TRUE(flight(0.17 / 0.28).has_storeys({4.0, 0.0, 2.4}, 5.0));
  EXPECT_FALSE(flight(0.17 / 0.28).has_storeys({4.0, 0.0, 2.4}, 1.0)) << "it is not near";
  EXPECT_FALSE(flight(0.36).has_storeys({4.0, 0.0, 1.4}, 5.0)) << "a steep path";
}

// Up a flight and back down: whoever turned round does not climb, though he has been there before.
TEST(WalkedWay, TellsWhetherItClimbsOfLate) {
  WalkedWay way;
  EXPECT_EQ(way.climb_of_late(), 0.0);
  const auto go = [&](double from, double to) {
    for (int i = 0; i <= 100; ++i) {
      const double x = from + 0.01 * i * (to - from);
      way.add({Eigen::Quaterniond::Identity(), {x, 0.0, 0.6 * std::clamp(x, 0.0, 4.0)}});
    }
  };
  go(-8.0, 0.0);
  EXPECT_EQ(way.climb_of_late(), 0.0);
  go(0.0, 4.0);
  EXPECT_GT(way.climb_of_late(), 1.5);
  go(4.0, 12.0);
  EXPECT_EQ(way.climb_of_late(), 0.0) << "a landing is behind it";
  go(12.0, 0.0);
  EXPECT_LT(way.climb_of_late(), -1.5);
  way.begin({}, true);
  EXPECT_EQ(way.climb_of_late(), 0.0);
  EXPECT_EQ(way_up_the_slope().climb_of_late(), 0.0) << "no flight";
}

// Nine steps, run up in eight scans: between places a metre apart too little of them is steep.
TEST(WalkedWay, AShortFlightIsOneHoweverFastItIsRunUp) {
  for (int phase = 0; phase < 48; ++phase) {
    WalkedWay way;
    for (int i = 0; i < 26; ++i) {
      const double x = 0.32 * i + 0.02 * phase - 4.5;
      way.add({Eigen::Quaterniond::Identity(), {x, 0.0, 0.55 * std::clamp(x, 0.0, 2.6)}});
    }
    EXPECT_GT(way.climb_of_late(), 1.3) << phase;
  }
}

TEST(WalkedWay, ASlopeHasNoStoreys) {
  const WalkedWay way = way_up_the_slope();
  EXPECT_EQ(way.stands_at({12.4, 3.0}, 0.0).size(), 1U);
  EXPECT_FALSE(way.has_storeys({10.0, 0.0, 3.5}, 20.0));
}

/// A slope that is walked, in a map that is tilted by 22 degrees: there it is as steep as stairs.
WalkedWay way_in_a_tilted_map(bool is_levelled) {
  const Eigen::Quaterniond tilt = so3_exp({0.0, -0.38, 0.0});
  WalkedWay way;
  way.begin({}, is_levelled);
  for (int scan = 0; scan < 200; ++scan) {
    const Pose pose = on_slope(0.1 * scan, scan);
    way.add({tilt * pose.rotation, tilt * pose.translation});
  }
  return way;
}

TEST(WalkedWay, ASlopeIsNoStairsInAMapThatIsNotLevelled) {
  const WalkedWay levelled = way_in_a_tilted_map(true), tilted = way_in_a_tilted_map(false);
  EXPECT_TRUE(levelled.has_storeys({10.0, 0.0, 3.5}, 20.0));
  EXPECT_GT(levelled.climb_of_late(), 1.0);
  EXPECT_FALSE(tilted.has_storeys({10.0, 0.0, 3.5}, 20.0));
  EXPECT_EQ(tilted.climb_of_late(), 0.0);
}

}  // namespace
}  // namespace surefoot
