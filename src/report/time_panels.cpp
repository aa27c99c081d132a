// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <string>

#include "report/panels.hpp"

namespace surefoot::report {

namespace {

/// A quantity of a pose over time.
struct Quantity {
  std::string label;
  std::function<double(const Pose&)> of;
  double smallest_range;  // in its unit; less is not blown up
};

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

const std::array<Quantity, 3>& quantities() {
  static const std::array<Quantity, 3> kQuantities = {{
      {"z [m]", [](const Pose& pose) { return pose.translation.z(); }, 0.05},
      {"roll [\u00b0]", [](const Pose& pose) { return degrees(roll_pitch_yaw(pose.rotation).x()); },
       0.5},
      {"pitch [\u00b0]",
       [](const Pose& pose) { return degrees(roll_pitch_yaw(pose.rotation).y()); }, 0.5},
  }};
  return kQuantities;
}

double seconds_after(std::int64_t stamp_ns, std::int64_t start_ns) {
  return 1e-9 * (static_cast<double>(stamp_ns) - static_cast<double>(start_ns));
}

struct Series {
  std::vector<double> times, values;
};

Series series_of(const Trajectory& trajectory, std::int64_t start_ns, const Quantity& quantity) {
  Series series;
  for (const StampedPose& stamped : trajectory) {
    series.times.push_back(seconds_after(stamped.stamp_ns, start_ns));
    series.values.push_back(quantity.of(stamped.pose));
  }
  return series;
}

std::vector<Pixel> to_pixels(const Series& series, const PlotArea& area) {
  std::vector<Pixel> pixels;
  for (std::size_t i = 0; i < series.times.size(); ++i) {
    pixels.push_back(area.at(series.times[i], series.values[i]));
  }
  return pixels;
}

/// Bands over the untrusted poses, each reaching half-way to its neighbours.
void shade_untrusted(Canvas& canvas, const PlotArea& area, const std::vector<double>& times,
                     const std::vector<bool>& untrusted) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!untrusted[i]) continue;
    const double before = i == 0 ? times[i] : 0.5 * (times[i - 1] + times[i]);
    const double after = i + 1 == times.size() ? times[i] : 0.5 * (times[i] + times[i + 1]);
    const double left = area.at(before, 0.0).x(), right = area.at(after, 0.0).x();
    canvas.fill({left, area.rect.y, std::max(right - left, 2.0), area.rect.height},
                style::kUntrusted);
  }
}

void draw_quantity(Canvas& canvas, const Rect& rect, const DrawnRun& run, const Quantity& quantity,
                   const std::string& time_label) {
  const Series path = series_of(run.path, run.first_ns, quantity);
  const Range time = time_range(path.times);
  Series reference = series_of(run.reference, run.first_ns, quantity);
  std::vector<double> values = path.values;
  for (std::size_t i = 0; i < reference.times.size(); ++i) {
    const bool beside = reference.times[i] >= time.low && reference.times[i] <= time.high;
    if (beside) values.push_back(reference.values[i]);
  }
  const PlotArea area{rect, time, padded(range_of(values), 0.1, quantity.smallest_range)};
  const AxisLabels labels{.x = time_label, .y = quantity.label, .x_ticks = 10, .y_ticks = 4};
  draw_grid(canvas, area, labels);
  canvas.clip(rect);
  shade_untrusted(canvas, area, path.times, run.untrusted);
  canvas.line(to_pixels(reference, area), {style::kReference, 0.7 * style::kReferenceWidth});
  draw_segments(canvas, to_pixels(path, area), run.segments, {style::kPath, 2.5});
  canvas.unclip();
  draw_axes(canvas, area, labels);
}

}  // namespace

void draw_time_panels(Canvas& canvas, const Rect& rect, const DrawnRun& run) {
  constexpr double kGap = 18.0;
  const auto& all = quantities();
  const auto count = static_cast<double>(all.size());
  const double height = (rect.height - kGap * (count - 1.0)) / count;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Rect part{rect.x, rect.y + (height + kGap) * static_cast<double>(i), rect.width, height};
    draw_quantity(canvas, part, run, all[i], i + 1 == all.size() ? "time [s]" : "");
  }
  draw_heading(canvas, rect, "Height, roll and pitch over time");
}

}  // namespace surefoot::report
