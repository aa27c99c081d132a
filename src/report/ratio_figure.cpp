// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/ratio_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "report/canvas.hpp"
#include "report/plot.hpp"

namespace surefoot::report {

namespace {

constexpr int kDots = 2;                // of a PNG for each pixel of the page
constexpr double kLargest = 50.0;       // ratios beyond are drawn at the border
constexpr double kLeastEnd = 2.5;       // the axis reaches at least so far
constexpr double kLeft = 470.0;         // [px] of the axes
constexpr double kWidth = 560.0;        // [px] of the axes
constexpr double kFigureWidth = 100.0;  // [px] of a column right of the axes
constexpr double kTop = 118.0;          // [px] of the first row
constexpr double kRow = 29.0;           // [px]
constexpr double kHeading = 40.0;       // [px] a group's, its gap above included
constexpr double kBottom = 108.0;       // [px] below the last row
constexpr double kMargin = 24.0;        // [px]
constexpr double kTextSize = 19.0;
constexpr double kSmallSize = 17.0;

const Color kText{0.13, 0.15, 0.19};
const Color kGrey{0.45, 0.48, 0.53};
const Color kWorse{0.835, 0.369, 0.0};  // after Okabe and Ito (2008)
const Color kBetter{0.0, 0.447, 0.698};
const Color kBand{0.90, 0.92, 0.95};
const Stroke kOne{{0.25, 0.27, 0.32}, 1.8};

/// The axes, as far as all rows share them.
struct Axis {
  double low, high, top, bottom;
  [[nodiscard]] double x(double ratio) const {
    const double share = std::log(std::clamp(ratio, low, high) / low) / std::log(high / low);
    return kLeft + kWidth * share;
  }
};

/// Symmetric about 1, so that half and double are equally far from it.
Axis axis_of(const RatioFigure& figure) {
  double end = std::max(kLeastEnd, figure.spread);
  for (const RatioRow& row : figure.rows) {
    for (const double ratio : row.ratios) {
      if (std::isfinite(ratio) && ratio > 0.0) end = std::max({end, ratio, 1.0 / ratio});
    }
  }
  end = std::min(1.1 * end, kLargest);
  return {1.0 / end, end, kTop, kTop};
}

bool begins_group(const RatioFigure& figure, std::size_t row) {
  return row == 0 || figure.rows[row].group != figure.rows[row - 1].group;
}

std::string tick_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

void draw_axes(Canvas& canvas, const Axis& axis, const RatioFigure& figure) {
  const Rect rect{kLeft, axis.top, kWidth, axis.bottom - axis.top};
  const double band = axis.x(1.0 / figure.spread);
  canvas.fill({band, rect.y, axis.x(figure.spread) - band, rect.height}, kBand);
  for (const double tick : logarithmic_ticks(axis.low, axis.high)) {
    const double x = axis.x(tick);
    const std::array<Pixel, 2> ends = {Pixel(x, rect.y), Pixel(x, rect.bottom())};
    canvas.line(ends, tick == 1.0 ? kOne : kGrid);
    canvas.text(tick_text(tick), {x, rect.bottom() + 24.0},
                {.size = kSmallSize, .anchor = Anchor::center});
  }
  canvas.outline(rect, kFrame);
  canvas.text(figure.axis, {rect.center().x(), rect.bottom() + 54.0},
              {.size = kTextSize, .anchor = Anchor::center});
  canvas.text("dot: a recording; bar: their median; shaded: below the spread",
              {rect.center().x(), rect.bottom() + 80.0},
              {.size = kSmallSize, .color = kGrey, .anchor = Anchor::center});
  canvas.text("\u2190 better", {rect.x, rect.y - 14.0}, {.size = kSmallSize, .color = kBetter});
  canvas.text("worse \u2192", {rect.right(), rect.y - 14.0},
              {.size = kSmallSize, .color = kWorse, .anchor = Anchor::right});
}

void draw_row(Canvas& canvas, const Axis& axis, const RatioRow& row, double y) {
  const Color color = !row.notable ? kGrey : row.median > 1.0 ? kWorse : kBetter;
  canvas.text(row.label, {kMargin + 16.0, y + 6.0}, {.size = kTextSize, .color = kText});
  canvas.text(row.remark, {kLeft - 14.0, y + 6.0},
              {.size = kSmallSize, .color = kGrey, .anchor = Anchor::right});
  for (const double ratio : row.ratios) {
    if (!std::isfinite(ratio)) continue;
    canvas.circle({axis.x(ratio), y}, 4.5, color.with_alpha(0.35), {color.with_alpha(0.55), 0.8});
  }
  if (std::isfinite(row.median)) {
    const std::array<Pixel, 2> bar = {Pixel(axis.x(row.median), y - 11.0),
                                      Pixel(axis.x(row.median), y + 11.0)};
    canvas.line(bar, {color, 4.0});
  }
  double x = kLeft + kWidth;
  for (const std::string& text : row.figures) {
    x += kFigureWidth;
    canvas.text(text, {x, y + 6.0},
                {.size = kTextSize, .color = row.notable ? color : kText, .anchor = Anchor::right});
  }
}

void draw_head(Canvas& canvas, const RatioFigure& figure) {
  canvas.text(figure.title, {kMargin, kMargin + 22.0}, {.size = 24.0, .bold = true});
  double x = kLeft + kWidth;
  for (const std::string& name : figure.figure_names) {
    x += kFigureWidth;
    canvas.text(name, {x, kTop - 14.0},
                {.size = kSmallSize, .color = kGrey, .anchor = Anchor::right});
  }
}

void check(const RatioFigure& figure) {
  if (figure.rows.empty()) throw std::invalid_argument("a figure of ratios needs a row");
  for (const RatioRow& row : figure.rows) {
    if (row.figures.size() != figure.figure_names.size()) {
      throw std::invalid_argument("row '" + row.label + "' has " +
                                  std::to_string(row.figures.size()) + " figures for " +
                                  std::to_string(figure.figure_names.size()) + " names");
    }
  }
}

}  // namespace

std::vector<double> logarithmic_ticks(double low, double high) {
  std::vector<double> ticks;
  const auto last = static_cast<int>(std::floor(std::log10(high)));
  for (int power = static_cast<int>(std::floor(std::log10(low))); power <= last; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      // Dividing keeps 0.1 and 0.5 the numbers that they are written as.
      const double tick =
          power < 0 ? factor / std::pow(10.0, -power) : factor * std::pow(10.0, power);
      if (tick >= low && tick <= high) ticks.push_back(tick);
    }
  }
  return ticks;
}

void draw_ratio_figure(const RatioFigure& figure, const std::filesystem::path& path) {
  check(figure);
  const PageFormat format = page_format_of(path);
  Axis axis = axis_of(figure);
  for (std::size_t i = 0; i < figure.rows.size(); ++i) {
    axis.bottom += kRow + (begins_group(figure, i) ? kHeading : 0.0);
  }
  axis.bottom += 0.3 * kRow;
  const double columns = static_cast<double>(figure.figure_names.size());
  const double width = kLeft + kWidth + kFigureWidth * columns + kMargin;
  Canvas canvas(static_cast<int>(width), static_cast<int>(axis.bottom + kBottom), format, kDots);
  draw_head(canvas, figure);
  draw_axes(canvas, axis, figure);
  double y = kTop;
  for (std::size_t i = 0; i < figure.rows.size(); ++i) {
    if (begins_group(figure, i)) {
      y += kHeading;
      canvas.text(figure.rows[i].group, {kMargin, y - 6.0}, {.size = kTextSize, .bold = true});
    }
    y += kRow;
    draw_row(canvas, axis, figure.rows[i], y - 0.5 * kRow);
  }
  canvas.save(path, PictureKind::figure);
}

}  // namespace surefoot::report
