// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings written with the right times and with wrong ones: the motion knows.
#include "checks/time_trials.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "io/point_time_watch.hpp"
#include "support/random.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::checks {
namespace {

constexpr std::int64_t kTrialPeriod = 100'000'000;

/// A sensor that trots through a hall: no two scans are bent alike, as they would be in a steady
/// turn.
std::vector<Scan> trot(int count) {
  const Pose start{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  return test::take_scans(test::furnished_hall(), test::trotting(start, 0.6, 1.4), count);
}

TEST(TimeTrials, RightTimesArePreferred) {
  const TimeTrials trials = try_times(trot(22), kTrialPeriod, true, 1);
  ASSERT_EQ(trials.trials.size(), 3U);
  EXPECT_TRUE(trials.decided);
  EXPECT_EQ(trials.trials[trials.preferred].reading, TimeReading::as_read);
  EXPECT_GT(trials.trials[1].middle_blur, 1.1 * trials.trials[0].middle_blur);
  EXPECT_GT(trials.trials[2].middle_blur, 1.1 * trials.trials[0].middle_blur);
}

TEST(TimeTrials, TimesThatCountBackAreFoundOut) {
  std::vector<Scan> scans = trot(22);
  for (Scan& scan : scans) io::count_backward(scan);
  const TimeTrials trials = try_times(scans, kTrialPeriod, true, 1);
  EXPECT_TRUE(trials.decided);
  EXPECT_EQ(trials.trials[trials.preferred].reading, TimeReading::backward);
  EXPECT_LT(trials.trials[trials.preferred].chance, 0.001);
}

// Noise: a map begins anew and again anew, and each time nothing speaks against it.
TEST(TimeTrials, ScansThatHaveNothingInCommonAreCounted) {
  test::Random random(5);
  std::vector<Scan> scans(12);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns = kTrialPeriod * static_cast<std::int64_t>(i);
    for (int p = 0; p < 3000; ++p) {
      scans[i].points.push_back((30.0 * random.vector(1.0)).cast<float>());
    }
  }
  EXPECT_GT(try_times(scans, kTrialPeriod, false, 1).trials[0].untrusted, 6U);
}

// Who stands has no motion that could tell: the noise of one reading is as good as the other's,
// but may be less in every scan.
TEST(TimeTrials, OfWhoStandsNothingIsConcluded) {
  const Pose place{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  const auto scans = test::take_scans(test::furnished_hall(), test::standing(place), 22);
  EXPECT_FALSE(try_times(scans, kTrialPeriod, true, 1).decided);
}

// However sure it is, half a percent of the blur tells nothing (a VLP-16 that stood: 17.1 and 17.2
// mm, in 11 of 11 scans).
TEST(TimeTrials, WhatMakesHardlyADifferenceDecidesNothing) {
  const auto chosen = [](double first_mm, double other_mm) {
    TimeTrials trials;
    trials.trials.resize(2);
    trials.trials[0].middle_blur = 1e-3 * first_mm;
    TimeTrial& other = trials.trials[1];
    other.middle_blur = 1e-3 * other_mm;
    other.chance = 1e-6;
    (other_mm < first_mm ? other.better : other.worse) = 20;
    choose(trials);
    return std::pair(trials.decided, trials.preferred);
  };
  EXPECT_EQ(chosen(17.2, 17.1), std::pair(false, std::size_t{0}));
  EXPECT_EQ(chosen(17.1, 17.2), std::pair(false, std::size_t{0}));
  EXPECT_EQ(chosen(17.2, 16.0), std::pair(true, std::size_t{1}));
  EXPECT_EQ(chosen(16.0, 17.2), std::pair(true, std::size_t{0}));
}

TEST(TimeTrials, ChanceIsThatOfAFairCoin) {
  EXPECT_DOUBLE_EQ(chance_of(5, 5), 1.0);
  EXPECT_NEAR(chance_of(10, 0), 2.0 / 1024.0, 1e-12);
  EXPECT_NEAR(chance_of(9, 1), 2.0 * 11.0 / 1024.0, 1e-12);
  EXPECT_NEAR(chance_of(1, 9), chance_of(9, 1), 1e-15);
  EXPECT_DOUBLE_EQ(chance_of(0, 0), 1.0);
}

}  // namespace
}  // namespace surefoot::checks
