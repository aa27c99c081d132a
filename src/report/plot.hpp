// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Ranges, ticks and axes: what the panels of a picture have in common.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/canvas.hpp"

namespace surefoot::report {

/// Coordinates beyond this [m] are no place that a robot can be at; they would spoil every range.
inline constexpr double kFarthest = 1e9;

/// False for NaN, infinities and coordinates beyond kFarthest.
[[nodiscard]] bool is_drawable(double value);
[[nodiscard]] bool is_drawable(const Eigen::Vector3d& point);

struct Range {
  double low = 0.0, high = 1.0;
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double center() const { return low + 0.5 * (high - low); }
};

/// What grids and frames of all figures are drawn with.
inline constexpr Stroke kGrid{{0.88, 0.89, 0.91}, 1.0};
inline constexpr Stroke kFrame{{0.45, 0.48, 0.53}, 1.5};

/// Smallest range that holds all values, [0, 0] if there are none.
[[nodiscard]] Range range_of(std::span<const double> values);
/// The range between the quantiles `tail` and 1 - `tail` of the values, [0, 0] if there are none.
[[nodiscard]] Range range_within(const std::vector<double>& values, double tail);
/// The range made wider by `share` of its width at both ends, and at least `min_width` wide.
[[nodiscard]] Range padded(const Range& range, double share, double min_width);
/// Of times [s]: from the first one on, a second at least.
[[nodiscard]] Range time_range(std::span<const double> times);

/// The least of 1, 2 and 5 times a power of ten that is not below.
[[nodiscard]] double round_step(double at_least);
/// Multiples of such a one within the range.
struct Ticks {
  double step = 1.0;
  std::vector<double> values;
};
/// About `count` ticks, but not a single one; the range must be finite and wider than zero.
[[nodiscard]] Ticks nice_ticks(const Range& range, int count);
/// The tick's number with as many decimals as the step needs.
[[nodiscard]] std::string tick_label(double value, double step);

/// A rectangle of the page with data coordinates, y up.
struct PlotArea {
  Rect rect;
  Range x, y;
  [[nodiscard]] Pixel at(double x_value, double y_value) const;
};

/// The area whose pixels are square in data units, with at least the given ranges, centred.
[[nodiscard]] PlotArea equal_aspect(const Rect& rect, const Range& x, const Range& y);

struct AxisLabels {
  std::string x;  ///< empty: neither label nor tick numbers
  std::string y;
  int x_ticks = 6;
  int y_ticks = 6;
};
/// [px] What the y axis' numbers and label take beside the rectangle.
[[nodiscard]] double left_margin(Canvas& canvas, const PlotArea& area, const AxisLabels& labels);
/// Light grid lines; drawn before the data.
void draw_grid(Canvas& canvas, const PlotArea& area, const AxisLabels& labels);
/// Frame, tick numbers and labels; drawn after the data.
void draw_axes(Canvas& canvas, const PlotArea& area, const AxisLabels& labels);
/// A panel's heading above its rectangle.
void draw_heading(Canvas& canvas, const Rect& rect, const std::string& heading);

}  // namespace surefoot::report
