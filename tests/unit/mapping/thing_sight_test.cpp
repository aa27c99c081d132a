// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/thing_sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "mapping/piece.hpp"

namespace surefoot::mapping {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// A level floor from -8 to 8 m, at z = 0, and a flat hill of half a metre from x = 4 on.
PieceGround floor_and_hill() {
  Submap submap;
  for (float x = -8.0F; x < 8.0F; x += 0.25F) {
    for (float y = -8.0F; y < 8.0F; y += 0.25F) {
      submap.points.emplace_back(x, y, x < 4.0F ? 0.0F : 0.5F);
    }
  }
  return PieceGround(submap);
}

KeptScan look_at(std::int64_t stamp_ns, const std::vector<Eigen::Vector3f>& points) {
  return {stamp_ns, {0.0F, 0.0F, 1.0F}, points};
}

TEST(PieceGround, StandsOutWhatIsHigherThanAllAboutIt) {
  const PieceGround ground = floor_and_hill();
  EXPECT_NEAR(ground.height({2.0F, 0.0F, 1.5F}), 1.5F, 1e-5F);
  EXPECT_FALSE(ground.stands({2.0F, 0.0F, 0.2F}));
  EXPECT_TRUE(ground.stands({2.0F, 0.0F, 0.3F}));
  EXPECT_FALSE(ground.stands({6.5F, 0.0F, 0.6F})) << "the hill's top is ground, too";
  EXPECT_TRUE(ground.stands({6.5F, 0.0F, 0.9F}));
  EXPECT_TRUE(ground.stands({20.0F, 0.0F, 0.6F})) << "where no ground was seen";
}

TEST(ThingSight, CountsTheMomentsOfBothKinds) {
  const Eigen::Vector3f thing(3.0F, 0.0F, 1.0F), behind(7.0F, 0.0F, 1.0F);
  std::vector<KeptScan> looks;
  for (int i = 0; i < 6; ++i) looks.push_back(look_at(i * kSecond, {i < 2 ? thing : behind}));
  looks.push_back(look_at(5 * kSecond + 1, {behind}));  // the same moment as the last
  const ThingSight sight(seen_in(looks, floor_and_hill()));
  EXPECT_EQ(sight.at(thing.cast<double>()).hit, 2);
  EXPECT_EQ(sight.at(thing.cast<double>()).through, 4);
  EXPECT_EQ(sight.at({1.5, 0.0, 1.0}).through, 6);
  EXPECT_EQ(sight.at({2.7, 0.0, 1.0}).through, 4) << "something stood beside it";
  EXPECT_EQ(sight.at({6.6, 0.0, 1.0}).through, 0) << "too near to where beams ended";
  EXPECT_EQ(sight.at({3.0, 0.0, 1.5}).through, 0) << "nobody looked";
}

/// What a beam ends at is hit; a cube that it reaches just before was not looked through.
TEST(ThingSight, AsksNoBeamFartherThanItTells) {
  const auto sight = [](const Eigen::Vector3f& end) {
    return ThingSight(seen_in({look_at(0, {end})}, floor_and_hill()));
  };
  const ThingSight wall = sight({7.0F, 0.0F, 1.0F});
  EXPECT_EQ(wall.at({6.2, 0.0, 1.0}).through, 1);
  EXPECT_EQ(wall.at({6.55, 0.0, 1.0}).through, 0);
  const ThingSight far = sight({74.0F, 0.0F, 1.0F});
  EXPECT_EQ(far.at({69.0, 0.0, 1.0}).through, 1);
  EXPECT_EQ(far.at({72.0, 0.0, 1.0}).through, 0);
  EXPECT_EQ(far.at({74.0, 0.0, 1.0}).hit, 0);
  EXPECT_EQ(sight({69.0F, 0.0F, 1.0F}).at({69.0, 0.0, 1.0}).hit, 1);
  EXPECT_EQ(sight({5.0F, 0.0F, 2.7F}).at({5.0, 0.0, 2.7}).hit, 1);
  EXPECT_EQ(sight({3.0F, 0.0F, 2.9F}).at({3.0, 0.0, 2.9}).hit, 0) << "where nobody walks";
}

/// Within one moment a hit counts, however many beams went through.
TEST(ThingSight, WhatWasHitIsNotSeenThroughInThatMoment) {
  const Eigen::Vector3f thing(3.0F, 0.0F, 1.0F), behind(7.0F, 0.0F, 1.0F);
  const ThingSight sight(seen_in(
      {look_at(0, {thing, behind, behind}), look_at(kSecond / 10, {behind})}, floor_and_hill()));
  EXPECT_EQ(sight.at(thing.cast<double>()).hit, 1);
  EXPECT_EQ(sight.at(thing.cast<double>()).through, 0);
}

/// The ground under a cube is nothing that stands beside it, but is itself something that was hit.
TEST(ThingSight, TheGroundHidesNothing) {
  const Eigen::Vector3f low(3.1F, 0.0F, 0.02F), behind(6.0F, 0.0F, -0.26F);
  const Eigen::Vector3d above_low(3.1, 0.0, 0.35);  // there the beam passes
  const ThingSight sight(seen_in({look_at(0, {low, behind})}, floor_and_hill()));
  EXPECT_EQ(sight.at(low.cast<double>()).hit, 1);
  EXPECT_EQ(sight.at(above_low).through, 1);
  const Eigen::Vector3f standing(3.1F, 0.0F, 0.55F);
  const ThingSight beside(seen_in({look_at(0, {standing, behind})}, floor_and_hill()));
  EXPECT_EQ(beside.at(above_low).through, 0);
}

/// Not all beams are followed from the start, but no cube on the way is left out.
TEST(ThingSight, AWholeTurnOfBeamsLeavesNoCubeOut) {
  constexpr int kColumns = 1800, kRings = 16;
  constexpr float kPi = 3.14159265F, kWall = 30.0F;
  KeptScan turn{0, {0.0F, 0.0F, 1.0F}, {}};
  for (int i = 0; i < kColumns * kRings; ++i) {
    const float azimuth = 2.0F * kPi * static_cast<float>(i / kRings) / kColumns;
    const float height = 1.0F + 0.1F * (static_cast<float>(i % kRings) - 7.5F);
    turn.points.emplace_back(kWall * std::cos(azimuth), kWall * std::sin(azimuth), height);
  }
  const ThingSight sight(seen_in({turn}, floor_and_hill()));
  for (double range = 0.5; range < 29.0; range += 0.5) {
    for (int i = 0; i < 360; ++i) {
      const double azimuth = 2.0 * static_cast<double>(kPi) * i / 360.0;
      const Eigen::Vector3d place(range * std::cos(azimuth), range * std::sin(azimuth), 1.0);
      EXPECT_EQ(sight.at(place).through, 1) << range << " m away at " << i << " degrees";
    }
  }
}

/// A robot that stands for a minute has no more moments than one that walks.
TEST(ThingSight, HasFifteenMomentsAtMost) {
  std::vector<KeptScan> looks;
  for (int i = 0; i < 60; ++i) looks.push_back(look_at(i * kSecond, {{7.0F, 0.0F, 1.0F}}));
  const ThingSight sight(seen_in(looks, floor_and_hill()));
  EXPECT_EQ(sight.at({3.0, 0.0, 1.0}).through, 15);
}

TEST(ThingSight, RefusesOtherBytes) {
  EXPECT_THROW(ThingSight("1"), std::invalid_argument);
  EXPECT_THROW(ThingSight(std::string(40, '\x7f')), std::invalid_argument);
  const ThingSight nothing(seen_in({}, floor_and_hill()));
  EXPECT_EQ(nothing.at({1.0, 0.0, 1.0}).through, 0);
}

}  // namespace
}  // namespace surefoot::mapping
