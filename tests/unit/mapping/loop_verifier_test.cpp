// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_verifier.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace surefoot::mapping
