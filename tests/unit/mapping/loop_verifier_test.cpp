// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_verifier.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace surefoot::mapping {
namespace {

/// Pillars and walls of a car park from its lowest floor to its roof, and some of a floor.
Submap storey(float from_x, float to_x) {
  Submap submap;
  const Eigen::Vector3f eye(0.0F, 0.0F, 0.5F);
  const auto see = [&](float x, float y, float z) {
    submap.points.emplace_back(x, y, z);
    submap.eyes.push_back(eye);
  };
  for (float z = -3.0F; z < 6.0F; z += 0.15F) {
    for (float s = -9.0F; s < 12.0F; s += 0.15F) {
      see(s, -9.0F, z);
      see(-9.0F, s, z);
    }
    for (float x = -7.0F; x < 8.0F; x += 5.0F) {
      for (float s = 0.0F; s < 0.5F; s += 0.15F) {
        see(x + s, 4.0F, z);
        see(x, 4.0F + s, z);
      }
    }
  }
  for (float x = from_x; x < to_x; x += 0.15F) {
    for (float y = -9.0F; y < 8.0F; y += 0.15F) see(x, y, 0.0F);
  }
  submap.covariance = 1e-6 * Matrix6::Identity();
  return submap;
}

TEST(LoopVerifier, WhatStandsAloneIsNoCommonPlace) {
  const VerifiableSubmap here(storey(-9.0F, -1.0F));
  const LoopCheck same = check_places(here, here, {Pose{}}, LoopLimits{});
  EXPECT_EQ(same.verdict, LoopVerdict::taken);
  EXPECT_GT(same.level, 0.9);
  const VerifiableSubmap above(storey(2.0F, 12.0F));
  const LoopCheck other = check_places(here, above, {Pose{}}, LoopLimits{});
  EXPECT_GT(other.overlap, 0.6);
  EXPECT_LT(other.level, 0.1);
  EXPECT_EQ(other.verdict, LoopVerdict::no_overlap);
}

/// Two walls, one of them set back from its middle on, and ground; and as told a house beyond the
/// ground, where else is sky.
Submap corner(bool house, float set_back = 0.0F) {
  Submap submap;
  const auto see = [&](float x, float y, float z) {
    submap.points.emplace_back(x, y, z);
    submap.eyes.emplace_back(0.0F, 0.0F, 0.5F);
  };
  for (float s = -9.0F; s < 9.0F; s += 0.15F) {
    for (float z = 0.0F; z < 5.0F; z += 0.15F) {
      see(s, s < 0.0F ? 9.0F : 9.0F + set_back, z);
      see(9.0F, s, z);
    }
    for (float t = -9.0F; t < 9.0F; t += 0.15F) see(s, t, 0.0F);
  }
  for (float s = -6.0F; house && s < 6.0F; s += 0.15F) {
    for (float z = 0.0F; z < 5.0F; z += 0.15F) see(s, -20.0F, z);
  }
  submap.covariance = 1e-6 * Matrix6::Identity();
  return submap;
}

TEST(LoopVerifier, AHouseThatIsMissingRefutes) {
  const VerifiableSubmap bare(corner(false));
  const VerifiableSubmap built(corner(true));
  LoopLimits limits;
  const LoopCheck unasked = check_places(bare, built, {Pose{}}, limits);
  EXPECT_EQ(unasked.verdict, LoopVerdict::taken);
  EXPECT_EQ(unasked.missing, 0.0);
  limits.partial = true;
  limits.missing = 0.06;
  EXPECT_EQ(check_places(built, built, {Pose{}}, limits).verdict, LoopVerdict::taken);
  for (const auto& [place, query] : {std::pair(&bare, &built), std::pair(&built, &bare)}) {
    const LoopCheck check = check_places(*place, *query, {Pose{}}, limits);
    EXPECT_EQ(check.verdict, LoopVerdict::free_space);
    EXPECT_GT(check.overlap, 0.6);
    EXPECT_LT(check.contradicted, 0.01);
    EXPECT_NEAR(check.missing, 12.0 / 48.0, 0.05);
  }
}

/// A house far away has few points, and is no less a house.
TEST(LoopVerifier, AHouseFarAwayRefutesByItself) {
  const VerifiableSubmap bare(corner(false));
  Submap with_house = corner(false);
  for (float s = -2.0F; s < 2.0F; s += 0.2F) {
    for (float z = 0.0F; z < 3.0F; z += 0.2F) {
      with_house.points.emplace_back(s, -32.0F, z);
      with_house.eyes.emplace_back(0.0F, 0.0F, 0.5F);
    }
  }
  const double missing = missing_between(bare, VerifiableSubmap(with_house), Pose{});
  EXPECT_GT(missing, 0.4);
  EXPECT_LT(missing, 0.5);
}

TEST(LoopVerifier, AWallThatStandsFartherBackRefutes) {
  const VerifiableSubmap place(corner(false));
  const auto check_with = [&](float set_back, const LoopLimits& limits) {
    return check_places(place, VerifiableSubmap(corner(false, set_back)), {Pose{}}, limits);
  };
  LoopLimits limits;
  limits.partial = true;
  limits.contradicted = 1.0;  // so near free space mostly says nothing
  EXPECT_EQ(check_with(0.6F, limits).verdict, LoopVerdict::taken);
  limits.beside = 0.1;
  EXPECT_EQ(check_with(0.15F, limits).verdict, LoopVerdict::taken);
  const LoopCheck more = check_places(place, VerifiableSubmap(corner(true)), {Pose{}}, limits);
  EXPECT_EQ(more.beside, 0.0) << "a house beside which no wall stands";
  for (const float set_back : {0.6F, -0.6F, 1.2F}) {
    const LoopCheck check = check_with(set_back, limits);
    EXPECT_EQ(check.verdict, LoopVerdict::free_space) << set_back;
    EXPECT_NEAR(check.beside, 0.25, 0.05) << set_back;
  }
}

}  // namespace
}  // namespace surefoot::mapping
