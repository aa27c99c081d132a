// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When a registration is trusted.
#include "core/health.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot {
namespace {

Config::Health health_config() {
  Config::Health config = Config().health;
  config.min_matches = 30;
  config.min_match_ratio = 0.3;
  config.max_correction = 2.0;
  config.max_correction_deg = 20.0;
  return config;
}

Judgement judgement_of(const RegistrationEnd& end) {
  return judge_with_share(end, health_config());
}

Status judge(int matches, std::size_t points) {
  const Judgement judgement = judgement_of({{}, {}, matches, points});
  EXPECT_EQ(judgement.message.empty(), judgement.status == Status::ok);
  return judgement.status;
}

TEST(Health, MatchesAndTheirShareMustBothSuffice) {
  EXPECT_EQ(judge(30, 100), Status::ok);
  EXPECT_EQ(judge(29, 30), Status::too_few_matches);
  EXPECT_EQ(judge(299, 1000), Status::too_few_matches);
  EXPECT_EQ(judge(0, 0), Status::too_few_matches);
}

TEST(Health, WithoutTheShareTheirNumberSuffices) {
  EXPECT_EQ(judge_registration({{}, {}, 30, 10000}, health_config()).status, Status::ok);
  EXPECT_EQ(judge_registration({{}, {}, 29, 30}, health_config()).status, Status::too_few_matches);
}

TEST(Health, CorrectionsBeyondTheLimitsHaveDiverged) {
  const Pose T_0{so3_exp({0.0, 0.0, 1.0}), {1e4, 0.0, 0.0}};
  const auto corrected = [&](double metres, double degrees) {
    const double radians = degrees * 3.14159265358979 / 180.0;
    const Pose found = T_0 * Pose{so3_exp({0.0, radians, 0.0}), {0.0, metres, 0.0}};
    return judgement_of({T_0, found, 100, 100}).status;
  };
  EXPECT_EQ(corrected(1.99, 19.9), Status::ok);
  EXPECT_EQ(corrected(2.01, 0.0), Status::diverged);
  EXPECT_EQ(corrected(0.0, 20.1), Status::diverged);
}

TEST(Health, APoseThatIsNotFiniteHasDiverged) {
  Pose nowhere;
  nowhere.translation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judgement_of({{}, nowhere, 100, 100}).status, Status::diverged);
}

TEST(Health, MessagesNameSeenAndExpected) {
  const std::string few = judge_registration({{}, {}, 7, 90}, health_config()).message;
  EXPECT_NE(few.find("7 of 90"), std::string::npos) << few;
  EXPECT_NE(few.find("30"), std::string::npos) << few;
  const std::string share = judgement_of({{}, {}, 7, 90}).message;
  EXPECT_NE(share.find("7 of 90"), std::string::npos) << share;
  EXPECT_NE(share.find("0.3"), std::string::npos) << share;
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
