// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/ratio_figure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "png_image.hpp"

namespace surefoot::report {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWorse = 0xD55E00, kBetter = 0x0072B2;

RatioFigure ratios_of(double median, bool notable) {
  RatioFigure figure{.title = "Worth", .axis = "ratio", .figure_names = {"median"}, .spread = 1.2};
  figure.rows = {{.group = "Deskewing",
                  .label = "none",
                  .remark = "(5)-(12)",
                  .ratios = {0.5 * median, median, 2.0 * median},
                  .median = median,
                  .notable = notable,
                  .figures = {"1.00"}}};
  return figure;
}

fs::path ratio_scratch(const std::string& name) {
  return fs::path(testing::TempDir()) / ("ratio_figure_" + name);
}

TEST(LogarithmicTicks, AreOnesTwosAndFives) {
  EXPECT_EQ(logarithmic_ticks(0.1, 10.0),
            (std::vector<double>{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0}));
  EXPECT_EQ(logarithmic_ticks(0.3, 3.0), (std::vector<double>{0.5, 1.0, 2.0}));
}

TEST(RatioFigure, WorseAndBetterHaveTheirColours) {
  for (const double median : {0.5, 2.0}) {
    const fs::path path = ratio_scratch("colours.png");
    draw_ratio_figure(ratios_of(median, true), path);
    const PngImage image(path);
    ASSERT_TRUE(image.valid());
    // The words at the axis have both colours; the bar has its own besides.
    const int worse = image.count(kWorse), better = image.count(kBetter);
    EXPECT_GT(median > 1.0 ? worse : better, 200 + (median > 1.0 ? better : worse));
    draw_ratio_figure(ratios_of(median, false), path);
    const PngImage grey(path);
    EXPECT_LT(grey.count(median > 1.0 ? kWorse : kBetter), median > 1.0 ? worse : better);
  }
}

TEST(RatioFigure, WhatIsLostOrFarAwayIsNoTrouble) {
  constexpr double kLost = std::numeric_limits<double>::infinity();
  RatioFigure figure = ratios_of(1.0, false);
  figure.rows.push_back(
      {.group = "Map", .ratios = {kLost, 1e300, 1e-300}, .median = kLost, .figures = {"lost"}});
  figure.spread = kLost;
  const fs::path path = ratio_scratch("lost.svg");
  draw_ratio_figure(figure, path);
  std::ifstream in(path, std::ios::binary);
  const std::string svg{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(RatioFigure, NonsenseIsRefused) {
  RatioFigure figure = ratios_of(1.0, false);
  EXPECT_THROW(draw_ratio_figure({}, ratio_scratch("none.png")), std::invalid_argument);
  EXPECT_THROW(draw_ratio_figure(figure, ratio_scratch("picture.gif")), std::runtime_error);
  figure.rows[0].figures.clear();
  EXPECT_THROW(draw_ratio_figure(figure, ratio_scratch("figures.png")), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::report
