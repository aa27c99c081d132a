// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scene_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace surefoot::simulation {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAzimuth = -65.0 * kDegree;  // where the viewer stands
constexpr double kOverviewElevation = 52.0 * kDegree;
constexpr double kCloseElevation = 42.0 * kDegree;
constexpr double kFar = 400.0;  // where the rays start [m]
constexpr int kLeastHeight = 16;

}  // namespace

SceneView::SceneView(const Scene& scene, double azimuth, double elevation)
    : forward_(-Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation))),
      ceiling_(scene.view_ceiling),
      front_(scene.view_front) {
  right_ = forward_.cross(Eigen::Vector3d::UnitZ()).normalized();
  up_ = right_.cross(forward_);
}

SceneView::SceneView(const Scene& scene, int width)
    : SceneView(scene, kAzimuth, kOverviewElevation) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector3d& corner : scene.route) {
    const Eigen::Vector2d seen(right_.dot(corner), up_.dot(corner));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  low_ = low.array() - scene.view_margin;
  high.array() += scene.view_margin;
  width_ = width;
  scale_ = width / (high.x() - low_.x());
  height_ = std::max(kLeastHeight, static_cast<int>(std::lround(scale_ * (high.y() - low_.y()))));
}

SceneView::SceneView(const Scene& scene, const Eigen::Vector3d& center, double metres, int width,
                     int height)
    : SceneView(scene, kAzimuth, kCloseElevation) {
  width_ = width;
  height_ = height;
  scale_ = width / metres;
  low_ = Eigen::Vector2d(right_.dot(center) - 0.5 * metres,
                         up_.dot(center) - 0.5 * metres * height / width);
}

Eigen::Vector2d SceneView::pixel(const Eigen::Vector3d& point) const {
  return {scale_ * (right_.dot(point) - low_.x()),
          static_cast<double>(height_) - scale_ * (up_.dot(point) - low_.y())};
}

Ray SceneView::ray(double x, double y) const {
  Eigen::Vector3d origin = (low_.x() + x / scale_) * right_ +
                           (low_.y() + (static_cast<double>(height_) - y) / scale_) * up_ -
                           kFar * forward_;
  const double above = (origin.z() - ceiling_) / -forward_.z();
  const double before = (front_ - origin.y()) / forward_.y();
  origin += std::max({0.0, above, before}) * forward_;
  return {origin.cast<float>(), forward_.cast<float>(), 0.0F};
}

float SceneView::reach() { return static_cast<float>(2.0 * kFar); }

std::vector<bool> SceneView::visible(const std::vector<Eigen::Vector3d>& points,
                                     const RayCaster& rays) const {
  constexpr float kTolerance = 0.2F;  // a point on a slanted surface is not hidden by it [m]
  std::vector<Ray> cast;
  cast.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector2d at = pixel(point);
    cast.push_back(ray(at.x(), at.y()));
  }
  std::vector<Hit> hits(cast.size());
  rays.cast(cast, reach(), hits);
  std::vector<bool> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float depth = (points[i].cast<float>() - cast[i].origin).dot(cast[i].direction);
    result[i] = depth > 0.0F && (!hits[i].valid() || depth < hits[i].distance + kTolerance);
  }
  return result;
}

}  // namespace surefoot::simulation
