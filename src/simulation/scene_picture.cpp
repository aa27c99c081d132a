// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scene_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace surefoot::simulation {

namespace {

constexpr double kAzimuth = -65.0 * std::numbers::pi / 180.0;  // where the viewer stands
constexpr double kElevation = 52.0 * std::numbers::pi / 180.0;
constexpr double kFar = 400.0;  // where the rays start [m]
constexpr std::uint32_t kSky = 0xffeef2f5;
constexpr std::uint32_t kRoute = 0xffe8432e;

/// An orthographic view: pixels to rays, points to pixels.
struct View {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
  Eigen::Vector3d forward;
  Eigen::Vector2d low;  ///< of the picture's plane [m]
  double scale = 1.0;   ///< pixels a metre
  int width = 0;
  int height = 0;

  [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& point) const {
    return {scale * (right.dot(point) - low.x()),
            static_cast<double>(height) - scale * (up.dot(point) - low.y())};
  }
  [[nodiscard]] Eigen::Vector3d point(double x, double y) const {
    return (low.x() + x / scale) * right +
           (low.y() + (static_cast<double>(height) - y) / scale) * up;
  }
};

View make_view(const Scene& scene, int width) {
  View view;
  view.width = width;
  view.forward = -Eigen::Vector3d(std::cos(kElevation) * std::cos(kAzimuth),
                                  std::cos(kElevation) * std::sin(kAzimuth), std::sin(kElevation));
  view.right = view.forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  view.up = view.right.cross(view.forward);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector3d& corner : scene.route) {
    const Eigen::Vector2d seen(view.right.dot(corner), view.up.dot(corner));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  const double margin = scene.view_margin;
  low.array() -= margin;
  high.array() += margin;
  view.low = low;
  view.scale = width / (high.x() - low.x());
  view.height = std::max(16, static_cast<int>(std::lround(view.scale * (high.y() - low.y()))));
  return view;
}

std::uint32_t shade(const Hit& hit) {
  // Few steps of light keep the files small.
  constexpr double kSteps = 10.0;
  const double facing = std::round(kSteps * static_cast<double>(hit.cos_incidence)) / kSteps;
  const double light = 0.55 + 0.6 * facing;
  const std::uint32_t base = color(hit.material);
  std::uint32_t result = 0xff;
  for (const int shift : {16, 8, 0}) {
    const double channel = static_cast<double>((base >> shift) & 0xffU) * light;
    result = (result << 8) | static_cast<std::uint32_t>(std::clamp(channel, 0.0, 255.0));
  }
  return result;
}

void draw_dot(SceneImage& image, const Eigen::Vector2d& at, double radius) {
  for (int y = static_cast<int>(at.y() - radius); y <= static_cast<int>(at.y() + radius); ++y) {
    for (int x = static_cast<int>(at.x() - radius); x <= static_cast<int>(at.x() + radius); ++x) {
      const bool inside = x >= 0 && y >= 0 && x < image.width && y < image.height &&
                          (Eigen::Vector2d(x + 0.5, y + 0.5) - at).norm() <= radius;
      if (inside) image.argb[static_cast<std::size_t>(y * image.width + x)] = kRoute;
    }
  }
}

void draw_route(const Scene& scene, const View& view, SceneImage& image) {
  for (std::size_t i = 0; i < scene.route.size(); ++i) {
    const Eigen::Vector3d& from = scene.route[i];
    const Eigen::Vector3d& to = scene.route[(i + 1) % scene.route.size()];
    const int dots = std::max(1, static_cast<int>((to - from).norm() * view.scale / 7.0));
    for (int k = 0; k < dots; ++k) {
      const Eigen::Vector3d point = from + (to - from) * (static_cast<double>(k) / dots);
      draw_dot(image, view.pixel(point + Eigen::Vector3d(0.0, 0.0, 0.1)), k % 2 == 0 ? 2.0 : 1.4);
    }
  }
}

}  // namespace

SceneImage render_scene(const Scene& scene, const RayCaster& rays, int width) {
  const View view = make_view(scene, width);
  SceneImage image{view.width, view.height, {}};
  const auto pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  image.argb.reserve(pixels);
  std::vector<Ray> row(static_cast<std::size_t>(view.width));
  std::vector<Hit> hits(row.size());
  const Eigen::Vector3f direction = view.forward.cast<float>();
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      Eigen::Vector3d origin = view.point(x + 0.5, y + 0.5) - kFar * view.forward;
      // What is above the ceiling, or before the front, is passed by starting behind it.
      const double above = (origin.z() - scene.view_ceiling) / -view.forward.z();
      const double before = (scene.view_front - origin.y()) / view.forward.y();
      origin += std::max({0.0, above, before}) * view.forward;
      row[static_cast<std::size_t>(x)] = {origin.cast<float>(), direction, 0.0F};
    }
    rays.cast(row, static_cast<float>(2.0 * kFar), hits);
    for (const Hit& hit : hits) image.argb.push_back(hit.valid() ? shade(hit) : kSky);
  }
  draw_route(scene, view, image);
  return image;
}

}  // namespace surefoot::simulation
