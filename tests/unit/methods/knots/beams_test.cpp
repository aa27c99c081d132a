// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/beams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

const Eigen::Vector3d kBeamOrigin(3.0, -2.0, 0.6);

Beams one_beam(const Eigen::Vector3d& towards, double range) {
  return {kBeamOrigin, {(towards - kBeamOrigin).normalized()}, {range}};
}

Surfel ball(const Eigen::Vector3d& mean, double deviation) {
  Surfel surfel;
  surfel.mean = mean;
  surfel.extent = static_cast<float>(deviation * deviation);
  return surfel;
}

Surfel disc(const Eigen::Vector3d& mean, const Eigen::Vector3d& normal, double deviation) {
  Surfel surfel = ball(mean, deviation);
  surfel.directions = 1;
  surfel.along[0].across = normal.normalized().cast<float>();
  return surfel;
}

bool pass(const Beams& beams, const Surfel& surfel) {
  const bool passed = beams.pass(surfel);
  // The quick answer may be yes where the exact one is no, never the other way round.
  EXPECT_TRUE(!passed || beams.may_pass(surfel.mean.cast<float>()));
  return passed;
}

/// Anywhere on the sphere: also across the seam of the cells, and straight up and down.
TEST(Beams, ABeamThroughTheMiddlePassesIfItEndsWellBehind) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d ray = random.unit_vector();
    const double distance = random.uniform(1.0, 29.0);
    const Eigen::Vector3d mean = kBeamOrigin + distance * ray;
    for (const Surfel& surfel : {ball(mean, 0.1), disc(mean, ray, 0.1)}) {
      const double behind = 0.5 + 0.2 * distance;
      EXPECT_TRUE(pass(one_beam(mean, distance + 1.01 * behind), surfel));
      EXPECT_FALSE(pass(one_beam(mean, distance + 0.99 * behind), surfel));
      EXPECT_FALSE(pass(one_beam(mean, distance), surfel));
    }
  }
}

TEST(Beams, ThoseThatEndBeforeTheNoseTellOfNothing) {
  Random random(5);
  std::vector<Eigen::Vector3d> rays;
  std::vector<double> ranges;
  for (int i = 0; i < 100; ++i) {
    rays.push_back(random.unit_vector());
    ranges.push_back(i < 25 ? random.uniform(1.2, 60.0) : random.uniform(0.1, 1.0));
  }
  EXPECT_DOUBLE_EQ(Beams(kBeamOrigin, rays, ranges).telling(), 0.25);
  EXPECT_EQ(Beams(kBeamOrigin, {}, {}).telling(), 0.0);
}

/// Away from what is near or overhead, where only the beams of the next cells are looked at.
TEST(Beams, ABeamBesideItDoesNot) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double azimuth = random.uniform(-std::numbers::pi, std::numbers::pi);
    const Eigen::Vector3d ray =
        Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), random.uniform(-0.5, 0.5))
            .normalized();
    const Eigen::Vector3d aside = (i % 2 == 0 ? 1.0 : -1.0) * ray.unitOrthogonal();
    const double deviation = random.uniform(0.15, 0.3);  // more than the least
    const Eigen::Vector3d mean = kBeamOrigin + random.uniform(18.0, 29.0) * ray;
    const auto beam = [&](double off) { return one_beam(mean + off * deviation * aside, 50.0); };
    EXPECT_TRUE(pass(beam(0.70), ball(mean, deviation)));  // half the variance
    EXPECT_FALSE(pass(beam(0.72), ball(mean, deviation)));
    EXPECT_TRUE(pass(beam(0.98), disc(mean, ray, deviation)));
    EXPECT_FALSE(pass(beam(1.02), disc(mean, ray, deviation)));
  }
}

/// A beam close over the ground has not gone through it.
TEST(Beams, APlaneSeenEdgeOnIsNotPassed) {
  const Eigen::Vector3d ground(13.0, -2.0, 0.0);
  EXPECT_FALSE(pass(one_beam(ground, 50.0), disc(ground, Eigen::Vector3d::UnitZ(), 0.15)));
  const Eigen::Vector3d wall_normal(1.0, 0.0, 0.5);
  EXPECT_TRUE(pass(one_beam(ground, 50.0), disc(ground, wall_normal, 0.15)));
}

TEST(Beams, WhatIsTooNearOrTooFarIsNotAskedFor) {
  for (const double distance : {0.3, 31.0}) {
    const Eigen::Vector3d mean = kBeamOrigin + Eigen::Vector3d(distance, 0.0, 0.0);
    EXPECT_FALSE(one_beam(mean, 100.0).may_pass(mean.cast<float>())) << distance;
  }
}

TEST(Beams, NoBeamsPassNothing) {
  const Beams none(kBeamOrigin, {}, {});
  const Eigen::Vector3d mean = kBeamOrigin + Eigen::Vector3d(5.0, 0.0, 0.0);
  EXPECT_FALSE(pass(none, ball(mean, 0.1)));
}

}  // namespace
}  // namespace surefoot
