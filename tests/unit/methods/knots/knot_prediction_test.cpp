// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_prediction.hpp"

#include <gtest/gtest.h>

namespace surefoot {
namespace {

constexpr std::int64_t kEndNs = 1'000'000'000;
const Pose kEnd{Eigen::Quaterniond::Identity(), {2.0, 1.0, 0.0}};

KnotEnd walking_end() {
  const Pose before{kEnd.rotation, kEnd.translation - Eigen::Vector3d(0.01, 0.0, 0.0)};
  return {{{before, kEnd}, Matrix12::Identity()}, kEndNs, 0.0125};
}

VelocityModel walking() {
  VelocityModel model(Config().knots);
  model.begin((Twist() << 1.0, 0, 0, 0, 0, 0).finished(), kEnd.rotation);
  return model;
}

PreparedScan scan_after(double gap) {
  PreparedScan scan;
  scan.start_ns = kEndNs + static_cast<std::int64_t>(1e9 * gap);
  scan.end_ns = scan.start_ns + 100'000'000;
  return scan;
}

TEST(KnotPrediction, AScanBeginsWhereTheLastOneEnded) {
  const KnotEnd begin = beginning_of(scan_after(0.0), walking_end(), walking(), Config());
  EXPECT_EQ(begin.stamp_ns, kEndNs);
  EXPECT_EQ(begin.prior.information, walking_end().prior.information);
}

// The clock was set back while the sensor walked on: no more is known than after a gap as long.
TEST(KnotPrediction, TimeThatNoStampTellsIsAGapLikeAnyOther) {
  PreparedScan unstamped = scan_after(0.0);
  unstamped.unstamped = 0.8;
  const KnotEnd told = beginning_of(scan_after(0.8), walking_end(), walking(), Config());
  const KnotEnd begin = beginning_of(unstamped, walking_end(), walking(), Config());
  EXPECT_EQ(begin.prior.information, told.prior.information);
  EXPECT_EQ(begin.prior.means[1].translation, told.prior.means[1].translation);
  EXPECT_NEAR(begin.prior.means[1].translation.x(), 2.5, 1e-12);  // carried on for so long
  EXPECT_EQ(begin.stamp_ns, unstamped.start_ns);
}

}  // namespace
}  // namespace surefoot
