// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When a registration is trusted.
#include "odometry/health.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot {
namespace {

Config::Health test_config() {
  Config::Health config = Config().health;
  config.min_matches = 30;
  config.min_match_ratio = 0.3;
  config.max_correction = 2.0;
  config.max_correction_deg = 20.0;
  return config;
}

Registration registration(int matches, const Pose& pose = {}) {
  Registration result;
  result.matches = matches;
  result.T_map_lidar = pose;
  return result;
}

Status judge(const Registration& result, std::size_t points, const Pose& T_0 = {}) {
  const Verdict verdict = judge_registration(result, T_0, points, test_config());
  EXPECT_EQ(verdict.message.empty(), verdict.status == Status::ok);
  return verdict.status;
}

TEST(Health, MatchesAndTheirShareMustBothSuffice) {
  EXPECT_EQ(judge(registration(30), 100), Status::ok);
  EXPECT_EQ(judge(registration(29), 30), Status::too_few_matches);
  EXPECT_EQ(judge(registration(299), 1000), Status::too_few_matches);
  EXPECT_EQ(judge(registration(0), 0), Status::too_few_matches);
}

TEST(Health, CorrectionsBeyondTheLimitsHaveDiverged) {
  const Pose T_0{so3_exp({0.0, 0.0, 1.0}), {1e4, 0.0, 0.0}};
  const auto corrected = [&](double metres, double degrees) {
    const double radians = degrees * 3.14159265358979 / 180.0;
    return registration(100, T_0 * Pose{so3_exp({0.0, radians, 0.0}), {0.0, metres, 0.0}});
  };
  EXPECT_EQ(judge(corrected(1.99, 19.9), 100, T_0), Status::ok);
  EXPECT_EQ(judge(corrected(2.01, 0.0), 100, T_0), Status::diverged);
  EXPECT_EQ(judge(corrected(0.0, 20.1), 100, T_0), Status::diverged);
}

TEST(Health, APoseThatIsNotFiniteHasDiverged) {
  Registration result = registration(100);
  result.T_map_lidar.translation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judge(result, 100), Status::diverged);
}

TEST(Health, MessagesNameSeenAndExpected) {
  const std::string few = judge_registration(registration(7), {}, 90, test_config()).message;
  EXPECT_NE(few.find("7 of 90"), std::string::npos) << few;
  EXPECT_NE(few.find("30"), std::string::npos) << few;
}

TEST(Health, StatusesHaveNames) {
  EXPECT_EQ(to_string(Status::ok), "ok");
  EXPECT_EQ(to_string(Status::first_scan), "first_scan");
  EXPECT_EQ(to_string(Status::degenerate), "degenerate");
  EXPECT_EQ(to_string(Status::too_few_matches), "too_few_matches");
  EXPECT_EQ(to_string(Status::diverged), "diverged");
  EXPECT_EQ(to_string(Status::rejected), "rejected");
}

}  // namespace
}  // namespace surefoot
