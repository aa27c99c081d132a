// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The local map of scans of which everything is known.
#include "methods/knots/known_front_end.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace surefoot {
namespace {

constexpr std::int64_t kScan = 100'000'000;  // [ns]

/// A wall across the way, 2 m wide and high, so far ahead.
PreparedScan wall_ahead(std::int64_t number, double ahead) {
  test::Random random(21);
  PreparedScan scan;
  scan.start_ns = number * kScan;
  scan.end_ns = scan.start_ns + kScan;
  for (int i = 0; i < 6000; ++i) {
    scan.points.emplace_back(static_cast<float>(ahead),
                             static_cast<float>(random.uniform(-1.0, 1.0)),
                             static_cast<float>(random.uniform(-1.0, 1.0)));
    scan.taus.push_back(static_cast<float>(i) / 6000.0F);
  }
  return scan;
}

/// Where the sensor stood still in every scan.
std::shared_ptr<const KnownAnswers> known_at(const std::vector<double>& places) {
  KnownAnswers known;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Pose pose{Eigen::Quaterniond::Identity(), {places[i], 0.0, 0.0}};
    const auto start_ns = static_cast<std::int64_t>(i) * kScan;
    Estimate estimate;
    estimate.status = Status::ok;
    estimate.trajectory = ScanTrajectory({pose, pose}, start_ns, start_ns + kScan);
    known.estimates.push_back(estimate);
  }
  return std::make_shared<const KnownAnswers>(std::move(known));
}

TEST(KnownFrontEnd, ForgetsWhatLiesFartherAwayThanItsMapReaches) {
  const Session session{Config{}, Workers(1)};
  std::vector<double> places(2 + 2 * SurfelMap::kRound, 1000.0);
  places.front() = 0.0;
  KnownFrontEnd front_end(session, known_at(places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    (void)front_end.add(wall_ahead(static_cast<std::int64_t>(i), 5.0));
    if (i > 0) continue;
    ASSERT_FALSE(front_end.local_map().empty());
  }
  ASSERT_FALSE(front_end.local_map().empty());
  for (const Eigen::Vector3d& point : front_end.local_map()) ASSERT_GT(point.x(), 900.0);
}

TEST(KnownFrontEnd, NothingIsKnownOfAScanThatIsNoneOfThose) {
  const Session session{Config{}, Workers(1)};
  KnownFrontEnd front_end(session, known_at({0.0, 0.0}));
  EXPECT_TRUE(front_end.add(wall_ahead(0, 5.0)).trusted());
  PreparedScan unknown = wall_ahead(0, 5.0);
  unknown.end_ns += 2;
  const Estimate estimate = front_end.add(unknown);
  EXPECT_EQ(estimate.status, Status::rejected);
  EXPECT_GT(estimate.covariance.diagonal().minCoeff(), 1e-4);
  EXPECT_TRUE(front_end.add(wall_ahead(1, 5.0)).trusted());
}

}  // namespace
}  // namespace surefoot
