// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/whereabouts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace surefoot {
namespace {

constexpr std::int64_t kTrustedNs = 5'000'000'000;

std::int64_t after(double seconds) {
  return kTrustedNs + static_cast<std::int64_t>(std::llround(1e9 * seconds));
}

PreparedScan scan_after(double seconds) {
  PreparedScan scan;
  scan.start_ns = after(seconds);
  scan.end_ns = after(seconds + 0.1);
  return scan;
}

/// Has walked up along x, steeply or on level ground, to where it is: at 1 m/s, looking ahead.
struct Walker {
  explicit Walker(double slope) {
    for (int i = 0; i <= 100; ++i) {
      last.translation = {0.1 * i - 10.0, 0.0, slope * 0.1 * i};
      way.add(last);
    }
    model.begin((Twist() << 1.0, 0.0, slope, 0.0, 0.0, 0.0).finished(), last.rotation);
  }
  [[nodiscard]] Whereabouts whereabouts(bool unseen = false) const {
    return {last, mount, kTrustedNs, kTrustedNs, model, way, 0.5, unseen};
  }

  Pose last;
  Eigen::Quaterniond mount = Eigen::Quaterniond::Identity();
  VelocityModel model{Config().knots};
  WalkedWay way;
};

const double kLevel = 0.0, kStairs = 0.6;

// However long its sweep took.
TEST(Whereabouts, AScanRightAfterTheLastOneIsAfterNoHole) {
  const Walker walker(kLevel);
  Whereabouts about = walker.whereabouts();
  about.trusted_end_ns = after(1.0);
  EXPECT_FALSE(about.is_after_hole(scan_after(1.0)));
  EXPECT_FALSE(about.is_after_hole(scan_after(1.4)));
  EXPECT_TRUE(about.is_after_short_hole(scan_after(1.6)));
  EXPECT_FALSE(about.is_after_short_hole(scan_after(6.1)));
}

// [K30] once more.
TEST(Whereabouts, GrowWithTheTimeUntilTheyAreLarge) {
  const Walker walker(kLevel);
  const Whereabouts about = walker.whereabouts();
  EXPECT_NEAR(about.carried(after(0.5)).radius, 1.0 + 5.0 * 0.5, 1e-9);
  EXPECT_NEAR(about.walked(after(2.0)).radius, 1.0 + 1.25 * 2.0, 1e-9);
  EXPECT_NEAR(about.walked(after(0.4)).turn, 0.5 + 1.5 * 0.4, 1e-9);
  EXPECT_EQ(about.carried(after(60.0)).radius, 25.0);
  EXPECT_EQ(about.carried(after(60.0)).turn, std::numbers::pi);
  EXPECT_EQ(about.carried(after(-3.0)).radius, 1.0) << "a scan from before grows nothing";
  EXPECT_EQ(about.anywhere().radius, 25.0);
  EXPECT_EQ(about.walked(after(2.0)).centre.translation, walker.last.translation);
}

TEST(Whereabouts, WhoStandsMayStillWalk) {
  Walker walker(kLevel);
  walker.model.begin(Twist::Zero(), walker.last.rotation);
  EXPECT_NEAR(walker.whereabouts().walked(after(2.0)).radius, 1.0 + 0.5 * 2.0, 1e-9);
}

TEST(Whereabouts, StraightOnIsOnTheGroundOrHigherForWhoClimbs) {
  const Walker walker(kStairs);
  const SearchRegion ahead = walker.whereabouts().straight_on(after(2.0));
  EXPECT_NEAR(ahead.centre.translation.x(), walker.last.translation.x() + 2.0, 1e-9);
  const Pose climbing = walker.whereabouts().climbing_on(after(2.0));
  EXPECT_EQ(climbing.translation.head<2>(), ahead.centre.translation.head<2>());
  EXPECT_NEAR(climbing.translation.z(), walker.last.translation.z() + 2.0 * kStairs, 1e-9);
}

TEST(Whereabouts, WhoClimbsIsNotFoundWhereHeCameFromUnlessHeWalkedUnseen) {
  const double anything = std::numeric_limits<double>::infinity();
  const Walker level(kLevel), climber(kStairs);
  EXPECT_EQ(level.whereabouts().walked(after(1.0)).below, anything);
  EXPECT_LT(climber.whereabouts().walked(after(1.0)).below,
            climber.whereabouts().walked(after(1.0)).above);
  EXPECT_EQ(climber.whereabouts(true).walked(after(1.0)).below, anything);

  EXPECT_FALSE(climber.whereabouts().may_be_a_storey_on(after(1.0)));
  EXPECT_TRUE(climber.whereabouts().may_be_a_storey_on(after(4.0)));
  EXPECT_FALSE(climber.whereabouts(true).may_be_a_storey_on(after(4.0)));
  EXPECT_FALSE(level.whereabouts().may_be_a_storey_on(after(4.0)));
}

TEST(Whereabouts, BehindIsFartherBackForWhoHasJustWalkedOnUnseen) {
  const Walker walker(kLevel);
  const Whereabouts about = walker.whereabouts();
  EXPECT_FALSE(about.is_after_hole(scan_after(0.4)));
  EXPECT_TRUE(about.is_after_short_hole(scan_after(2.0)));
  EXPECT_TRUE(about.is_after_hole(scan_after(6.0)));
  EXPECT_FALSE(about.is_after_short_hole(scan_after(6.0))) << "it may have turned";

  const auto at = [&](double x) {
    return Pose{walker.last.rotation, walker.last.translation + Eigen::Vector3d(x, 0.0, 0.0)};
  };
  EXPECT_TRUE(about.is_farther_back(at(-1.0), scan_after(2.0)));
  EXPECT_FALSE(about.is_farther_back(at(-0.5), scan_after(2.0))) << "the same place";
  EXPECT_FALSE(about.is_farther_back(at(2.0), scan_after(2.0)));
  EXPECT_FALSE(about.is_farther_back(at(-1.0), scan_after(0.4))) << "it was seen";
  EXPECT_FALSE(about.is_farther_back(at(-1.0), scan_after(6.0))) << "it may have turned";
}

// Where the region is large, it is gone through at every fifth scan: a walker's at one, whoever
// was carried at another.
TEST(Whereabouts, ALargeRegionHasItsTurn) {
  const Walker walker(kLevel);
  const Whereabouts about = walker.whereabouts();
  for (int scans = 0; scans < 10; ++scans) {
    const auto soon = about.of_turn(scans, after(0.5));
    ASSERT_TRUE(soon);
    EXPECT_EQ(soon->radius, about.carried(after(0.5)).radius);
    const auto later = about.of_turn(scans, after(3.0));
    ASSERT_TRUE(later);
    EXPECT_EQ(later->radius,
              scans % 5 == 4 ? about.carried(after(3.0)).radius : about.walked(after(3.0)).radius);
    EXPECT_EQ(about.of_turn(scans, after(10.0)).has_value(), scans % 5 == 4 || scans % 5 == 0);
  }
}

TEST(Whereabouts, WhoComesBackIsLookedForAlongTheWholeWay) {
  Walker walker(kLevel);
  for (int i = 0; i <= 400; ++i) {
    walker.last.translation = {0.1 * i, 0.0, 0.0};
    walker.way.add(walker.last);
  }
  const Whereabouts about = walker.whereabouts();
  for (int scans = 0; scans < 4; ++scans) {
    const SearchRegion region = about.come_back(scans);
    EXPECT_EQ(region.radius, 25.0);
    EXPECT_EQ(region.turn, std::numbers::pi);
    EXPECT_NEAR(region.centre.translation.x(), 40.0 - 25.0 * (scans % 3), 1.0) << scans;
  }
}

// It is the carrier that stands on the ground and turns about its own up.
TEST(Whereabouts, ATiltedMountIsTakenOutOfRegionsAndPutBackIntoPoses) {
  Walker walker(kLevel);
  walker.mount = Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitY());
  walker.last.rotation = walker.mount.conjugate();
  const Whereabouts about = walker.whereabouts();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_LT((about.anywhere().centre.rotation * up - up).norm(), 1e-9);
  EXPECT_LT((about.straight_on(after(1.0)).centre.rotation * up - up).norm(), 1e-9);
  const Pose going = about.going_straight_on(after(1.0));
  EXPECT_LT(going.rotation.angularDistance(walker.last.rotation), 1e-6);
}

}  // namespace
}  // namespace surefoot
