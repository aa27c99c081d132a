// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_agreement.hpp"

#include <gtest/gtest.h>

namespace surefoot::mapping {
namespace {

const Eigen::Vector3d kHere(40.0, 0.0, 0.0);

bool add_to(PlaceAgreement& agreement, double fit, double way, double x = 0.0) {
  Pose T_map_world;
  T_map_world.translation.x() = x;
  return agreement.add(T_map_world, fit, way, kHere, {});
}

/// Searches until it is enough, 0.5 m apart.
int searches_until_enough(double fit) {
  PlaceAgreement agreement({});
  for (int i = 1; i < 100; ++i) {
    if (add_to(agreement, fit, 0.5 * i)) return i;
  }
  return 100;
}

TEST(PlaceAgreement, TheLessAPlaceFitsTheMoreSearchesHaveToSayIt) {
  EXPECT_EQ(searches_until_enough(0.9), 3);
  EXPECT_EQ(searches_until_enough(0.53), 4);
  EXPECT_EQ(searches_until_enough(0.46), 9);
  EXPECT_EQ(searches_until_enough(0.4), 100);
}

TEST(PlaceAgreement, WhileTheRobotStandsAPlaceHasToFitWell) {
  PlaceAgreement standing({});
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(add_to(standing, 0.54, 0.0));
  EXPECT_FALSE(add_to(standing, 0.54, 0.9));
  EXPECT_TRUE(add_to(standing, 0.54, 1.1));
  PlaceAgreement fits({});
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(add_to(fits, 0.56, 0.0));
  EXPECT_TRUE(add_to(fits, 0.56, 0.0));
  PlaceAgreement in_the_mean({});
  EXPECT_FALSE(add_to(in_the_mean, 0.45, 0.0));
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(in_the_mean, 0.59, 0.0));
  EXPECT_TRUE(add_to(in_the_mean, 0.59, 0.0));
}

/// What is asked once more where less of it is in sight may fit: it is the same wrong place.
TEST(PlaceAgreement, WhereWallsWereMissingIsNoPlaceForAWhile) {
  PlaceAgreement agreement({});
  Pose T_map_world;
  agreement.add_missing(T_map_world, 0.14, 0.0);
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0));
  EXPECT_TRUE(add_to(agreement, 0.9, 0.0));
  agreement.add_missing(T_map_world, 0.16, 0.0);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 9.9));
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 9.9, 0.4));
  EXPECT_TRUE(add_to(agreement, 0.9, 9.9, 0.4)) << "another one";
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 10.1));
  EXPECT_TRUE(add_to(agreement, 0.9, 10.1));
}

/// Who stands for hours asks the same places, over and over.
TEST(PlaceAgreement, OfManyPlacesWithoutWallsTheLastThousandAreRemembered) {
  PlaceAgreement agreement({});
  const auto missing_at = [&](int x) {
    Pose T_map_world;
    T_map_world.translation.x() = x;
    agreement.add_missing(T_map_world, 0.16, 0.0);
  };
  for (int x = 0; x <= 1000; ++x) missing_at(x);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0, 1.0));
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0, 1000.0));
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0, 0.0));
  EXPECT_TRUE(add_to(agreement, 0.9, 0.0, 0.0)) << "the oldest of 1001";
}

TEST(PlaceAgreement, AnotherPlaceBeginsAnew) {
  PlaceAgreement agreement({});
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0));
  EXPECT_FALSE(add_to(agreement, 0.9, 0.0, 0.4));
  EXPECT_FALSE(add_to(agreement, 0.9, 0.0, 0.5)) << "the same as the last one";
  EXPECT_TRUE(add_to(agreement, 0.9, 0.0, 0.6));
}

TEST(PlaceAgreement, OneSearchMaySayNothingTwoMayNot) {
  PlaceAgreement agreement({});
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(add_to(agreement, 0.7, 0.0));
    agreement.add_silence();
  }
  EXPECT_TRUE(add_to(agreement, 0.7, 0.0));
  for (int i = 0; i < 2; ++i) agreement.add_silence();
  EXPECT_FALSE(add_to(agreement, 0.7, 0.0));
  EXPECT_FALSE(add_to(agreement, 0.7, 0.0));
  agreement.forget();
  EXPECT_FALSE(add_to(agreement, 0.7, 0.0));
}

TEST(PlaceAgreement, AfterPlacesWereAlikeOtherThingsHaveToBeSeen) {
  PlaceAgreement agreement({});
  agreement.add_alike(0.0);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.39 * i));
  EXPECT_TRUE(add_to(agreement, 0.9, 4.1));
}

/// In another world the same numbers are another place.
TEST(PlaceAgreement, BegunAnewItRemembersNothing) {
  PlaceAgreement agreement({});
  agreement.add_missing(Pose(), 0.16, 0.0);
  agreement.add_alike(0.0);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0));
  agreement.begin_anew();
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(add_to(agreement, 0.9, 0.0));
  EXPECT_TRUE(add_to(agreement, 0.9, 0.0));
}

}  // namespace
}  // namespace surefoot::mapping
