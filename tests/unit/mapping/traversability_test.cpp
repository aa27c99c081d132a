// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/traversability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace surefoot::mapping {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Ground that a LiDAR has seen from 1 m above it, to a centimetre (one sigma): 10 x 10 m.
Piece ground(const std::function<double(double, double)>& height) {
  Piece piece;
  piece.eyes = {Eigen::Vector3f(0.0F, 0.0F, 1.0F)};
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (double x = -5.0; x < 5.0; x += 0.04) {
    for (double y = -5.0; y < 5.0; y += 0.04) {
      piece.points.emplace_back(x, y, height(x, y) + noise(random));
    }
  }
  piece.seen_from.assign(piece.points.size(), 0);
  return piece;
}

struct Layers {
  ElevationGrid grid;
  Traversability found;

  explicit Layers(const std::function<double(double, double)>& height)
      : grid(draw_elevation({ground(height)})), found(draw_traversability(grid, {})) {}
  [[nodiscard]] float at(const std::vector<float>& layer, double x, double y) const {
    const auto row = static_cast<std::size_t>((y - grid.low.y()) / grid.cell);
    return layer[row * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>((x - grid.low.x()) / grid.cell)];
  }
};

TEST(TraversabilityTest, FlatGroundIsGoodAndWhatWasNotSeenIsUnknown) {
  const Layers layers([](double, double) { return 0.0; });
  EXPECT_NEAR(layers.at(layers.found.slope, 1.0, 1.0), 0.0, 0.5 * kDegree);
  EXPECT_LT(layers.at(layers.found.step, 1.0, 1.0), 0.015);
  EXPECT_LT(layers.at(layers.found.roughness, 1.0, 1.0), 0.005);
  EXPECT_GT(layers.at(layers.found.score, 1.0, 1.0), 0.9);
  EXPECT_TRUE(std::isnan(layers.found.score[0]));
}

TEST(TraversabilityTest, ARampHasItsSlopeAndNoStepWhereItBeginsOrEnds) {
  const double rise = std::tan(15.0 * kDegree);
  const Layers layers([&](double x, double) { return rise * std::clamp(x, -1.0, 1.0); });
  for (double y : {-2.0, 0.0, 2.0}) {
    EXPECT_NEAR(layers.at(layers.found.slope, 0.1, y), 15.0 * kDegree, 1.0 * kDegree);
    EXPECT_NEAR(layers.at(layers.found.score, 0.1, y), 0.5, 0.05);  // of 30 degrees
    EXPECT_NEAR(layers.at(layers.found.slope, 2.5, y), 0.0, 1.0 * kDegree);
    for (double x = -2.0; x < 2.0; x += 0.2) {
      EXPECT_LT(layers.at(layers.found.step, x, y), 0.04) << x;
    }
  }
}

TEST(TraversabilityTest, AKerbHasItsHeightWhereverItCutsTheCells) {
  for (const double place : {0.0, 0.05, 0.1, 0.15}) {
    const Layers layers([&](double x, double) { return x < place ? 0.0 : 0.12; });
    for (const double y : {-2.05, 0.05, 2.05}) {
      EXPECT_NEAR(layers.at(layers.found.step, place, y), 0.12, 0.015) << place;
      EXPECT_LT(layers.at(layers.found.score, place, y), 0.4) << place;
      EXPECT_LT(layers.at(layers.found.step, place + 1.5, y), 0.015) << place;
    }
  }
  const Layers wall([](double x, double) { return x < 0.0 ? 0.0 : 0.4; });
  EXPECT_EQ(wall.at(wall.found.score, 0.05, 1.0), 0.0F);
}

TEST(TraversabilityTest, RubbleIsRoughWithoutALongStep) {
  const Layers layers([](double x, double y) {
    return 0.06 * std::sin(x * std::numbers::pi / 0.4) * std::sin(y * std::numbers::pi / 0.4);
  });
  EXPECT_GT(layers.at(layers.found.roughness, 1.0, 1.0), 0.015);
  EXPECT_LT(layers.at(layers.found.score, 1.0, 1.0), 0.7);
}

}  // namespace
}  // namespace surefoot::mapping
