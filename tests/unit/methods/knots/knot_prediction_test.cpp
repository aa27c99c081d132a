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

TEST(KnotPrediction, AfterALongGapItIsCarriedOnForAWhileToAPlaceThatIsKnownTheLess) {
  const PreparedScan scan = scan_after(3.0);
  const KnotEnd begin = beginning_of(scan, walking_end(), walking(), Config());
  EXPECT_EQ(begin.stamp_ns, scan.start_ns);
  EXPECT_NEAR(begin.prior.means[1].translation.x(), kEnd.translation.x() + 0.5, 1e-9);
  EXPECT_EQ(begin.prior.information, at_rest(begin.prior.means[1], 0.0125, 3.0).information);
}

TEST(KnotPrediction, AGapIsBridgedBySegmentsAsLongAsTheScans) {
  struct Case {
    double gap;
    std::size_t segments;
  };
  for (const Case& c : {Case{0.0, 8}, Case{0.1, 16}, Case{0.45, 24}}) {
    const KnotWindow window =
        predict_knots(scan_after(c.gap), walking_end(), walking(), Config().knots);
    EXPECT_EQ(window.segments(), c.segments) << c.gap;
    EXPECT_NEAR(window.step * static_cast<double>(c.segments), c.gap + 0.1, 1e-9) << c.gap;
  }
}

}  // namespace
}  // namespace surefoot
