// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "report/color_map.hpp"
#include "report/panels.hpp"
#include "report/point_raster.hpp"

namespace surefoot::report {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTurn = 0.35;  // [rad] from the map's long side, so that walls show two faces

std::vector<Eigen::Vector3d> sample_in_view(const DrawnRun& run) {
  std::vector<Eigen::Vector3d> sample;
  const std::size_t stride = run.map_points.size() / kSampledPoints + 1;
  for (std::size_t i = 0; i < run.map_points.size(); i += stride) {
    const Eigen::Vector3d point = run.map_points[i].cast<double>();
    const bool inside = point.x() >= run.map_x.low && point.x() <= run.map_x.high &&
                        point.y() >= run.map_y.low && point.y() <= run.map_y.high;
    if (inside && is_drawable(point)) sample.push_back(point);
  }
  for (const StampedPose& stamped : run.path) sample.push_back(stamped.pose.translation);
  return sample;
}

/// Heading [rad] of the longest horizontal direction, in (-pi/2, pi/2].
double long_side(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point.head<2>();
  mean /= std::max<double>(1.0, static_cast<double>(points.size()));
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector2d off = point.head<2>() - mean;
    spread += off * off.transpose();
  }
  return 0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

/// Axes of a viewer who looks along `heading` turned by 90 degrees, `elevation` above the horizon.
Eigen::Matrix3d oblique_axes(double heading, double elevation) {
  const Eigen::Vector3d right(std::cos(heading), std::sin(heading), 0.0);
  const Eigen::Vector3d away(-std::sin(heading), std::cos(heading), 0.0);
  Eigen::Matrix3d axes;
  axes.row(0) = right;
  axes.row(1) = std::sin(elevation) * away + std::cos(elevation) * Eigen::Vector3d::UnitZ();
  axes.row(2) = -std::cos(elevation) * away + std::sin(elevation) * Eigen::Vector3d::UnitZ();
  return axes;
}

ParallelView fitted_view(const Rect& rect, const std::vector<Eigen::Vector3d>& points,
                         const Eigen::Matrix3d& axes) {
  std::vector<double> right, up;
  for (const Eigen::Vector3d& point : points) {
    right.push_back(axes.row(0).dot(point));
    up.push_back(axes.row(1).dot(point));
  }
  const PlotArea area =
      equal_aspect(rect, padded(range_of(right), 0.02, 2.0), padded(range_of(up), 0.02, 2.0));
  return {.axes = axes,
          .center = {area.x.center(), area.y.center()},
          .pixels_per_metre = rect.width / area.x.width(),
          .width = static_cast<int>(rect.width),
          .height = static_cast<int>(rect.height)};
}

/// The steepest view that shows the map as large as the flattest one does.
ParallelView oblique_view(const Rect& rect, const DrawnRun& run) {
  const std::vector<Eigen::Vector3d> sample = sample_in_view(run);
  const double heading = long_side(sample) + kTurn;
  ParallelView best = fitted_view(rect, sample, oblique_axes(heading, 30.0 * kDegree));
  for (const double elevation : {34.0, 38.0, 42.0}) {
    const ParallelView view = fitted_view(rect, sample, oblique_axes(heading, elevation * kDegree));
    if (view.pixels_per_metre >= 0.98 * best.pixels_per_metre) best = view;
  }
  return best;
}

std::vector<Pixel> to_pixels(const Trajectory& trajectory, const ParallelView& view,
                             const Rect& rect) {
  std::vector<Pixel> pixels;
  pixels.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) {
    pixels.push_back(view.project(stamped.pose.translation) + Pixel(rect.x, rect.y));
  }
  return pixels;
}

void draw_scale_bar(Canvas& canvas, const Rect& rect, const ParallelView& view) {
  const double metres = round_step(0.25 * rect.width / view.pixels_per_metre);
  const double pixels = metres * view.pixels_per_metre;
  const Pixel left(rect.x + 8.0, rect.bottom() - 12.0);
  const std::array<Pixel, 4> bar = {left + Pixel(0.0, -8.0), left, left + Pixel(pixels, 0.0),
                                    left + Pixel(pixels, -8.0)};
  canvas.line(bar, {{0.13, 0.15, 0.19}, 2.5});
  canvas.text(tick_label(metres, metres) + " m", left + Pixel(0.5 * pixels, -12.0),
              {.size = 20.0, .anchor = Anchor::center});
}

void draw_color_bar(Canvas& canvas, const Rect& rect, const Range& heights) {
  constexpr int kSteps = 256;
  Raster gradient{1, kSteps, {}};
  for (int i = 0; i < kSteps; ++i) {
    const Color color = viridis(1.0 - (i + 0.5) / kSteps);
    const auto byte = [](double value) {
      return static_cast<std::uint32_t>(std::lround(255.0 * value));
    };
    gradient.argb.push_back(0xFF000000U | byte(color.red) << 16 | byte(color.green) << 8 |
                            byte(color.blue));
  }
  canvas.image(gradient, rect);
  const PlotArea area{rect, {0.0, 1.0}, heights};
  const Ticks ticks = nice_ticks(heights, 5);
  for (const double value : ticks.values) {
    const Pixel at = area.at(1.0, value);
    const std::array<Pixel, 2> mark = {at, at + Pixel(6.0, 0.0)};
    canvas.line(mark, {{0.45, 0.48, 0.53}, 1.5});
    canvas.text(tick_label(value, ticks.step), at + Pixel(12.0, 7.0), {.size = 19.0});
  }
  canvas.text("z [m]", {rect.right() + 8.0, rect.y - 14.0},
              {.size = 20.0, .anchor = Anchor::right});
}

}  // namespace

void draw_map_panel(Canvas& canvas, const Rect& rect, const DrawnRun& run) {
  constexpr double kBarSpace = 90.0;
  const Rect scene{rect.x, rect.y, rect.width - kBarSpace, rect.height};
  const ParallelView view = oblique_view(scene, run);
  canvas.image(draw_points(run.map_points, view, run.heights), scene);
  canvas.clip(scene);
  draw_path(canvas, to_pixels(run.path, view, scene), to_pixels(run.reference, view, scene), run);
  canvas.unclip();
  draw_scale_bar(canvas, scene, view);
  if (run.map_points.empty()) return;
  draw_color_bar(canvas,
                 {rect.right() - 62.0, rect.y + 0.22 * rect.height, 20.0, 0.56 * rect.height},
                 run.heights);
}

}  // namespace surefoot::report
