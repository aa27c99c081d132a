// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Who was elsewhere, in a map of his own or covered, and comes home.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

constexpr int kBefore = 30, kMeanwhile = 40, kAfter = 15;
constexpr std::int64_t kPeriodNs = 100'000'000;
const Pose kHome{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

MotionFunction home_walk() {
  return constant_velocity(kHome, (Twist() << 0.5, 0, 0, 0, 0, 0).finished());
}

/// Another place: the hall, longer and narrower.
void make_elsewhere(Scan& scan) {
  for (Eigen::Vector3f& p : scan.points) p = Eigen::Vector3f(2.5F * p.x(), 0.4F * p.y(), p.z());
}

void cover(Scan& scan) {
  for (Eigen::Vector3f& point : scan.points) point *= 0.6F / point.norm();
}

/// Walks, sees something else meanwhile, and goes the same way once more.
std::vector<Scan> there_and_back(int before, const std::function<void(Scan&)>& change) {
  std::vector<Scan> scans = take_scans(furnished_hall(), home_walk(), before + kMeanwhile);
  std::for_each(scans.begin() + before, scans.end(), change);
  for (Scan& scan : take_scans(furnished_hall(), home_walk(), kAfter, {}, 5)) {
    scan.stamp_ns = scans.back().stamp_ns + kPeriodNs;
    scans.push_back(std::move(scan));
  }
  return scans;
}

Config searching_briefly() {
  Config config;
  config.knots.search_scans = 5;
  return config;
}

bool came_home(const std::vector<Estimate>& all) {
  return std::any_of(all.begin(), all.end(),
                     [](const Estimate& estimate) { return estimate.message == "came home"; });
}

TEST(KnotSegments, WhoComesHomeGoesOnInTheFirstMap) {
  for (const auto& change : {make_elsewhere, cover}) {
    Odometry odometry(searching_briefly());
    const auto all = add_scans(odometry, there_and_back(kBefore, change));
    EXPECT_EQ(all[kBefore + kMeanwhile - 1].segment, 1) << statuses(all);
    ASSERT_TRUE(came_home(all)) << statuses(all);
    // Looked for by the first or second scan, which the next two confirm at once.
    EXPECT_EQ(all[kBefore + kMeanwhile + 3].segment, 0) << statuses(all);
    EXPECT_EQ(all.back().segment, 0);
    EXPECT_EQ(all.back().status, Status::ok);
    const Pose truth = home_walk()(0.1 * (5 + kAfter - 1) + 0.05), from = home_walk()(0.05);
    const Pose told = all.front().T_world_lidar.inverse() * all.back().T_world_lidar;
    EXPECT_LT((told.translation - (from.inverse() * truth).translation).norm(), 0.1);
  }
}

TEST(KnotSegments, AMapOfFewScansIsNoHome) {
  constexpr int kFew = 15;
  Odometry odometry(searching_briefly());
  const auto all = add_scans(odometry, there_and_back(kFew, make_elsewhere));
  EXPECT_EQ(all[kFew + kMeanwhile - 1].segment, 1) << statuses(all);
  EXPECT_FALSE(came_home(all)) << statuses(all);
}

/// The next map's number is none that there was.
TEST(KnotSegments, WhoLeavesHomeAgainBeginsANewSegment) {
  std::vector<Scan> scans = there_and_back(kBefore, make_elsewhere);
  for (Scan& scan : there_and_back(0, make_elsewhere)) {
    for (Eigen::Vector3f& p : scan.points) p = Eigen::Vector3f(p.y(), -0.7F * p.x(), p.z());
    scan.stamp_ns = scans.back().stamp_ns + kPeriodNs;
    scans.push_back(std::move(scan));
  }
  Odometry odometry(searching_briefly());
  const auto all = add_scans(odometry, scans);
  ASSERT_TRUE(came_home(all)) << statuses(all);
  int most = 0;
  for (const Estimate& estimate : all) most = std::max(most, estimate.segment);
  EXPECT_GE(most, 2) << statuses(all);
}

TEST(KnotSegments, AreTheSameBitsAtAnyThreadCount) {
  const auto scans = there_and_back(kBefore, make_elsewhere);
  Odometry one(searching_briefly(), 1), two(searching_briefly(), 2);
  EXPECT_TRUE(same_bits(add_scans(one, scans), add_scans(two, scans)));
}

}  // namespace
}  // namespace surefoot
