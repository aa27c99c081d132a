// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "report/color_map.hpp"

namespace surefoot::report {
namespace {

TEST(Plot, NiceTicksAreRoundAndInsideAndNotTooMany) {
  for (const double center : {0.0, 3.7, -120.0, 5.4e6, -1e9}) {
    for (const double width : {0.05, 0.5, 1.0, 7.3, 42.0, 999.0, 1e5, 2e9}) {
      const Range range{center - 0.5 * width, center + 0.5 * width};
      const Ticks ticks = nice_ticks(range, 6);
      EXPECT_LE(ticks.values.size(), 7U);
      EXPECT_GE(ticks.values.size(), 2U);
      const double mantissa = ticks.step / std::pow(10.0, std::floor(std::log10(ticks.step)));
      EXPECT_TRUE(std::abs(mantissa - 1.0) < 1e-6 || std::abs(mantissa - 2.0) < 1e-6 ||
                  std::abs(mantissa - 5.0) < 1e-6)
          << ticks.step;
      for (const double value : ticks.values) {
        EXPECT_GE(value, range.low - 1e-6 * width);
        EXPECT_LE(value, range.high + 1e-6 * width);
      }
    }
  }
}

TEST(Plot, NiceTicksOfAKnownRange) {
  const Ticks ticks = nice_ticks({-0.3, 1.1}, 4);
  EXPECT_DOUBLE_EQ(ticks.step, 0.5);
  ASSERT_EQ(ticks.values.size(), 3U);
  EXPECT_DOUBLE_EQ(ticks.values[0], 0.0);
  EXPECT_DOUBLE_EQ(ticks.values[2], 1.0);
}

TEST(Plot, ASingleTickIsNone) {
  const Ticks ticks = nice_ticks({-4.3, 4.4}, 3);
  EXPECT_DOUBLE_EQ(ticks.step, 2.0);
  EXPECT_EQ(ticks.values.size(), 5U);
}

TEST(Plot, TickLabelsHaveTheDecimalsOfTheStep) {
  EXPECT_EQ(tick_label(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(tick_label(0.25, 0.05), "0.25");
  EXPECT_EQ(tick_label(20.0, 20.0), "20");
  EXPECT_EQ(tick_label(-5.0, 5.0), "\u22125");
  EXPECT_EQ(tick_label(-1e-17, 0.5), "0.0");
  EXPECT_EQ(tick_label(5429380.0, 20.0), "5429380");
  EXPECT_EQ(tick_label(5e8, 5e8), "5e+08");
}

TEST(Plot, RangeWithinLeavesTheTailsOut) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i == 100 ? 1e6 : i);
  const Range range = range_within(values, 0.05);
  EXPECT_DOUBLE_EQ(range.low, 5.0);
  EXPECT_DOUBLE_EQ(range.high, 95.0);
  EXPECT_DOUBLE_EQ(range_within({}, 0.05).width(), 0.0);
  EXPECT_DOUBLE_EQ(range_within({3.0}, 0.05).low, 3.0);
}

TEST(Plot, TimesBeginWithTheFirstAndAreASecondWide) {
  const Range brief = time_range(std::vector{2.0, 2.3}),
              hour = time_range(std::vector{0.0, 3600.0});
  EXPECT_DOUBLE_EQ(brief.low, 2.0);
  EXPECT_DOUBLE_EQ(brief.high, 3.0);
  EXPECT_DOUBLE_EQ(hour.high, 3600.0);
}

TEST(Plot, EqualAspectKeepsBothRangesInsideAndPixelsSquare) {
  const PlotArea area = equal_aspect({10.0, 20.0, 400.0, 200.0}, {0.0, 10.0}, {-1.0, 9.0});
  EXPECT_DOUBLE_EQ(area.x.width() / 400.0, area.y.width() / 200.0);
  EXPECT_DOUBLE_EQ(area.y.low, -1.0);
  EXPECT_DOUBLE_EQ(area.x.low, -5.0);
  EXPECT_DOUBLE_EQ(area.x.high, 15.0);
  EXPECT_TRUE(area.at(5.0, 4.0).isApprox(Pixel(210.0, 120.0)));
  EXPECT_TRUE(area.at(5.0, 9.0).isApprox(Pixel(210.0, 20.0))) << "y grows upwards";
}

/// How many columns of pixels lie blank between the y axis' label and the widest of its numbers; it
/// takes `margin` pixels.
int gap_beside_numbers(const Range& y, double& margin) {
  constexpr int kAxis = 200;
  Canvas canvas(600, 400, PageFormat::png);
  const PlotArea area{{kAxis, 20.0, 380.0, 300.0}, {0.0, 1.0}, y};
  const AxisLabels labels{.x = "", .y = "y [m]"};
  margin = left_margin(canvas, area, labels);
  draw_axes(canvas, area, labels);
  const Raster raster = canvas.raster();
  int blank = 0, most = 0;
  bool inked_before = false;
  for (int x = 0; x < kAxis - 6; ++x) {
    bool inked = false;
    for (int row = 0; row < raster.height; ++row) {
      const auto at = static_cast<std::size_t>(row * raster.width + x);
      inked = inked || (raster.argb[at] & 0xFFU) < 0xC0U;
    }
    EXPECT_FALSE(inked && x < kAxis - margin) << x;
    if (inked && inked_before) most = std::max(most, blank);
    blank = inked ? 0 : blank + 1;
    inked_before = inked_before || inked;
  }
  return most;
}

TEST(Plot, AxisLabelsClearTheWidestNumber) {
  double usual = 0.0, wide = 0.0;
  EXPECT_GE(gap_beside_numbers({0.0, 10.0}, usual), 5);
  EXPECT_GE(gap_beside_numbers({519.6, 519.9}, wide), 5);
  EXPECT_GT(wide, usual);
  EXPECT_GE(gap_beside_numbers({-11.97, -11.9}, wide), 5);
  EXPECT_GE(gap_beside_numbers({5429380.0, 5429400.0}, wide), 5);
}

TEST(Plot, WhatCannotBeDrawn) {
  EXPECT_FALSE(is_drawable(std::nan("")));
  EXPECT_FALSE(is_drawable(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(is_drawable(-1.1e9));
  EXPECT_TRUE(is_drawable(1e9));
  EXPECT_FALSE(is_drawable(Eigen::Vector3d(0.0, 0.0, std::nan(""))));
}

TEST(ColorMap, EndsAreViridisAndLightnessOnlyGrows) {
  EXPECT_NEAR(viridis(0.0).red, 0x44 / 255.0, 1e-12);
  EXPECT_NEAR(viridis(0.0).blue, 0x54 / 255.0, 1e-12);
  EXPECT_NEAR(viridis(1.0).green, 0xe7 / 255.0, 1e-12);
  EXPECT_NEAR(viridis(7.0).red, viridis(1.0).red, 1e-12);
  double last = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const Color color = viridis(i / 100.0);
    const double luminance = 0.2126 * std::pow(color.red, 2.2) +
                             0.7152 * std::pow(color.green, 2.2) +
                             0.0722 * std::pow(color.blue, 2.2);
    EXPECT_GT(luminance, last) << i;
    last = luminance;
  }
}

}  // namespace
}  // namespace surefoot::report
