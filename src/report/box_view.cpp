// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/box_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace surefoot::report {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAzimuth = -60.0 * kDegree;   // of the viewer about z, from x
constexpr double kElevation = 25.0 * kDegree;  // of the viewer above the floor
constexpr double kLeastWidth = 0.5;            // of the shorter of x and y, by the longer
constexpr double kHeight = 0.45;               // of the box, by the longer of x and y
constexpr double kLeftMargin = 124.0;          // [px] for z's numbers, of six characters, and label
constexpr double kRightMargin = 96.0;          // [px] for y's, which lie below the edge, too
constexpr double kTopMargin = 8.0;             // [px]
constexpr double kBottomMargin = 66.0;         // [px]
constexpr double kNumberOffset = 22.0;         // [px] from an edge
constexpr double kLabelOffset = 58.0;          // [px] from an edge
constexpr double kLabelGap = 18.0;             // [px] of a label that stands beside the numbers

const Color kFace{0.975, 0.977, 0.982};

/// A corner of the box: for each axis its low (0) or high (1) end.
Eigen::Vector3d corner(const BoxView& view, int x, int y, int z) {
  const std::array<int, 3> ends = {x, y, z};
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis) {
    const Range& range = view.range(axis);
    point[axis] = ends[static_cast<std::size_t>(axis)] == 0 ? range.low : range.high;
  }
  return point;
}

/// As many as have room along the edge as it is seen: a number is a line high, those beside a flat
/// edge stand on each other.
Ticks ticks_of(const BoxView& view, int axis) {
  constexpr double kLeastApart = 26.0;  // [px] of the page, in height
  constexpr double kLeastBeside = 70.0;
  Eigen::Vector3d end = corner(view, 0, 0, 0);
  const Pixel from = view.at(end);
  end[axis] = view.range(axis).high;
  const Pixel edge = (view.at(end) - from).cwiseAbs();
  const double room = std::max(edge.y() / kLeastApart, axis == 1 ? 0.0 : edge.x() / kLeastBeside);
  return nice_ticks(view.range(axis), std::clamp(static_cast<int>(room), 2, axis == 2 ? 4 : 5));
}

void draw_segment(Canvas& canvas, const BoxView& view, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to, const Stroke& stroke) {
  const std::array<Pixel, 2> ends = {view.at(from), view.at(to)};
  canvas.line(ends, stroke);
}

/// Grid lines at the ticks of `axis`, along `along`, on the face where `fixed` is at `end`.
void draw_face_lines(Canvas& canvas, const BoxView& view, int axis, int along, int fixed, int end) {
  for (const double value : ticks_of(view, axis).values) {
    Eigen::Vector3d from, to;
    from[axis] = to[axis] = value;
    from[fixed] = to[fixed] = end == 0 ? view.range(fixed).low : view.range(fixed).high;
    from[along] = view.range(along).low;
    to[along] = view.range(along).high;
    draw_segment(canvas, view, from, to, kGrid);
  }
}

void draw_faces(Canvas& canvas, const BoxView& view) {
  using Face = std::array<Eigen::Vector3d, 4>;
  const auto c = [&](int x, int y, int z) { return corner(view, x, y, z); };
  const std::array<Face, 3> faces = {Face{c(0, 0, 0), c(1, 0, 0), c(1, 1, 0), c(0, 1, 0)},
                                     Face{c(0, 0, 0), c(0, 1, 0), c(0, 1, 1), c(0, 0, 1)},
                                     Face{c(0, 1, 0), c(1, 1, 0), c(1, 1, 1), c(0, 1, 1)}};
  for (const Face& face : faces) {
    std::array<Pixel, 4> pixels;
    std::transform(face.begin(), face.end(), pixels.begin(),
                   [&](const Eigen::Vector3d& point) { return view.at(point); });
    canvas.polygon(pixels, kFace, kGrid);
  }
  constexpr std::array<std::array<int, 4>, 6> kLines = {
      {{0, 1, 2, 0}, {1, 0, 2, 0}, {1, 2, 0, 0}, {2, 1, 0, 0}, {0, 2, 1, 1}, {2, 0, 1, 1}}};
  for (const auto& [axis, along, fixed, end] : kLines) {
    draw_face_lines(canvas, view, axis, along, fixed, end);
  }
}

/// Edge, numbers and label of an axis; these lie on the side of the edge that `outward` points to.
void draw_axis(Canvas& canvas, const BoxView& view, int axis, const Eigen::Vector3d& from,
               const Pixel& outward, Anchor anchor) {
  static constexpr std::array<const char*, 3> kLabels = {"x [m]", "y [m]", "z [m]"};
  Eigen::Vector3d to = from;
  to[axis] = view.range(axis).high;
  draw_segment(canvas, view, from, to, kFrame);
  const Pixel down(0.0, 7.0);  // from a text's middle to its base line
  const Ticks ticks = ticks_of(view, axis);
  const TextStyle style{.size = 19.0, .anchor = anchor};
  double widest = 0.0;
  for (const double value : ticks.values) {
    Eigen::Vector3d point = from;
    point[axis] = value;
    const std::array<Pixel, 2> tick = {view.at(point), view.at(point) + 6.0 * outward};
    canvas.line(tick, kFrame);
    const std::string number = tick_label(value, ticks.step);
    canvas.text(number, view.at(point) + kNumberOffset * outward + down, style);
    widest = std::max(widest, canvas.text_width(number, style));
  }
  // Numbers beside an edge are cleared to the side, those below it downwards. Beside a slanted edge
  // the next number reaches farther out than the one at the middle.
  const double clear = widest + kLabelGap;
  const Pixel offset = anchor == Anchor::center ? Pixel(kLabelOffset * outward)
                       : anchor == Anchor::left
                           ? Pixel(kNumberOffset * outward + Pixel(clear + kLabelGap, 0.0))
                           : Pixel((kNumberOffset + clear) * outward);
  canvas.text(kLabels[static_cast<std::size_t>(axis)], view.at(0.5 * (from + to)) + offset + down,
              {.size = 21.0,
               .anchor = anchor == Anchor::left ? Anchor::left : Anchor::center,
               .upward = axis == 2});
}

}  // namespace

BoxView::BoxView(const Rect& rect, const std::array<Range, 3>& ranges) : ranges_(ranges) {
  const double longest = std::max(ranges[0].width(), ranges[1].width());
  const auto edge = [&](const Range& range) {
    return std::max(range.width() / longest, kLeastWidth);
  };
  scale_ = {edge(ranges[0]) / ranges[0].width(), edge(ranges[1]) / ranges[1].width(),
            kHeight / ranges[2].width()};
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d high = -low;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d point = project(corner(*this, i & 1, (i >> 1) & 1, i >> 2));
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Rect inner{rect.x + kLeftMargin, rect.y + kTopMargin,
                   rect.width - kLeftMargin - kRightMargin,
                   rect.height - kTopMargin - kBottomMargin};
  zoom_ = std::min(inner.width / (high - low).x(), inner.height / (high - low).y());
  const Eigen::Vector2d middle = 0.5 * (low + high);
  offset_ = inner.center() - zoom_ * Pixel(middle.x(), -middle.y());
}

Eigen::Vector2d BoxView::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d low(ranges_[0].low, ranges_[1].low, ranges_[2].low);
  const Eigen::Vector3d p = scale_.cwiseProduct(point - low);
  const double along = p.x() * std::cos(kAzimuth) + p.y() * std::sin(kAzimuth);
  const double across = -p.x() * std::sin(kAzimuth) + p.y() * std::cos(kAzimuth);
  return {across, p.z() * std::cos(kElevation) - along * std::sin(kElevation)};
}

Pixel BoxView::at(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d projected = project(point);
  return offset_ + zoom_ * Pixel(projected.x(), -projected.y());
}

void draw_box(Canvas& canvas, const BoxView& view) {
  draw_faces(canvas, view);
  // Away from the box, at a right angle to each edge as it is seen.
  const auto outward = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Pixel edge = (view.at(to) - view.at(from)).normalized();
    const Pixel side(-edge.y(), edge.x());
    return Pixel(side.y() < 0.0 ? -side : side);
  };
  const Eigen::Vector3d front = corner(view, 0, 0, 0), right = corner(view, 1, 0, 0);
  draw_axis(canvas, view, 0, front, outward(front, right), Anchor::center);
  draw_axis(canvas, view, 1, right, outward(right, corner(view, 1, 1, 0)), Anchor::left);
  draw_axis(canvas, view, 2, front, Pixel(-1.0, 0.0), Anchor::right);
}

}  // namespace surefoot::report
