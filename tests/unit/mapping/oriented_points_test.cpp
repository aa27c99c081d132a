// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/oriented_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::mapping {
namespace {

constexpr double kCube = 0.2, kRadius = 0.5;  // [m]

/// Of a wall of 0.1 m each face stays where it is, though the other one lies within what a surface
/// may be thick.
TEST(PointOrientationTest, AWallsOtherFaceDoesNotCount) {
  PointOrientation orientation(kCube, kRadius);
  for (double x = -2.0; x <= 2.0; x += 0.1) {
    for (double z = 0.0; z <= 2.0; z += 0.1) {
      for (const double y : {-0.05, 0.05}) orientation.add({x, y, z}, {0.3, 60.0 * y, 1.0});
    }
  }
  const auto points = orientation.oriented();
  EXPECT_GT(points.size(), 400U);
  for (const OrientedPoint& point : points) {
    EXPECT_NEAR(std::abs(point.place.y()), 0.05, 1e-6);
    EXPECT_GT(point.normal.y() * point.place.y(), 0.049);
  }
}

/// A strip, a post, a pole: narrower than a third of a metre, it is no surface.
TEST(PointOrientationTest, WhatIsNarrowIsNoSurface) {
  for (const double width : {0.15, 0.6}) {
    PointOrientation orientation(kCube, kRadius);
    for (double x = -0.5 * width; x <= 0.5 * width; x += 0.03) {
      for (double z = 0.0; z <= 3.0; z += 0.03) orientation.add({x, 2.0, z}, {0.0, 0.0, 1.0});
    }
    EXPECT_EQ(orientation.oriented().empty(), width < 0.3) << width;
  }
}

}  // namespace
}  // namespace surefoot::mapping
