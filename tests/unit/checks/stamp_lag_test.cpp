// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/stamp_lag.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::checks {
namespace {

/// Yaw that swings, sampled from 0 to 8 s, its stamps late by `late` seconds.
Trajectory swinging(double step, double late) {
  Trajectory trajectory;
  for (double time = 0.0; time < 8.0; time += step) {
    const double yaw = 0.6 * std::sin(2.1 * time) + 0.1 * std::sin(9.0 * time);
    const auto stamp = static_cast<std::int64_t>(std::llround(1e9 * (time + late)));
    trajectory.push_back({stamp, {so3_exp({0.0, 0.0, yaw}), {}}});
  }
  return trajectory;
}

TEST(StampLag, FindsStampsThatNameTheEndOfTheSweep) {
  const StampLag lag = find_stamp_lag(swinging(0.1, 0.1), swinging(0.005, 0.0), 0.15);
  EXPECT_NEAR(lag.lag_s, -0.1, 0.006);
  EXPECT_LT(lag.best_deg, 0.1);
  EXPECT_GT(lag.error_deg, 5.0 * lag.best_deg);
  EXPECT_LT(lag.chance, 1e-6);
  EXPECT_GT(lag.pairs, 60U);
}

TEST(StampLag, LeavesRightStampsAlone) {
  const StampLag lag = find_stamp_lag(swinging(0.1, 0.0), swinging(0.005, 0.0), 0.15);
  EXPECT_NEAR(lag.lag_s, 0.0, 0.003);
}

TEST(StampLag, SaysNothingWhereTheReferenceIsOfAnotherTime) {
  EXPECT_EQ(find_stamp_lag(swinging(0.1, 100.0), swinging(0.005, 0.0), 0.15).pairs, 0U);
  EXPECT_EQ(find_stamp_lag({}, {}, 0.15).pairs, 0U);
}

}  // namespace
}  // namespace surefoot::checks
