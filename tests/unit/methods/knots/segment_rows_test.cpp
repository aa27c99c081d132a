// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/segment_rows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "support/random.hpp"

namespace surefoot {
namespace {

std::vector<SurfelResidual> residuals(std::size_t count) {
  test::Random random(7);
  std::vector<SurfelResidual> made;
  for (std::size_t i = 0; i < count; ++i) {
    const double variance = 0.001 + 0.1 * std::abs(random.unit_vector().x());
    made.push_back({random.unit_vector(), 30.0 * random.unit_vector(),
                    2.0 * std::sqrt(variance) * random.unit_vector().y(),
                    std::abs(random.unit_vector().z()), variance, i % 3 == 0 ? 0.05 : 0.1,
                    i % 3 == 0 ? 1.0 / 3.0 : 1.0});
  }
  return made;
}

/// The same sums, one residual after the other, in double.
SegmentSums summed_in_double(const std::vector<SurfelResidual>& of) {
  SegmentSums sums;
  for (const SurfelResidual& r : of) {
    Twist J;
    J << r.normal, r.arm.cross(r.normal);
    const double cauchy = 1.0 / (1.0 + r.value * r.value / (9.0 * r.variance));
    const double w = r.weight * cauchy * cauchy / r.variance;
    sums.first += (1.0 - r.u) * (1.0 - r.u) * w * J * J.transpose();
    sums.between += r.u * (1.0 - r.u) * w * J * J.transpose();
    sums.last += r.u * r.u * w * J * J.transpose();
    sums.first_gradient += (1.0 - r.u) * w * r.value * J;
    sums.last_gradient += r.u * w * r.value * J;
    sums.weight += w;
    sums.weighted_squares += w * r.value * r.value;
    sums.squared_distance += w * r.arm.squaredNorm();
    sums.misfit += r.part * (1.0 - cauchy);
    ++sums.count;
    Eigen::Index axis = 0;
    r.normal.cwiseAbs().maxCoeff(&axis);
    sums.neighbours[static_cast<std::size_t>(axis)] += w * r.value * J;
  }
  return sums;
}

TEST(SegmentRows, SumUpAsOneAfterTheOtherInDouble) {
  constexpr double kExact = 1e-6;                            // of floats' sums
  for (const std::size_t count : {0, 1, 31, 32, 33, 500}) {  // blocks have 32
    const std::vector<SurfelResidual> some = residuals(count);
    SegmentRows rows(true);
    for (const SurfelResidual& residual : some) rows.add(residual);
    const SegmentSums& sums = rows.sums();
    const SegmentSums expected = summed_in_double(some);
    const double H = kExact * expected.rigid().norm();
    EXPECT_LE((sums.first - expected.first).norm(), H);
    EXPECT_LE((sums.between - expected.between).norm(), H);
    EXPECT_LE((sums.last - expected.last).norm(), H);
    EXPECT_EQ(sums.first, sums.first.transpose());
    const double g = kExact * std::sqrt(expected.squared_distance * expected.weighted_squares);
    EXPECT_LE((sums.first_gradient - expected.first_gradient).norm(), g);
    EXPECT_LE((sums.last_gradient - expected.last_gradient).norm(), g);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE((sums.neighbours[axis] - expected.neighbours[axis]).norm(), g);
    }
    EXPECT_NEAR(sums.weight, expected.weight, kExact * expected.weight);
    EXPECT_NEAR(sums.weighted_squares, expected.weighted_squares,
                kExact * expected.weighted_squares);
    EXPECT_NEAR(sums.squared_distance, expected.squared_distance,
                kExact * expected.squared_distance);
    EXPECT_NEAR(sums.misfit, expected.misfit, kExact * expected.count);
    EXPECT_EQ(sums.count, expected.count);
  }
}

TEST(SegmentRows, NeighboursAreSummedUpOnlyIfAskedFor) {
  SegmentRows rows(false);
  for (const SurfelResidual& residual : residuals(40)) rows.add(residual);
  for (const Twist& gradient : rows.sums().neighbours) EXPECT_EQ(gradient.norm(), 0.0);
}

}  // namespace
}  // namespace surefoot
