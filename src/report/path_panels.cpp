// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "report/panels.hpp"
#include "report/point_raster.hpp"

namespace surefoot::report {

namespace {

constexpr double kSmallestExtent = 2.0;   // [m] a shorter path is not blown up beyond this
constexpr double kSmallestHeight = 0.05;  // [m]

std::vector<double> coordinates(const Run& run, int axis) {
  std::vector<double> values;
  for (const Trajectory* trajectory : {&run.path, &run.reference}) {
    for (const StampedPose& stamped : *trajectory) {
      values.push_back(stamped.pose.translation[axis]);
    }
  }
  return values;
}

std::vector<Pixel> to_pixels(const Trajectory& trajectory, const PlotArea& area, int y_axis) {
  std::vector<Pixel> pixels;
  pixels.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) {
    pixels.push_back(area.at(stamped.pose.translation.x(), stamped.pose.translation[y_axis]));
  }
  return pixels;
}

/// The z range of the side view: equal aspect if the path fills it, else exaggerated by a round
/// factor.
struct SideRange {
  Range z;
  double exaggeration = 1.0;
};

SideRange side_range(const Rect& rect, const Range& x, const Range& z) {
  const double equal_height = x.width() * rect.height / rect.width;
  const Range needed = padded(z, 0.12, kSmallestHeight);
  double exaggeration = 1.0;
  const double possible = equal_height / needed.width();
  for (const double factor : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    if (factor <= possible) exaggeration = factor;
  }
  return {padded(needed, 0.0, equal_height / exaggeration), exaggeration};
}

/// One band for each stretch of untrusted poses; a single one reaches to its neighbours.
void draw_untrusted(Canvas& canvas, const std::vector<Pixel>& path,
                    const std::vector<bool>& untrusted) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!untrusted[i]) continue;
    const std::size_t first = i == 0 ? 0 : i - 1;
    while (i + 1 < path.size() && untrusted[i]) ++i;
    canvas.line(std::span(path).subspan(first, i - first + 1),
                {style::kUntrusted, style::kBandWidth});
  }
}

}  // namespace

void draw_path(Canvas& canvas, const std::vector<Pixel>& path, const std::vector<Pixel>& reference,
               const std::vector<bool>& untrusted) {
  draw_untrusted(canvas, path, untrusted);
  canvas.line(path, {style::kHalo, 9.0});
  canvas.line(path, {style::kPath, 4.5});
  canvas.line(reference, {style::kReference, 2.5, LineStyle::kDashed});
  if (path.empty()) return;
  const Stroke edge{{0.1, 0.1, 0.12}, 2.0};
  canvas.circle(path.front(), style::kMarkerRadius, style::kStart, edge);
  canvas.triangle(path.back(), 1.35 * style::kMarkerRadius, style::kEnd, edge);
}

void draw_path_panels(Canvas& canvas, const Rect& top, const Rect& side, const Run& run) {
  const Range x = padded(range_of(coordinates(run, 0)), 0.12, kSmallestExtent);
  const Range y = padded(range_of(coordinates(run, 1)), 0.12, kSmallestExtent);
  const PlotArea top_area = equal_aspect(top, x, y);
  const AxisLabels top_labels{.x = "x [m]", .y = "y [m]"};
  draw_grid(canvas, top_area, top_labels);
  canvas.clip(top);
  canvas.image(draw_points(run.map_points, top_view(top_area), run.heights), top, 0.4);
  draw_path(canvas, to_pixels(run.path, top_area, 1), to_pixels(run.reference, top_area, 1),
            run.untrusted);
  canvas.unclip();
  draw_axes(canvas, top_area, top_labels);
  draw_heading(canvas, top, "From above");

  const SideRange range = side_range(side, top_area.x, range_of(coordinates(run, 2)));
  const PlotArea side_area{side, top_area.x, range.z};
  const AxisLabels side_labels{.x = "x [m]", .y = "z [m]", .y_ticks = 5};
  draw_grid(canvas, side_area, side_labels);
  canvas.clip(side);
  draw_path(canvas, to_pixels(run.path, side_area, 2), to_pixels(run.reference, side_area, 2),
            run.untrusted);
  canvas.unclip();
  draw_axes(canvas, side_area, side_labels);
  const std::string scale =
      range.exaggeration > 1.0
          ? ", height \u00d7" + std::to_string(static_cast<int>(range.exaggeration))
          : "";
  draw_heading(canvas, side, "From the side" + scale);
}

}  // namespace surefoot::report
