// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "surefoot/quantile.hpp"

namespace surefoot::report {

namespace {
constexpr double kTickSize = 19.0;
constexpr double kLabelSize = 21.0;
constexpr double kNumberGap = 10.0;    // [px] between the y axis and its numbers
constexpr double kLabelGap = 11.0;     // [px] between the widest of them and the label's base line
constexpr double kLeastLabel = 74.0;   // [px] from the axis to that: labels of panels in line
constexpr double kLabelHeight = 22.0;  // [px] above the base line

double label_distance(Canvas& canvas, const PlotArea& area, const AxisLabels& labels) {
  const Ticks ticks = nice_ticks(area.y, labels.y_ticks);
  double widest = 0.0;
  for (const double value : ticks.values) {
    const double width = canvas.text_width(tick_label(value, ticks.step), {.size = kTickSize});
    widest = std::max(widest, width);
  }
  return std::max(kLeastLabel, kNumberGap + widest + kLabelGap);
}

}  // namespace

bool is_drawable(double value) { return std::abs(value) <= kFarthest; }

bool is_drawable(const Eigen::Vector3d& point) {
  return is_drawable(point.x()) && is_drawable(point.y()) && is_drawable(point.z());
}

Range range_of(std::span<const double> values) {
  if (values.empty()) return {0.0, 0.0};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

Range range_within(const std::vector<double>& values, double tail) {
  return {quantile(values, tail), quantile(values, 1.0 - tail)};
}

Range padded(const Range& range, double share, double min_width) {
  const double half = std::max((0.5 + share) * range.width(), 0.5 * min_width);
  return {range.center() - half, range.center() + half};
}

Range time_range(std::span<const double> times) {
  const Range range = range_of(times);
  return {range.low, std::max(range.high, range.low + 1.0)};
}

double round_step(double at_least) {
  const double power = std::pow(10.0, std::floor(std::log10(at_least)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= at_least) step = factor * power;
  }
  return step;
}

Ticks nice_ticks(const Range& range, int count) {
  count = std::max(count, 1);
  const double step = round_step(range.width() / count);
  Ticks ticks{step, {}};
  const double last = std::floor(range.high / step + 1e-9);
  for (double i = std::ceil(range.low / step - 1e-9); i <= last; i += 1.0) {
    ticks.values.push_back(i * step);
  }
  // A single number tells nobody how large the range is.
  return ticks.values.size() < 2 && count < 8 ? nice_ticks(range, 2 * count) : ticks;
}

std::string tick_label(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  // Rounding first keeps a tick at zero from being written as "-0".
  const double rounded = std::abs(value) < 0.5 * step ? 0.0 : value;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), std::abs(rounded) < 1e7 ? "%.*f" : "%.*e", decimals,
                rounded);
  const std::string label = text.data();
  return label.front() == '-' ? "\u2212" + label.substr(1) : label;
}

Pixel PlotArea::at(double x_value, double y_value) const {
  return {rect.x + (x_value - x.low) / x.width() * rect.width,
          rect.bottom() - (y_value - y.low) / y.width() * rect.height};
}

PlotArea equal_aspect(const Rect& rect, const Range& x, const Range& y) {
  const double unit = std::max(x.width() / rect.width, y.width() / rect.height);  // per pixel
  const double half_x = 0.5 * unit * rect.width, half_y = 0.5 * unit * rect.height;
  return {
      rect, {x.center() - half_x, x.center() + half_x}, {y.center() - half_y, y.center() + half_y}};
}

double left_margin(Canvas& canvas, const PlotArea& area, const AxisLabels& labels) {
  return label_distance(canvas, area, labels) + kLabelHeight;
}

void draw_grid(Canvas& canvas, const PlotArea& area, const AxisLabels& labels) {
  for (const double value : nice_ticks(area.x, labels.x_ticks).values) {
    const std::array<Pixel, 2> ends = {area.at(value, area.y.low), area.at(value, area.y.high)};
    canvas.line(ends, kGrid);
  }
  for (const double value : nice_ticks(area.y, labels.y_ticks).values) {
    const std::array<Pixel, 2> ends = {area.at(area.x.low, value), area.at(area.x.high, value)};
    canvas.line(ends, kGrid);
  }
}

void draw_axes(Canvas& canvas, const PlotArea& area, const AxisLabels& labels) {
  canvas.outline(area.rect, kFrame);
  TextStyle number{.size = kTickSize, .anchor = Anchor::center};
  if (!labels.x.empty()) {
    const Ticks ticks = nice_ticks(area.x, labels.x_ticks);
    for (const double value : ticks.values) {
      canvas.text(tick_label(value, ticks.step), area.at(value, area.y.low) + Pixel(0.0, 26.0),
                  number);
    }
    canvas.text(labels.x, {area.rect.center().x(), area.rect.bottom() + 56.0},
                {.size = kLabelSize, .anchor = Anchor::center});
  }
  number.anchor = Anchor::right;
  const Ticks ticks = nice_ticks(area.y, labels.y_ticks);
  for (const double value : ticks.values) {
    canvas.text(tick_label(value, ticks.step), area.at(area.x.low, value) + Pixel(-kNumberGap, 7.0),
                number);
  }
  const double distance = label_distance(canvas, area, labels);
  canvas.text(labels.y, {area.rect.x - distance, area.rect.center().y()},
              {.size = kLabelSize, .anchor = Anchor::center, .upward = true});
}

void draw_heading(Canvas& canvas, const Rect& rect, const std::string& heading) {
  canvas.text(heading, {rect.x, rect.y - 16.0}, {.size = 24.0, .bold = true});
}

}  // namespace surefoot::report
