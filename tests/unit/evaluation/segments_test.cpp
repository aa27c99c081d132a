// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/segments.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "evo_data.hpp"
#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::straight_walk;

TEST(Segments, OfAStrideThatIsTwoPercentTooLong) {
  const AssociatedTrajectories pairs{straight_walk(401, 1.0), straight_walk(401, 1.02)};
  const SegmentErrors errors = segment_errors(pairs, {100.0, 200.0, 500.0});
  ASSERT_EQ(errors.by_length.size(), 3U);
  // The end is the first pose farther than 100 m: 101 m on, from every tenth pose 0 .. 290.
  EXPECT_EQ(errors.by_length[0].count, 30U);
  EXPECT_NEAR(errors.by_length[0].translation_percent, 2.0 * 101.0 / 100.0, 1e-9);
  EXPECT_EQ(errors.by_length[1].count, 20U);
  EXPECT_NEAR(errors.by_length[1].translation_percent, 2.0 * 201.0 / 200.0, 1e-9);
  EXPECT_EQ(errors.by_length[2].count, 0U);
  EXPECT_EQ(errors.all.count, 50U);
  EXPECT_NEAR(errors.all.translation_percent, (30.0 * 2.02 + 20.0 * 2.01) / 50.0, 1e-9);
  EXPECT_NEAR(errors.all.rotation_deg_per_m, 0.0, 1e-9);
}

TEST(Segments, RotationIsPerMetre) {
  Trajectory reference = straight_walk(31, 1.0), estimate = reference;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double yaw = 0.1 * static_cast<double>(i) * std::numbers::pi / 180.0;
    estimate[i].pose.rotation = from_roll_pitch_yaw({0.0, 0.0, yaw});
  }
  const SegmentErrors errors = segment_errors({reference, estimate}, {10.0});
  EXPECT_NEAR(errors.all.rotation_deg_per_m, 0.1 * 11.0 / 10.0, 1e-9);
}

TEST(Segments, LengthsFitTheRun) {
  EXPECT_DOUBLE_EQ(segment_lengths_for(3700.0).front(), 100.0);
  EXPECT_DOUBLE_EQ(segment_lengths_for(3700.0).back(), 800.0);
  EXPECT_DOUBLE_EQ(segment_lengths_for(150.0).back(), 80.0);
  EXPECT_DOUBLE_EQ(segment_lengths_for(5.0).front(), 1.0);
  EXPECT_DOUBLE_EQ(segment_lengths_for(200.0).front(), 100.0);
  EXPECT_DOUBLE_EQ(segment_lengths_for(20.0).front(), 10.0);
}

TEST(Segments, OfARunTooShortForAnyAndOfImpossibleLengths) {
  const Trajectory walk = straight_walk(3, 1.0);
  const SegmentErrors errors = segment_errors({walk, walk}, {50.0});
  EXPECT_EQ(errors.all.count, 0U);
  EXPECT_DOUBLE_EQ(errors.all.translation_percent, 0.0);
  for (const double length : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)segment_errors({walk, walk}, {length}), std::invalid_argument);
  }
}

// The expected figures are from a program of its own that follows the benchmark's definition with
// matrices (numpy), on evo's test data.
TEST(Segments, OfOrbSlamOnKitti00) {
  if (!std::filesystem::exists(test::evo_data("KITTI_00_gt.txt"))) {
    GTEST_SKIP() << "evo's test data are not at hand";
  }
  const AssociatedTrajectories pairs{test::read_kitti(test::evo_data("KITTI_00_gt.txt")),
                                     test::read_kitti(test::evo_data("KITTI_00_ORB.txt"))};
  const SegmentErrors errors = segment_errors(pairs, segment_lengths_for(3724.0));
  EXPECT_NEAR(errors.all.translation_percent, 0.69972866, 1e-6);
  EXPECT_NEAR(errors.all.rotation_deg_per_m, 0.00253330, 1e-7);
  EXPECT_EQ(errors.by_length.front().count, 445U);
  EXPECT_NEAR(errors.by_length.front().translation_percent, 1.00903809, 1e-6);
  EXPECT_NEAR(errors.by_length.back().rotation_deg_per_m, 0.00100035, 1e-7);
}

}  // namespace
}  // namespace surefoot::evaluation
