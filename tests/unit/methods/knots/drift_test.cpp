// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/drift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "methods/knots/knot_prior.hpp"

namespace surefoot {
namespace {

DegenerateDirection along(int axis) { return {Twist::Unit(axis), 0.001, ""}; }

TEST(Drift, WhatIsHeldDoesNotDrift) {
  const Drift drift = drift_along({}, 5.0, 3.0);
  EXPECT_EQ(drift.covariance, Matrix6::Zero());
  EXPECT_EQ(drift.wrong_probability, 0.0);
}

TEST(Drift, GrowsWithTheTimeAsFarAsAWalkerGoes) {
  const Drift drift = drift_along({along(0)}, 5.0, 2.0);
  const double off = 2.0 * unknown_velocity()[0];
  EXPECT_NEAR(drift.covariance(0, 0), off * off, 1e-12);
  EXPECT_NEAR(drift.covariance.norm(), off * off, 1e-12) << "the other directions are held";
  EXPECT_NEAR(drift.wrong_probability, 1.0 - std::erf(0.2 / (off * std::sqrt(2.0))), 1e-12);
  EXPECT_EQ(drift_along({along(0)}, 5.0, 0.0).covariance, Matrix6::Zero());
}

// Four rings, 30 m from what they hit: mostly a pitch, and a little of a rise.
TEST(Drift, NoComponentGoesFasterThanByItself) {
  const DegenerateDirection mixed{(Twist() << 0.06, -0.01, -0.18, -0.16, -0.97, -0.03).finished(),
                                  0.001, ""};
  for (const double elapsed : {0.1, 8.0, 100.0}) {
    const Twist deviations = drift_along({mixed}, 33.0, elapsed).covariance.diagonal().cwiseSqrt();
    for (int i = 0; i < 6; ++i) {
      const double most = elapsed * unknown_velocity()[i];
      EXPECT_LE(deviations[i], 1e-12 + (i < 3 ? most : std::min(most, 3.1416))) << i;
    }
    EXPECT_NEAR(deviations[2], 0.3 * elapsed, 1e-9) << "up and down";
  }
}

TEST(Drift, OfARotationTheMatchesDistanceDoesNotMatter) {
  for (const double distance : {2.0, 20.0}) {
    const Drift drift = drift_along({along(5)}, distance, 0.1);
    const double off = 0.1 * unknown_velocity()[5];
    EXPECT_NEAR(drift.covariance(5, 5), off * off, 1e-12);
    EXPECT_NEAR(drift.wrong_probability, 1.0 - std::erf(0.05236 / (off * std::sqrt(2.0))), 1e-4);
  }
}

}  // namespace
}  // namespace surefoot
