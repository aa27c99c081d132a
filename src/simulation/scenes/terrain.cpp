// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace surefoot::simulation {

namespace {
constexpr double kTwoPi = 2.0 * std::numbers::pi;
}  // namespace

void Terrain::add_waves(double length, double amplitude, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = kTwoPi * random_.uniform(drawn_++);
    const double number = kTwoPi / (length * random_.uniform(drawn_++, 0.75, 1.3));
    waves_.push_back({number * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                      kTwoPi * random_.uniform(drawn_++), amplitude / std::sqrt(count)});
  }
}

void Terrain::add_hill(double height, double radius) {
  hill_height_ = height;
  hill_radius_ = radius;
}

double Terrain::operator()(double x, double y) const {
  const Eigen::Vector2d place(x, y);
  double height = gradient_.dot(place);
  height += hill_height_ * std::exp(-0.5 * place.squaredNorm() / (hill_radius_ * hill_radius_));
  for (const Wave& wave : waves_) {
    height += wave.amplitude * std::sin(wave.number.dot(place) + wave.phase);
  }
  return height;
}

std::vector<Eigen::Vector3d> winding_loop(const Terrain& ground, double radius,
                                          const CounterRandom& random) {
  // Bends of two to five periods a lap; the sum of their amplitudes bounds the radius.
  constexpr std::array<double, 4> kAmplitudes = {0.18, 0.13, 0.08, 0.06};
  const int corners = std::max(16, static_cast<int>(kTwoPi * radius));
  std::vector<Eigen::Vector3d> route;
  for (int i = 0; i < corners; ++i) {
    const double angle = kTwoPi * i / corners;
    double scale = 1.0;
    for (std::size_t k = 0; k < kAmplitudes.size(); ++k) {
      const double periods = static_cast<double>(k + 2);
      scale += kAmplitudes.at(k) * std::sin(periods * angle + kTwoPi * random.uniform(k));
    }
    route.push_back(ground.at(radius * scale * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return route;
}

double RouteSegments::Segment::distance(const Eigen::Vector2d& place) const {
  const double part = std::clamp(edge.dot(place - from) / edge.squaredNorm(), 0.0, 1.0);
  return (place - from - part * edge).norm();
}

RouteSegments::RouteSegments(const std::vector<Eigen::Vector3d>& route) {
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d from = route[i].head<2>();
    segments_.push_back({from, route[(i + 1) % route.size()].head<2>() - from});
  }
}

double RouteSegments::distance(const Eigen::Vector2d& place) const {
  double nearest = std::numeric_limits<double>::max();
  for (const Segment& segment : segments_) nearest = std::min(nearest, segment.distance(place));
  return nearest;
}

RouteSegments RouteSegments::within(double radius, const Eigen::Vector2d& place) const {
  RouteSegments near;
  for (const Segment& segment : segments_) {
    if (segment.distance(place) <= radius) near.segments_.push_back(segment);
  }
  return near;
}

}  // namespace surefoot::simulation
