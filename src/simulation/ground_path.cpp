// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/ground_path.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace surefoot::simulation {

namespace {

constexpr double kSpacing = 0.05;      // of samples along the way [m]
constexpr double kHeadingBlur = 0.15;  // [m]
constexpr double kProbeAbove = 1.0;    // the ground is looked for from here downwards [m]
constexpr double kProbeDepth = 3.0;

/// Points of a closed polyline every `spacing` metres, the last one not repeating the first.
std::vector<Eigen::Vector3d> resample_closed(const std::vector<Eigen::Vector3d>& corners,
                                             double spacing) {
  double total = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    total += (corners[(i + 1) % corners.size()] - corners[i]).norm();
  }
  const auto count = static_cast<std::size_t>(std::max(8.0, std::round(total / spacing)));
  const double step = total / static_cast<double>(count);
  std::vector<Eigen::Vector3d> samples;
  samples.reserve(count);
  std::size_t edge = 0;
  double edge_start = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = step * static_cast<double>(i);
    double edge_length = (corners[(edge + 1) % corners.size()] - corners[edge]).norm();
    while (wanted - edge_start > edge_length && edge + 1 < corners.size()) {
      edge_start += edge_length;
      ++edge;
      edge_length = (corners[(edge + 1) % corners.size()] - corners[edge]).norm();
    }
    const double part = edge_length > 0.0 ? (wanted - edge_start) / edge_length : 0.0;
    samples.push_back(corners[edge] +
                      part * (corners[(edge + 1) % corners.size()] - corners[edge]));
  }
  return samples;
}

/// Gaussian smoothing of a closed sequence.
template <typename Value>
std::vector<Value> blur_closed(const std::vector<Value>& values, double sigma_samples) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * sigma_samples));
  std::vector<Value> result(values.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    Value sum = Value(values[0] * 0.0);
    double weights = 0.0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const double x = static_cast<double>(k) / std::max(sigma_samples, 1e-9);
      const double weight = std::exp(-0.5 * x * x);
      sum =
          Value(sum + weight * values[static_cast<std::size_t>(((i + k) % count + count) % count)]);
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = Value(sum / weights);
  }
  return result;
}

double ground_height(const RayCaster& rays, const Eigen::Vector3d& near) {
  const auto height = rays.ground_below(near + Eigen::Vector3d(0.0, 0.0, kProbeAbove), kProbeDepth);
  if (!height) {
    std::ostringstream message;
    message << "no ground under the route within 2 m of (" << near.transpose() << ")";
    throw std::invalid_argument(message.str());
  }
  return *height;
}

/// Unit directions of travel, smoothed so that the heading has no kinks.
std::vector<Eigen::Vector2d> headings(const std::vector<Eigen::Vector3d>& way) {
  std::vector<Eigen::Vector2d> directions(way.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Eigen::Vector3d step = way[(i + 1) % way.size()] - way[(i + way.size() - 1) % way.size()];
    directions[i] = step.head<2>().normalized();
  }
  return blur_closed(directions, kHeadingBlur / kSpacing);
}

/// Support plane over one lap: [x y z roll pitch yaw], yaw in (-pi, pi].
std::vector<PoseAngles> support_over_lap(const std::vector<Eigen::Vector3d>& way,
                                         const RayCaster& rays, const Stance& stance) {
  const std::vector<Eigen::Vector2d> direction = headings(way);
  std::array<std::vector<double>, 4> foot;  // front left, front right, hind left, hind right
  for (std::size_t leg = 0; leg < foot.size(); ++leg) {
    const double along = leg < 2 ? stance.half_length : -stance.half_length;
    const double across = leg % 2 == 0 ? stance.half_width : -stance.half_width;
    foot[leg].resize(way.size());
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Eigen::Vector2d forward = direction[i].normalized();
      const Eigen::Vector2d left(-forward.y(), forward.x());
      Eigen::Vector3d at = way[i];
      at.head<2>() += along * forward + across * left;
      foot[leg][i] = ground_height(rays, at);
    }
    foot[leg] = blur_closed(foot[leg], stance.foothold_blur / kSpacing);
  }
  std::vector<PoseAngles> support(way.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double front = 0.5 * (foot[0][i] + foot[1][i]);
    const double hind = 0.5 * (foot[2][i] + foot[3][i]);
    const double left = 0.5 * (foot[0][i] + foot[2][i]);
    const double right = 0.5 * (foot[1][i] + foot[3][i]);
    support[i] << way[i].x(), way[i].y(), 0.5 * (front + hind),
        std::atan2(left - right, 2.0 * stance.half_width),
        -std::atan2(front - hind, 2.0 * stance.half_length),
        std::atan2(direction[i].y(), direction[i].x());
  }
  return support;
}

/// Round a closed way, seen from above [m].
double plan_length(const std::vector<Eigen::Vector3d>& way) {
  double length = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    length += (way[(i + 1) % way.size()] - way[i]).head<2>().norm();
  }
  return length;
}

constexpr double kShortestLap = 1.0;  // [m]
constexpr double kLongestLap = 1e5;

/// @throws std::invalid_argument that says the length, where nobody could walk it.
void check_length(const Scene& scene, const std::vector<Eigen::Vector3d>& way) {
  const double length = plan_length(way);
  if (length >= kShortestLap && length <= kLongestLap) return;
  std::ostringstream message;
  message << "the route of scene '" << scene.name << "' is " << length
          << " m long seen from above and with its corners rounded, expected " << kShortestLap
          << " m to " << kLongestLap / 1000.0 << " km";
  throw std::invalid_argument(message.str());
}

void check_corners(const Scene& scene) {
  if (scene.route.size() < 3) {
    throw std::invalid_argument("the route of scene '" + scene.name + "' has " +
                                std::to_string(scene.route.size()) +
                                " corners, a closed way needs at least 3");
  }
  for (std::size_t i = 0; i < scene.route.size(); ++i) {
    if (scene.route[i].allFinite()) continue;
    std::ostringstream message;
    message << "corner " << i + 1 << " of the route of scene '" << scene.name << "' is ("
            << scene.route[i].transpose() << "), expected finite metres";
    throw std::invalid_argument(message.str());
  }
  check_length(scene, scene.route);
}

}  // namespace

GroundPath::GroundPath(const Scene& scene, const RayCaster& rays, const Stance& stance,
                       double length) {
  check_corners(scene);
  std::vector<Eigen::Vector3d> way = resample_closed(scene.route, kSpacing);
  way = blur_closed(way, scene.corner_rounding / kSpacing);
  // Smoothing shortens the corners; evened out again, a step of the spline is a step of the way.
  check_length(scene, way);
  way = resample_closed(way, kSpacing);
  const std::vector<PoseAngles> support = support_over_lap(way, rays, stance);

  const double lap = plan_length(way);
  lap_ = lap;
  const double step = lap / static_cast<double>(way.size());
  const auto count = static_cast<std::size_t>(std::ceil(std::max(length, lap) / step)) + 4;
  CubicBSpline<6>::Controls controls(count);
  double yaw = support[way.size() - 1](5);
  for (std::size_t i = 0; i < count; ++i) {
    // The first control lies one step before the start of the spline.
    controls[i] = support[(i + way.size() - 1) % way.size()];
    yaw += std::remainder(controls[i](5) - yaw, 2.0 * std::numbers::pi);
    controls[i](5) = yaw;
  }
  spline_ = CubicBSpline<6>(std::move(controls), step);
}

}  // namespace surefoot::simulation
