// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/robot_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::recordings {

namespace {

using report::Canvas;
using report::Color;
using report::Pixel;

constexpr Color kShell{0.86, 0.88, 0.91};
constexpr Color kSensor{0.33, 0.38, 0.47};
constexpr Color kNearLeg{0.72, 0.75, 0.80};
constexpr Color kFarLeg{0.42, 0.46, 0.53};
constexpr Color kEdge{0.05, 0.07, 0.10};

/// Corners of a prism's foot, counter-clockwise seen from above, in its own frame.
using Outline = std::vector<Eigen::Vector2d>;

Outline rectangle(double x_low, double x_high, double half_width) {
  return {{x_low, -half_width}, {x_high, -half_width}, {x_high, half_width}, {x_low, half_width}};
}

Outline circle(double radius) {
  constexpr int kCorners = 20;
  Outline outline;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// Faces turned to the viewer are drawn counter-clockwise: y points down on the page.
bool faces_viewer(const std::vector<Pixel>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Pixel& a = corners[i];
    const Pixel& b = corners[(i + 1) % corners.size()];
    area += a.x() * b.y() - b.x() * a.y();
  }
  return area < 0.0;
}

Color shaded(const Color& color, double light) {
  return {color.red * light, color.green * light, color.blue * light};
}

void draw_face(Canvas& canvas, const std::vector<Pixel>& corners, const Color& color, double edge) {
  if (faces_viewer(corners)) canvas.polygon(corners, color, {kEdge.with_alpha(0.5), edge});
}

void draw_prism(Canvas& canvas, const Projection& pixel, const Pose& T_map_prism,
                const Outline& outline, double low, double high, const Color& color, double edge) {
  const auto at = [&](const Eigen::Vector2d& corner, double z) {
    return pixel(T_map_prism * Eigen::Vector3d(corner.x(), corner.y(), z));
  };
  std::vector<Pixel> top;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    const Eigen::Vector2d side = (b - a).normalized();
    const double light = 0.62 + 0.12 * side.x();
    draw_face(canvas, {at(a, low), at(b, low), at(b, high), at(a, high)}, shaded(color, light),
              0.0);
    top.push_back(at(a, high));
  }
  draw_face(canvas, top, color, edge);
}

void draw_leg(Canvas& canvas, const Projection& pixel, const simulation::Leg& leg,
              const Color& color, double width) {
  const std::array<Pixel, 3> joints = {pixel(leg.hip), pixel(leg.knee), pixel(leg.foot)};
  canvas.line(joints, {kEdge, width + 1.2});
  canvas.line(joints, {color, width});
  canvas.circle(joints[2], 0.62 * width, color, {kEdge, 0.6});
}

}  // namespace

void draw_robot(Canvas& canvas, const Projection& pixel, const Pose& T_map_body,
                const Pose& T_body_lidar, const std::vector<simulation::Leg>& legs, double metre) {
  const double edge = std::min(1.0, 0.008 * metre);
  const double leg_width = std::max(1.6, 0.035 * metre);
  const Pixel left = pixel(T_map_body * Eigen::Vector3d(0.0, 0.1, 0.0));
  const Pixel right = pixel(T_map_body * Eigen::Vector3d(0.0, -0.1, 0.0));
  // Of the two sides the lower one on the page is the nearer.
  const bool left_is_near = left.y() > right.y();
  const auto draw_legs = [&](bool near, const Color& color) {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const bool is_left = i == 0 || i == 3;
      if ((is_left == left_is_near) == near) draw_leg(canvas, pixel, legs[i], color, leg_width);
    }
  };
  draw_legs(false, kFarLeg);
  if (!legs.empty()) {
    draw_prism(canvas, pixel, T_map_body, rectangle(-0.25, 0.22, 0.085), -0.05, 0.065, kShell,
               edge);
    draw_prism(canvas, pixel, T_map_body, rectangle(0.22, 0.33, 0.055), -0.03, 0.06, kShell, edge);
  }
  draw_legs(true, kNearLeg);
  // A mast from the trunk's back to the sensor, and the sensor: 103 mm wide, 72 mm high.
  const Pose T_map_lidar = T_map_body * T_body_lidar;
  if (!legs.empty() && T_body_lidar.translation.z() > 0.1) {
    const std::array<Pixel, 2> mast = {
        pixel(T_map_body *
              Eigen::Vector3d(T_body_lidar.translation.x(), T_body_lidar.translation.y(), 0.065)),
        pixel(T_map_lidar.translation)};
    canvas.line(mast, {kFarLeg, leg_width});
  }
  draw_prism(canvas, pixel, T_map_lidar, circle(0.052), -0.036, 0.036, kSensor, edge);
}

}  // namespace surefoot::recordings
