// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "report/panels.hpp"
#include "report/point_raster.hpp"

namespace surefoot::report {

namespace {

constexpr double kShortestWay = 2.0;    // [m] a shorter path is not blown up beyond this
constexpr double kStay = 1.0;           // [m] a shorter one is that of somebody who stands,
constexpr double kSurroundings = 10.0;  // [m] of whom so much is seen from above
// A level floor must look level: its centimetres are not stretched to a hill.
constexpr double kLeastHeight = 1.0;  // [m]
const Stroke kAfterLoops{style::kLoop, 2.5, LineStyle::dashed};

std::vector<double> coordinates(const DrawnRun& run, int axis) {
  std::vector<double> values;
  for (const Trajectory* trajectory : {&run.path, &run.reference}) {
    for (const StampedPose& stamped : *trajectory) {
      values.push_back(stamped.pose.translation[axis]);
    }
  }
  return values;
}

std::vector<Pixel> seen_from_above(const Trajectory& trajectory, const PlotArea& area) {
  std::vector<Pixel> pixels;
  pixels.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) {
    pixels.push_back(area.at(stamped.pose.translation.x(), stamped.pose.translation.y()));
  }
  return pixels;
}

void draw_loops(Canvas& canvas, const DrawnLoops& loops, const PlotArea& area) {
  const auto join = [&](const std::vector<DrawnLoops::Places>& all, const Stroke& stroke) {
    for (const auto& [from, to] : all) {
      const std::array<Pixel, 2> ends = {area.at(from.x(), from.y()), area.at(to.x(), to.y())};
      canvas.line(ends, stroke);
    }
  };
  join(loops.refused, {style::kRefusedLoop, 1.5});
  if (!loops.taken.empty()) {
    canvas.line(seen_from_above(loops.corrected, area), kAfterLoops);
  }
  join(loops.taken, {style::kLoop, 3.0});
}

/// The way over ground up to each pose [m]: the path unrolled, whichever way it turns.
std::vector<double> distances_along(const DrawnRun& run) {
  std::vector<double> distances;
  distances.reserve(run.path.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < run.path.size(); ++i) {
    if (i > 0) distance += step_to(i, run).head<2>().norm();
    distances.push_back(distance);
  }
  return distances;
}

/// Where stretches of ascending stamps begin: first, and where a clock was set back; then the end.
std::vector<std::size_t> ascents_of(const Trajectory& trajectory) {
  std::vector<std::size_t> begins = {0};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    if (trajectory[i].stamp_ns < trajectory[i - 1].stamp_ns) begins.push_back(i);
  }
  begins.push_back(trajectory.size());
  return begins;
}

/// The reference, or the way after loops, is laid out by the path's distance at the same instant,
/// since a denser or less shaken trajectory has another length. What it has before and after the
/// path is left out. Where the clock was set back in both, stretch by stretch.
std::vector<Pixel> unrolled(const Trajectory& trajectory, const DrawnRun& run,
                            const std::vector<double>& distances, const PlotArea& area) {
  std::vector<Pixel> pixels;
  const std::vector<std::size_t> ascents = ascents_of(run.path);
  const std::vector<std::size_t> of_its_own = ascents_of(trajectory);
  const bool alike = ascents.size() == of_its_own.size();
  std::size_t first = 0, next = 0, end = run.path.size();
  for (std::size_t i = 0, ascent = 0; i < trajectory.size(); ++i) {
    const StampedPose& stamped = trajectory[i];
    if (alike && i == of_its_own[ascent]) {
      first = next = ascents[ascent];
      end = ascents[++ascent];
    }
    while (next < end && run.path[next].stamp_ns < stamped.stamp_ns) ++next;
    if (next == end) continue;
    const bool exact = run.path[next].stamp_ns == stamped.stamp_ns;
    if (next == first && !exact) continue;
    double distance = distances[next];
    if (!exact) {
      const auto before = static_cast<double>(run.path[next - 1].stamp_ns);
      const double share = (static_cast<double>(stamped.stamp_ns) - before) /
                           (static_cast<double>(run.path[next].stamp_ns) - before);
      distance = distances[next - 1] + share * (distances[next] - distances[next - 1]);
    }
    pixels.push_back(area.at(distance, stamped.pose.translation.z()));
  }
  return pixels;
}

/// The z range of the height panel: equal aspect if the path fills it, else exaggerated by a round
/// factor.
struct HeightRange {
  Range z;
  double exaggeration = 1.0;
};

HeightRange height_range(const Rect& rect, const Range& way, const Range& z) {
  const double equal_height = way.width() * rect.height / rect.width;
  const Range needed = padded(z, 0.12, kLeastHeight);
  double exaggeration = 1.0;
  const double possible = equal_height / needed.width();
  for (const double factor : {2.0, 5.0, 10.0, 20.0}) {
    if (factor <= possible) exaggeration = factor;
  }
  return {padded(needed, 0.0, equal_height / exaggeration), exaggeration};
}

/// One band for each stretch of untrusted poses; a single one reaches to its neighbours, of its
/// segment.
void draw_untrusted(Canvas& canvas, const std::vector<Pixel>& path, const DrawnRun& run) {
  const auto joined = [&](std::size_t i) { return run.segments[i - 1] == run.segments[i]; };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!run.untrusted[i]) continue;
    const std::size_t first = i > 0 && joined(i) ? i - 1 : i;
    while (i + 1 < path.size() && run.untrusted[i] && joined(i + 1)) ++i;
    canvas.line(std::span(path).subspan(first, i - first + 1),
                {style::kUntrusted, style::kBandWidth});
  }
}

/// The path unrolled: height over the way, so that a ramp is a ramp in whichever direction it
/// leads.
void draw_height_panel(Canvas& canvas, const Rect& rect, const DrawnRun& run) {
  const std::vector<double> distances = distances_along(run);
  const Range way = padded(range_of(distances), 0.03, kShortestWay);
  const HeightRange range = height_range(rect, way, range_of(coordinates(run, 2)));
  const PlotArea area{rect, way, range.z};
  const AxisLabels labels{.x = "way [m]", .y = "z [m]", .y_ticks = 5};
  std::vector<Pixel> path;
  for (std::size_t i = 0; i < run.path.size(); ++i) {
    path.push_back(area.at(distances[i], run.path[i].pose.translation.z()));
  }
  draw_grid(canvas, area, labels);
  canvas.clip(rect);
  draw_path(canvas, path, unrolled(run.reference, run, distances, area), run);
  if (!run.loops.taken.empty()) {
    canvas.line(unrolled(run.loops.corrected, run, distances, area), kAfterLoops);
  }
  canvas.unclip();
  draw_axes(canvas, area, labels);
  const std::string scale =
      range.exaggeration > 1.0
          ? ", height \u00d7" + std::to_string(static_cast<int>(range.exaggeration))
          : "";
  draw_heading(canvas, rect, "Height along the way" + scale);
}

}  // namespace

Eigen::Vector3d step_to(std::size_t i, const DrawnRun& run) {
  if (run.segments[i] != run.segments[i - 1]) return Eigen::Vector3d::Zero();
  return run.path[i].pose.translation - run.path[i - 1].pose.translation;
}

void draw_segments(Canvas& canvas, const std::vector<Pixel>& path, const std::vector<int>& segments,
                   const Stroke& stroke) {
  for (std::size_t first = 0, i = 1; i <= path.size(); ++i) {
    if (i < path.size() && segments[i] == segments[first]) continue;
    if (i == first + 1) {
      canvas.circle(path[first], 0.5 * stroke.width, stroke.color, stroke);
    } else {
      canvas.line(std::span(path).subspan(first, i - first), stroke);
    }
    first = i;
  }
}

void draw_path(Canvas& canvas, const std::vector<Pixel>& path, const std::vector<Pixel>& reference,
               const DrawnRun& run) {
  draw_untrusted(canvas, path, run);
  draw_segments(canvas, path, run.segments, {style::kHalo, 9.0});
  canvas.line(reference, {style::kReference, style::kReferenceWidth});
  draw_segments(canvas, path, run.segments, {style::kPath, 3.5});
  if (path.empty()) return;
  const Stroke edge{{0.1, 0.1, 0.12}, 2.0};
  canvas.circle(path.front(), style::kMarkerRadius, style::kStart, edge);
  canvas.triangle(path.back(), 1.35 * style::kMarkerRadius, style::kEnd, edge);
}

void draw_path_panels(Canvas& canvas, const Rect& top, const Rect& side, const DrawnRun& run) {
  const Range x = range_of(coordinates(run, 0)), y = range_of(coordinates(run, 1));
  const bool stands = std::max(x.width(), y.width()) < kStay;
  const double least = stands ? kSurroundings : kShortestWay;
  const PlotArea area = equal_aspect(top, padded(x, 0.12, least), padded(y, 0.12, least));
  const AxisLabels labels{.x = "x [m]", .y = "y [m]"};
  draw_grid(canvas, area, labels);
  canvas.clip(top);
  canvas.image(draw_points(run.map_points, top_view(area), run.heights), top, 0.4);
  draw_path(canvas, seen_from_above(run.path, area), seen_from_above(run.reference, area), run);
  draw_loops(canvas, run.loops, area);
  canvas.unclip();
  draw_axes(canvas, area, labels);
  draw_heading(canvas, top, "From above");
  draw_height_panel(canvas, side, run);
}

}  // namespace surefoot::report
