// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/floam_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "support/default_parameters.hpp"

namespace surefoot {
namespace {

FloamParameters floam_defaults() { return test::default_parameters<FloamParameters>(); }

/// One line of points, seen from a square room's middle: four corners.
PreparedScan square_room(int columns, double half_side, double elevation_deg = 1.0) {
  PreparedScan scan;
  for (int i = 0; i < columns; ++i) {
    const double a = 2.0 * std::numbers::pi * (i + 0.5) / columns;
    const double range = half_side / std::max(std::abs(std::cos(a)), std::abs(std::sin(a)));
    const double z = range * std::tan(elevation_deg * std::numbers::pi / 180.0);
    scan.points.push_back(
        Eigen::Vector3d(range * std::cos(a), range * std::sin(a), z).cast<float>());
  }
  return scan;
}

TEST(FloamFeatures, CurvatureIsThatOfLoam) {
  const std::vector<Eigen::Vector3f>& line = square_room(200, 5.0).points;
  for (std::size_t i = 5; i + 5 < line.size(); i += 7) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = i - 5; k <= i + 5; ++k) {
      sum += line[k].cast<double>() - line[i].cast<double>();
    }
    EXPECT_NEAR(curvature(line, i), sum.squaredNorm(), 1e-3 * (1.0 + sum.squaredNorm()));
  }
}

TEST(FloamFeatures, CornersAreEdgesAndWallsAreSurfaces) {
  const PreparedScan scan = square_room(720, 5.0);
  const FloamFeatures features = extract_features(scan, floam_defaults());
  ASSERT_FALSE(features.edges.empty());
  for (const std::uint32_t edge : features.edges) {
    const Eigen::Vector2f p = scan.points[edge].head<2>().cwiseAbs();
    EXPECT_GT(p.minCoeff(), 4.5F) << "an edge far from every corner";
  }
  EXPECT_GT(features.surfaces.size(), 600U);
  std::set<std::uint32_t> all(features.edges.begin(), features.edges.end());
  for (const std::uint32_t surface : features.surfaces) {
    EXPECT_TRUE(all.insert(surface).second) << "edge and surface at once";
  }
}

TEST(FloamFeatures, TheOriginalLosesEachSectorsLastPoint) {
  const PreparedScan scan = square_room(300, 5.0);
  FloamParameters config = floam_defaults();
  const auto kept = [&] {
    const FloamFeatures features = extract_features(scan, config);
    return features.edges.size() + features.surfaces.size();
  };
  const std::size_t original = kept();
  config.whole_sectors = true;
  EXPECT_GT(kept(), original);
  EXPECT_LE(kept(), original + 6);
}

TEST(FloamFeatures, ShortLinesAndFarPointsAreLeftOut) {
  EXPECT_TRUE(extract_features(square_room(130, 5.0), floam_defaults()).surfaces.empty());
  EXPECT_FALSE(extract_features(square_room(131, 5.0), floam_defaults()).surfaces.empty());
  EXPECT_TRUE(extract_features(square_room(300, 95.0), floam_defaults()).surfaces.empty());
  EXPECT_TRUE(extract_features(square_room(300, 0.3), floam_defaults()).surfaces.empty());
}

TEST(FloamFeatures, LinesAreCountedByElevationOrRing) {
  const auto at = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180.0;
    return Eigen::Vector3d(10.0 * std::cos(a), 0.0, 10.0 * std::sin(a)).cast<float>().eval();
  };
  for (int laser = 0; laser < 16; ++laser) {
    for (const double off : {-0.9, 0.0, 0.9}) {
      EXPECT_EQ(line_of(at(2.0 * laser - 15.0 + off), 16), laser);
    }
  }
  EXPECT_GE(line_of(at(17.0), 16), 16);
  EXPECT_LT(line_of(at(-20.0), 16), 0);
  EXPECT_EQ(line_of(at(1.99), 64), 0);
  EXPECT_LT(line_of(at(2.5), 64), 0);
  EXPECT_LT(line_of(at(-25.0), 64), 0);
  EXPECT_EQ(line_of(at(-30.0), 32), 0);

  PreparedScan scan = square_room(300, 5.0, 40.0);  // no laser of a VLP-16 looks up so steeply
  scan.rings.assign(scan.points.size(), 3);
  FloamParameters config = floam_defaults();
  EXPECT_TRUE(extract_features(scan, config).surfaces.empty());
  config.use_rings = true;
  EXPECT_FALSE(extract_features(scan, config).surfaces.empty());
  scan.rings.assign(scan.points.size(), 60'000);
  EXPECT_TRUE(extract_features(scan, config).surfaces.empty());
}

}  // namespace
}  // namespace surefoot
