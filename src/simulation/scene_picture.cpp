// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scene_picture.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::simulation {

namespace {

constexpr std::uint32_t kRoute = 0xffe8432e;
constexpr double kDotStep = 6.0;  // between the dots of the route [pixels]

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

void draw_route(const Scene& scene, const SceneView& view, SceneImage& image) {
  for (std::size_t i = 0; i < scene.route.size(); ++i) {
    const Eigen::Vector3d& from = scene.route[i];
    const Eigen::Vector3d& to = scene.route[(i + 1) % scene.route.size()];
    const int dots =
        std::max(1, static_cast<int>((view.pixel(to) - view.pixel(from)).norm() / kDotStep));
    for (int k = 0; k < dots; ++k) {
      const Eigen::Vector3d point = from + (to - from) * (static_cast<double>(k) / dots);
      draw_dot(image, view.pixel(point + Eigen::Vector3d(0.0, 0.0, 0.1)), k % 2 == 0 ? 2.0 : 1.4);
    }
  }
}

}  // namespace

SceneImage render_view(const SceneView& view, const RayCaster& rays) {
  SceneImage image{view.width(), view.height(), {}};
  image.argb.reserve(static_cast<std::size_t>(view.width()) *
                     static_cast<std::size_t>(view.height()));
  std::vector<Ray> row(static_cast<std::size_t>(view.width()));
  std::vector<Hit> hits(row.size());
  for (int y = 0; y < view.height(); ++y) {
    for (int x = 0; x < view.width(); ++x) {
      row[static_cast<std::size_t>(x)] = view.ray(x + 0.5, y + 0.5);
    }
    rays.cast(row, SceneView::reach(), hits);
    for (const Hit& hit : hits) image.argb.push_back(hit.valid() ? shade(hit) : kSky);
  }
  return image;
}

SceneImage render_scene(const Scene& scene, const RayCaster& rays, int width) {
  const SceneView view(scene, width);
  SceneImage image = render_view(view, rays);
  draw_route(scene, view, image);
  return image;
}

}  // namespace surefoot::simulation
