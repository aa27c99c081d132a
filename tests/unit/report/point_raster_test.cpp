// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/point_raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/color_map.hpp"

namespace surefoot::report {
namespace {

ParallelView view_from_above() {
  return {.center = {10.0, 20.0}, .pixels_per_metre = 10.0, .width = 100, .height = 60};
}

std::uint32_t pixel(const Raster& raster, int x, int y) {
  return raster.argb.at(static_cast<std::size_t>(y * raster.width + x));
}

std::uint32_t opaque(const Color& color) {
  const auto byte = [](double value) {
    return static_cast<std::uint32_t>(std::lround(value * 255.0));
  };
  return 0xFF000000U | byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
}

// A flat sheet so dense that each sample has a point.
std::vector<Eigen::Vector3f> sheet(float z, float low_x, float high_x) {
  std::vector<Eigen::Vector3f> points;
  for (float x = low_x; x < high_x; x += 0.025F) {
    for (float y = 17.0F; y < 23.0F; y += 0.025F) points.emplace_back(x, y, z);
  }
  return points;
}

TEST(PointRaster, APointLandsWhereTheProjectionSays) {
  const std::vector<Eigen::Vector3f> points = {{12.05F, 21.05F, 1.0F}};
  const Raster raster = draw_points(points, view_from_above(), {0.0, 2.0});
  ASSERT_EQ(raster.argb.size(), 6000U);
  EXPECT_NE(pixel(raster, 70, 19), 0U) << "20 px right and 10 px above the centre";
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 100; ++x) {
      if (std::abs(x - 70) > 4 || std::abs(y - 19) > 4) {
        EXPECT_EQ(pixel(raster, x, y), 0U);
      }
    }
  }
}

TEST(PointRaster, TheNearestPointIsSeenInTheColourOfItsHeight) {
  std::vector<Eigen::Vector3f> points = sheet(1.5F, 5.0F, 15.0F);
  const std::vector<Eigen::Vector3f> below = sheet(0.5F, 5.0F, 15.0F);
  points.insert(points.end(), below.begin(), below.end());
  const Raster from_above = draw_points(points, view_from_above(), {0.0, 2.0});
  EXPECT_EQ(pixel(from_above, 50, 30), opaque(viridis(0.75)));
  ParallelView from_below = view_from_above();
  from_below.axes.row(2) *= -1.0;
  EXPECT_EQ(pixel(draw_points(points, from_below, {0.0, 2.0}), 50, 30), opaque(viridis(0.25)));
}

TEST(PointRaster, PlanesKeepTheirColourAndStepsAreShaded) {
  std::vector<Eigen::Vector3f> points = sheet(0.5F, 5.0F, 10.0F);
  const std::vector<Eigen::Vector3f> upper = sheet(1.5F, 10.0F, 15.0F);
  points.insert(points.end(), upper.begin(), upper.end());
  const Raster raster = draw_points(points, view_from_above(), {0.0, 2.0});
  EXPECT_EQ(pixel(raster, 30, 30), opaque(viridis(0.25)));
  EXPECT_EQ(pixel(raster, 70, 30), opaque(viridis(0.75)));
  EXPECT_LT((pixel(raster, 48, 30) >> 8) & 0xFFU, (pixel(raster, 30, 30) >> 8) & 0xFFU)
      << "the foot of the step lies in the dark";
}

TEST(PointRaster, PointsThatCannotBeDrawnAreLeftOut) {
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  const float largest = std::numeric_limits<float>::max();
  const std::vector<Eigen::Vector3f> points = {{nan, 20.0F, 0.0F},   {10.0F, inf, 0.0F},
                                               {10.0F, 20.0F, -inf}, {largest, 20.0F, 0.0F},
                                               {1e8F, 1e8F, 0.0F},   {10.0F, 20.0F, largest}};
  const Raster raster = draw_points(points, view_from_above(), {0.0, 2.0});
  EXPECT_TRUE(std::all_of(raster.argb.begin(), raster.argb.end(),
                          [](std::uint32_t argb) { return argb == 0U; }));
}

}  // namespace
}  // namespace surefoot::report
