// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/association.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::stamped;

Trajectory at_times(std::initializer_list<double> times) {
  Trajectory trajectory;
  for (const double t : times) trajectory.push_back(stamped(t, {t, 0.0, 0.0}));
  return trajectory;
}

std::string message_of(const Trajectory& reference, const Trajectory& estimate,
                       const AssociationOptions& options) {
  try {
    (void)associate(reference, estimate, options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(Association, NearestStampWithinTheLimit) {
  const auto pairs = associate(at_times({0.0, 1.0, 2.0, 3.0}), at_times({0.9, 2.005, 5.0}),
                               {.max_difference = 0.1});
  ASSERT_EQ(pairs.estimate.size(), 2U);
  EXPECT_EQ(pairs.reference[0].stamp_ns, 1'000'000'000);
  EXPECT_EQ(pairs.estimate[0].stamp_ns, 900'000'000);
  EXPECT_EQ(pairs.reference[1].stamp_ns, 2'000'000'000);
}

TEST(Association, TheLimitItselfIsWithinAndOfTwoAtOneDistanceTheEarlierIsTaken) {
  const auto pairs = associate(at_times({1.0, 1.2}), at_times({1.1}), {.max_difference = 0.1});
  ASSERT_EQ(pairs.reference.size(), 1U);
  EXPECT_EQ(pairs.reference[0].stamp_ns, 1'000'000'000);
}

TEST(Association, WhatAWrongOffsetMakesOfTheStampsIsTold) {
  const Trajectory walk = at_times({10.0, 11.0});
  const std::string moved = message_of(walk, walk, {.offset = -100.0});
  EXPECT_NE(moved.find("by the offset of -100.000000 s to -90.000000 .. -89.000000 s"),
            std::string::npos)
      << moved;
  const std::string apart = message_of(walk, at_times({20.0}), {});
  EXPECT_EQ(apart.find("offset"), std::string::npos) << apart;
}

TEST(Association, StampsThatNoClockGivesAreRefused) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  const Trajectory far = {{-kLast, Pose()}, {kLast, Pose()}};
  EXPECT_NE(message_of(at_times({1.0}), far, {}).find("1970"), std::string::npos);
  EXPECT_NE(message_of(far, at_times({1.0}), {}).find("1970"), std::string::npos);
  // Nor does an offset bring a stamp there.
  const Trajectory edge = {{kLast / 2, Pose()}};
  EXPECT_NE(message_of(edge, edge, {.offset = 4e9}).find("no pose"), std::string::npos);
  EXPECT_NE(message_of(edge, edge, {.method = AssociationMethod::interpolate, .offset = 4e9})
                .find("no pose"),
            std::string::npos);
}

TEST(Association, GoesFromTheTrajectoryWithFewerPoses) {
  const auto pairs = associate(at_times({1.0}), at_times({0.99, 1.001, 1.008}), {});
  ASSERT_EQ(pairs.estimate.size(), 1U);
  EXPECT_EQ(pairs.estimate[0].stamp_ns, 1'001'000'000);
}

TEST(Association, OffsetIsAddedToTheEstimateInBothDirections) {
  const AssociationOptions options{.offset = 10.0};
  EXPECT_EQ(associate(at_times({10.0, 11.0, 12.0}), at_times({1.0}), options).reference[0].stamp_ns,
            11'000'000'000);
  EXPECT_EQ(associate(at_times({11.0}), at_times({0.0, 1.0, 2.0}), options).estimate[0].stamp_ns,
            1'000'000'000);
  const AssociationOptions between{
      .method = AssociationMethod::interpolate, .max_gap = 1.0, .offset = 10.0};
  const auto pairs = associate(at_times({10.0, 11.0, 12.0}), at_times({1.5}), between);
  EXPECT_NEAR(pairs.reference[0].pose.translation.x(), 11.5, 1e-12);
}

TEST(Association, ALimitLongerThanAllTimesIsNone) {
  const AssociationOptions options{.max_difference = 1e300};
  EXPECT_EQ(associate(at_times({1.0}), at_times({1000.0}), options).estimate.size(), 1U);
}

TEST(Association, InterpolatesTheReferenceBetweenItsNeighbours) {
  Trajectory reference = at_times({0.0, 1.0, 2.0});
  reference[1].pose.rotation = from_roll_pitch_yaw({0.0, 0.0, 0.4});
  const auto pairs = associate(reference, at_times({-0.5, 0.25, 1.0, 1.75, 2.5}),
                               {.method = AssociationMethod::interpolate, .max_gap = 1.0});
  ASSERT_EQ(pairs.reference.size(), 3U) << "never beyond the reference's ends";
  EXPECT_NEAR(pairs.reference[0].pose.translation.x(), 0.25, 1e-12);
  EXPECT_NEAR(roll_pitch_yaw(pairs.reference[0].pose.rotation).z(), 0.1, 1e-12);
  EXPECT_NEAR(pairs.reference[1].pose.translation.x(), 1.0, 1e-12);
  EXPECT_NEAR(roll_pitch_yaw(pairs.reference[2].pose.rotation).z(), 0.1, 1e-12);
}

TEST(Association, DoesNotInterpolateOverAHoleInTheReference) {
  const auto pairs = associate(at_times({0.0, 0.2, 3.0, 3.2}), at_times({0.1, 1.5, 3.1}),
                               {.method = AssociationMethod::interpolate});
  ASSERT_EQ(pairs.estimate.size(), 2U);
  EXPECT_EQ(pairs.estimate[1].stamp_ns, 3'100'000'000);
}

TEST(Association, RepeatedStampsInterpolateWithoutDividingByZero) {
  const auto pairs = associate(at_times({0.0, 1.0, 1.0, 2.0}), at_times({1.0, 1.5}),
                               {.method = AssociationMethod::interpolate, .max_gap = 1.0});
  ASSERT_EQ(pairs.reference.size(), 2U);
  EXPECT_TRUE(pairs.reference[0].pose.translation.allFinite());
}

TEST(Association, ByIndexNeedsOneToOne) {
  const AssociationOptions options{.method = AssociationMethod::index};
  EXPECT_EQ(associate(at_times({0.0, 1.0}), at_times({7.0, 6.0}), options).estimate.size(), 2U);
  EXPECT_NE(message_of(at_times({0.0}), at_times({0.0, 1.0}), options).find("1 poses"),
            std::string::npos);
}

TEST(Association, SaysWhatIsWrong) {
  const Trajectory good = at_times({0.0, 1.0});
  EXPECT_EQ(message_of({}, good, {}), "the reference has no poses");
  EXPECT_EQ(message_of(good, {}, {}), "the estimate has no poses");
  EXPECT_EQ(message_of(good, at_times({1.0, 0.5}), {}),
            "pose 1 of the estimate is stamped 0.500000 s before the pose that precedes it");
  Trajectory bad = good;
  bad[1].pose.translation.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(good, bad, {}), "pose 1 of the estimate is not finite");
  const std::string apart = message_of(good, at_times({100.0, 101.0}), {});
  EXPECT_NE(apart.find("100.0"), std::string::npos) << apart;
}

}  // namespace
}  // namespace surefoot::evaluation
