// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/series_figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "png_image.hpp"
#include "report/figure_curves.hpp"

namespace surefoot::report {
namespace {

namespace fs = std::filesystem;

fs::path series_scratch(const std::string& name) {
  return fs::path(testing::TempDir()) / ("series_figure_" + name);
}

std::uint32_t rgb_of(const Color& color) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255 * share));
  };
  return byte(color.red) << 16 | byte(color.green) << 8 | byte(color.blue);
}

/// A constant curve for each value, over ten seconds.
SeriesFigure series_of(const std::vector<double>& values) {
  SeriesFigure figure{.quantity = "error [m]", .panels = {{.title = "walk"}}};
  for (const double value : values) {
    figure.names.push_back("m" + std::to_string(figure.names.size()));
    figure.panels[0].curves.push_back({{0.0, 5.0, 10.0}, {value, value, value}});
  }
  return figure;
}

/// The row in which most pixels have the curve's colour: not the legend's sample, which is shorter.
int row_of(const PngImage& image, std::size_t curve) {
  const std::uint32_t rgb = rgb_of(stroke_of(curve).color);
  int best = -1, most = 0;
  for (int y = 0; y < image.height(); ++y) {
    int count = 0;
    for (int x = 0; x < image.width(); ++x) count += image.at(x, y) == rgb ? 1 : 0;
    if (count > most) {
      most = count;
      best = y;
    }
  }
  return best;
}

TEST(SeriesFigure, NoLineLeadsFromASegmentToAnother) {
  const fs::path path = series_scratch("segments.png");
  const auto blues = [&](const std::vector<std::size_t>& begins) {
    SeriesFigure figure = series_of({1.0});
    figure.panels[0].curves[0] = {{0.0, 1.0, 9.0, 10.0}, {1.0, 1.0, 1.0, 1.0}, begins};
    draw_series_figure(figure, path);
    return PngImage(path).count(rgb_of(stroke_of(0).color));
  };
  const int whole = blues({});
  EXPECT_LT(blues({2}), whole / 2);
  EXPECT_EQ(blues({0}), whole);
}

TEST(SeriesFigure, DecadesAreEquallyFarApart) {
  const fs::path path = series_scratch("decades.png");
  draw_series_figure(series_of({1.0, 0.1, 0.01}), path);
  const PngImage image(path);
  ASSERT_TRUE(image.valid());
  const int top = row_of(image, 0), middle = row_of(image, 1), bottom = row_of(image, 2);
  EXPECT_GT(middle - top, 100);
  EXPECT_NEAR(middle - top, bottom - middle, 4);
}

TEST(SeriesFigure, WhatHasNoLogarithmIsNoTrouble) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  SeriesFigure figure = series_of({1.0, 1e-300, 0.0, -1.0, kNan, kInf});
  figure.panels[0].curves[0].times[1] = kNan;
  figure.panels.push_back({.title = "empty", .curves = std::vector<TimeSeries>(6)});
  for (const char* name : {"odd.png", "odd.svg", "odd.pdf"}) {
    draw_series_figure(figure, series_scratch(name));
    EXPECT_GT(fs::file_size(series_scratch(name)), 1000U) << name;
  }
}

TEST(SeriesFigure, WhatCannotBeDrawnIsRefused) {
  EXPECT_THROW(draw_series_figure({}, series_scratch("none.png")), std::invalid_argument);
  SeriesFigure figure = series_of({1.0});
  figure.names.emplace_back("another");
  EXPECT_THROW(draw_series_figure(figure, series_scratch("none.png")), std::invalid_argument);
  figure = series_of({1.0});
  figure.panels[0].curves[0].values.pop_back();
  EXPECT_THROW(draw_series_figure(figure, series_scratch("none.png")), std::invalid_argument);
  EXPECT_THROW(draw_series_figure(series_of({1.0}), "/nowhere/at/all.png"), std::runtime_error);
}

}  // namespace
}  // namespace surefoot::report
