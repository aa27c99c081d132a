// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A reference of a walk with exact truth, beside the odometry that it begins with.
#include <gtest/gtest.h>

#include <cmath>

#include "support/synthetic_run.hpp"
#include "surefoot/reference.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

constexpr int kReferenceScans = 40;

std::vector<Scan> trot_through_the_hall() {
  const Pose start{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};
  return take_scans(furnished_hall(), trotting(start, 1.0, 2.5), kReferenceScans);
}

MotionFunction truth_of_the_trot() {
  return trotting(Pose{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}}, 1.0, 2.5);
}

struct StepError {
  double translation = 0.0, rotation_deg = 0.0;
};

/// Of the motion over five scans, root mean square: nothing has to be aligned for it.
StepError step_error(const std::vector<Estimate>& estimates) {
  constexpr std::size_t kStep = 5;
  const MotionFunction motion = truth_of_the_trot();
  const auto truth = [&](std::size_t i) {
    return motion(1e-9 * static_cast<double>(estimates[i].stamp_ns));
  };
  StepError error;
  double count = 0.0;
  for (std::size_t i = kStep; i < estimates.size(); ++i, ++count) {
    const Pose found = estimates[i - kStep].T_world_lidar.inverse() * estimates[i].T_world_lidar;
    const Pose right = truth(i - kStep).inverse() * truth(i);
    error.translation += (found.translation - right.translation).squaredNorm();
    error.rotation_deg += std::pow(angle_between_deg(found.rotation, right.rotation), 2);
  }
  return {std::sqrt(error.translation / count), std::sqrt(error.rotation_deg / count)};
}

struct BothAnswers {
  std::vector<Estimate> online, reference;
};

BothAnswers both_of(const std::vector<Scan>& scans, int threads = 1) {
  Reference reference({}, threads);
  BothAnswers both;
  for (const Scan& scan : scans) both.online.push_back(reference.add_scan(scan));
  EXPECT_TRUE(reference.refine());
  EXPECT_TRUE(reference.unrefined().empty());
  Odometry answers = reference.replay();
  both.reference = add_scans(answers, scans);
  return both;
}

TEST(Reference, IsBetterThanTheOdometryThatItBeginsWith) {
  const BothAnswers both = both_of(trot_through_the_hall());
  const StepError online = step_error(both.online), reference = step_error(both.reference);
  std::printf("online %.5f m %.4f deg, reference %.5f m %.4f deg\n", online.translation,
              online.rotation_deg, reference.translation, reference.rotation_deg);
  EXPECT_LT(reference.translation, 0.7 * online.translation);
  EXPECT_LT(reference.rotation_deg, 0.8 * online.rotation_deg);
}

TEST(Reference, AnswersEveryScanAsTheOdometryDid) {
  const std::vector<Scan> scans = trot_through_the_hall();
  const BothAnswers both = both_of(scans);
  ASSERT_EQ(both.reference.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(both.reference[i].status, both.online[i].status);
    EXPECT_EQ(both.reference[i].stamp_ns, both.online[i].stamp_ns);
    EXPECT_GT(both.reference[i].covariance.diagonal().minCoeff(), 0.0);
  }
  // It lies where the odometry began.
  EXPECT_LT((both.reference[0].T_world_lidar.translation - both.online[0].T_world_lidar.translation)
                .norm(),
            1e-9);
}

TEST(Reference, SameBitsForAnyNumberOfThreads) {
  const std::vector<Scan> scans = trot_through_the_hall();
  EXPECT_TRUE(same_bits(both_of(scans, 1).reference, both_of(scans, 3).reference));
}

// What was not registered is carried along, and what was rejected stays so.
TEST(Reference, LeavesOutWhatTheOdometryCouldNotUse) {
  std::vector<Scan> scans = trot_through_the_hall();
  scans[20].points.clear();
  scans[20].times_ns.clear();
  const BothAnswers both = both_of(scans);
  ASSERT_EQ(both.online[20].status, Status::rejected);
  EXPECT_EQ(both.reference[20].status, Status::rejected);
  EXPECT_EQ(both.reference[20].T_world_lidar.translation,
            both.reference[19].T_world_lidar.translation);
  EXPECT_EQ(both.reference[20].twist, both.reference[19].twist);
  EXPECT_EQ(both.reference[21].status, both.online[21].status);
  EXPECT_TRUE(both.reference[21].trusted());
}

/// A hall twice as long and half as wide from scan `from` on.
void see_another_hall(std::vector<Scan>& scans, std::size_t from) {
  for (std::size_t i = from; i < scans.size(); ++i) {
    for (Eigen::Vector3f& p : scans[i].points) {
      p = Eigen::Vector3f(2.5F * p.x(), 0.4F * p.y(), p.z());
    }
  }
}

TEST(Reference, WhatWasLostIsCarriedAlongAndANewSegmentHasAMapOfItsOwn) {
  constexpr std::size_t kElsewhere = 10;
  std::vector<Scan> scans = trot_through_the_hall();
  scans.resize(24);
  see_another_hall(scans, kElsewhere);
  Config config;
  config.knots.search_scans = 4;
  Reference reference(config);
  std::vector<Estimate> online;
  for (const Scan& scan : scans) online.push_back(reference.add_scan(scan));
  ASSERT_EQ(online.back().segment, 1) << statuses(online);
  ASSERT_FALSE(online[kElsewhere].trusted()) << statuses(online);
  EXPECT_TRUE(reference.refine());

  Odometry replay = reference.replay();
  Odometry again(config);
  std::vector<Estimate> answers;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::size_t before = replay.local_map().size();
    answers.push_back(replay.add_scan(scans[i]));
    (void)again.add_scan(scans[i]);
    const Estimate &now = answers.back(), &then = online[i];
    EXPECT_EQ(now.status, then.status) << i;
    EXPECT_EQ(now.segment, then.segment) << i;
    if (now.trusted() || i < kElsewhere) continue;
    EXPECT_EQ(replay.local_map().size(), before) << "what is not trusted is not mapped";
    EXPECT_TRUE(replay.emptied_cubes().centres.empty());
    const Pose moved = answers[kElsewhere - 1].T_world_lidar *
                       online[kElsewhere - 1].T_world_lidar.inverse() * then.T_world_lidar;
    EXPECT_LT((now.T_world_lidar.translation - moved.translation).norm(), 1e-9) << i;
    EXPECT_GT((now.T_world_lidar.translation - then.T_world_lidar.translation).norm(), 1e-6) << i;
  }
  // The first hall is not in the map of the second.
  const auto width = [](const std::vector<Eigen::Vector3d>& points) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
    return high->y() - low->y();
  };
  EXPECT_NEAR(width(replay.local_map()), width(again.local_map()), 0.5);
}

// Ten scans are refused, the rest is followed; the reference knows all that the odometry knew, and
// moves it.
TEST(Reference, GoesOnWhereTheClockWasSetBack) {
  std::vector<Scan> scans = trot_through_the_hall();
  for (std::size_t i = 15; i < scans.size(); ++i) scans[i].stamp_ns -= 100'000'000'000;
  const BothAnswers both = both_of(scans);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(both.reference[i].status, both.online[i].status) << i;
    EXPECT_EQ(both.reference[i].stamp_ns, both.online[i].stamp_ns) << i;
    EXPECT_EQ(both.reference[i].trusted(), i < 15 || i >= 25) << i;
    if (!both.reference[i].trusted()) continue;
    EXPECT_NE(both.reference[i].covariance, both.online[i].covariance) << i;
  }
}

TEST(Reference, IsMadeByOneMethodAlone) {
  EXPECT_THROW(Reference(method_config("paper")), ConfigError);
  Config wrong;
  wrong.knots.points = -1;
  EXPECT_THROW(Reference{wrong}, ConfigError);
}

TEST(Reference, OfNothingOrOneScanIsWhatTheOdometrySays) {
  Reference nothing;
  EXPECT_TRUE(nothing.refine());
  EXPECT_EQ(both_of({}).reference.size(), 0U);
  const std::vector<Scan> one(1, trot_through_the_hall()[0]);
  const BothAnswers both = both_of(one);
  EXPECT_EQ(both.reference[0].T_world_lidar.translation, both.online[0].T_world_lidar.translation);
}

TEST(Reference, EndsWhenItIsToldTo) {
  Reference reference;
  for (const Scan& scan : trot_through_the_hall()) reference.add_scan(scan);
  double told = -1.0;
  EXPECT_FALSE(reference.refine([&](double share) { return (told = share) <= 0.0; }));
  EXPECT_GT(told, 0.0);
  EXPECT_LT(told, 1.0);
}

}  // namespace
}  // namespace surefoot
