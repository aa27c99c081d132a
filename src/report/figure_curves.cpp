// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/figure_curves.hpp"

#include <algorithm>

#include "report/panels.hpp"

namespace surefoot::report {

namespace {

constexpr double kSmallestExtent = 1.0;  // [m] a shorter path is not blown up beyond this
constexpr double kSmallestHeight = 0.1;  // [m]
constexpr double kLeastStep = 0.4;       // [px] between two points that are drawn
constexpr double kFarOff = 0.5;          // of the reference's extent: estimates beyond are cut

const Stroke kReference{{0.0, 0.0, 0.0}, 2.5, LineStyle::dashed};
const Stroke kMarkerEdge{{0.1, 0.1, 0.12}, 1.5};

/// After Okabe and Ito (2008), without black, which is the reference's.
constexpr std::array<Color, 6> kColors = {{{0.0, 0.447, 0.698},
                                           {0.835, 0.369, 0.0},
                                           {0.0, 0.620, 0.451},
                                           {0.8, 0.475, 0.655},
                                           {0.902, 0.624, 0.0},
                                           {0.337, 0.706, 0.914}}};
constexpr std::array<LineStyle, 4> kStyles = {LineStyle::solid, LineStyle::dash_dotted,
                                              LineStyle::long_dashed, LineStyle::dotted};

std::vector<Eigen::Vector3d> drawable_points(const Trajectory& trajectory) {
  std::vector<Eigen::Vector3d> points;
  for (const StampedPose& stamped : trajectory) {
    if (is_drawable(stamped.pose.translation)) points.push_back(stamped.pose.translation);
  }
  return points;
}

/// Of poses, the numbers of the points that they, or the next that can be drawn, become.
std::vector<std::size_t> drawable_begins(const Trajectory& trajectory,
                                         const std::vector<std::size_t>& begins) {
  std::vector<std::size_t> result;
  std::size_t point = 0, next = 0;
  for (std::size_t i = 0; i < trajectory.size() && next < begins.size(); ++i) {
    for (; next < begins.size() && begins[next] == i; ++next) result.push_back(point);
    if (is_drawable(trajectory[i].pose.translation)) ++point;
  }
  return result;
}

std::vector<double> coordinates(const std::vector<Eigen::Vector3d>& points, int axis) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
  return values;
}

/// All of the reference, and of the estimates that may widen the axes what is not far off.
Range shown_range(const Curves& curves, const std::vector<bool>& cut, int axis, double far_off) {
  std::vector<double> values = coordinates(curves.reference, axis);
  const Range own = range_of(values);
  const bool any = !values.empty();
  for (std::size_t i = 0; i < curves.estimates.size(); ++i) {
    if (any && !cut.empty() && cut[i]) continue;
    for (const double value : coordinates(curves.estimates[i], axis)) {
      values.push_back(any ? std::clamp(value, own.low - far_off, own.high + far_off) : value);
    }
  }
  return padded(range_of(values), 0.07, axis == 2 ? kSmallestHeight : kSmallestExtent);
}

bool is_within(const Eigen::Vector3d& point, const std::array<Range, 3>& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const Range& range = box[static_cast<std::size_t>(axis)];
    if (point[axis] < range.low || point[axis] > range.high) return false;
  }
  return true;
}

/// The part of a segment within the rectangle (Liang and Barsky 1984); false if there is none.
bool clip_segment(const Rect& rect, Pixel& from, Pixel& to) {
  const Pixel step = to - from;
  const std::array<std::array<double, 2>, 4> sides = {{{-step.x(), from.x() - rect.x},
                                                       {step.x(), rect.right() - from.x()},
                                                       {-step.y(), from.y() - rect.y},
                                                       {step.y(), rect.bottom() - from.y()}}};
  double enter = 0.0, leave = 1.0;
  for (const auto& [slope, room] : sides) {
    if (slope == 0.0 && room < 0.0) return false;
    if (slope < 0.0) enter = std::max(enter, room / slope);
    if (slope > 0.0) leave = std::min(leave, room / slope);
  }
  if (enter > leave) return false;
  const Pixel begin = from;
  from = begin + enter * step;
  to = begin + leave * step;
  return true;
}

}  // namespace

Curves curves_of(const FigurePanel& panel) {
  Curves curves{drawable_points(panel.reference), {}, {}, {}};
  for (std::size_t i = 0; i < panel.estimates.size(); ++i) {
    const Trajectory& estimate = panel.estimates[i];
    curves.estimates.push_back(drawable_points(estimate));
    curves.begins.push_back(panel.begins.empty() ? std::vector<std::size_t>{}
                                                 : drawable_begins(estimate, panel.begins[i]));
  }
  double extent = kSmallestExtent;
  for (const int axis : {0, 1}) {
    extent = std::max(extent, range_of(coordinates(curves.reference, axis)).width());
  }
  for (const int axis : {0, 1, 2}) {
    curves.ranges[static_cast<std::size_t>(axis)] =
        shown_range(curves, panel.cut, axis, kFarOff * extent);
  }
  return curves;
}

Stroke reference_stroke() { return kReference; }

Stroke stroke_of(std::size_t name) {
  return {kColors[name % kColors.size()], 2.2, kStyles[name % kStyles.size()]};
}

void draw_curve(Canvas& canvas, const std::vector<Eigen::Vector3d>& points, const Projection& at,
                const Stroke& stroke, const Border& border,
                const std::vector<std::size_t>& begins) {
  std::vector<Pixel> line;
  const auto finish = [&] {
    if (line.size() > 1) canvas.line(line, stroke);
    line.clear();
  };
  std::size_t last = 0;  // point that the line has reached
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (std::binary_search(begins.begin(), begins.end(), i)) {
      finish();
      last = i;
      continue;
    }
    Pixel from = at(points[last]), to = at(points[i]);
    if ((to - from).norm() < kLeastStep && i + 1 < points.size()) continue;
    const Pixel end = to;
    const bool shown =
        border.rect ? clip_segment(*border.rect, from, to)
                    : is_within(points[last], *border.box) && is_within(points[i], *border.box);
    if (!shown || from != at(points[last])) finish();
    if (shown && line.empty()) line.push_back(from);
    if (shown) line.push_back(to);
    if (shown && to != end) finish();
    last = i;
  }
  finish();
}

void draw_curves(Canvas& canvas, const Curves& curves, const Projection& at, const Border& border) {
  for (std::size_t i = curves.estimates.size(); i-- > 0;) {  // the first one on top
    draw_curve(canvas, curves.estimates[i], at, stroke_of(i), border, curves.begins[i]);
  }
  draw_curve(canvas, curves.reference, at, kReference, border);
  if (curves.reference.empty()) return;
  draw_start(canvas, at(curves.reference.front()));
  draw_end(canvas, at(curves.reference.back()));
}

void draw_start(Canvas& canvas, const Pixel& at) {
  canvas.circle(at, 8.0, style::kStart, kMarkerEdge);
}

void draw_end(Canvas& canvas, const Pixel& at) {
  canvas.triangle(at, 11.0, style::kEnd, kMarkerEdge);
}

}  // namespace surefoot::report
