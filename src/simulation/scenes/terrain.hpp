// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Ground that nobody built, and ways over it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "simulation/random.hpp"

namespace surefoot::simulation {

/// Heights as a sum of plane waves that run in all directions, on a slope and a hill.
class Terrain {
 public:
  /// @param random draws the waves' directions and phases.
  explicit Terrain(const CounterRandom& random) : random_(random) {}

  /// `count` waves of about this length; together of this amplitude [m].
  void add_waves(double length, double amplitude, int count = 4);
  /// Rises by `gradient` a metre.
  void add_slope(const Eigen::Vector2d& gradient) { gradient_ += gradient; }
  /// A round hill over the middle. @param radius one standard deviation [m].
  void add_hill(double height, double radius);

  [[nodiscard]] double operator()(double x, double y) const;
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& place) const {
    return {place.x(), place.y(), (*this)(place.x(), place.y())};
  }

 private:
  struct Wave {
    Eigen::Vector2d number;  ///< [rad/m]
    double phase = 0.0;
    double amplitude = 0.0;
  };
  CounterRandom random_;
  std::uint64_t drawn_ = 0;
  std::vector<Wave> waves_;
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
  double hill_height_ = 0.0;
  double hill_radius_ = 1.0;
};

/// A closed way round the middle that bends in and out and never meets itself.
/// @param radius the mean one [m]; the smallest is 0.55 of it, the greatest 1.45.
[[nodiscard]] std::vector<Eigen::Vector3d> winding_loop(const Terrain& ground, double radius,
                                                        const CounterRandom& random);

/// A way as pieces, to ask how far a place is from it.
class RouteSegments {
 public:
  /// @param route corners of a closed way.
  explicit RouteSegments(const std::vector<Eigen::Vector3d>& route);
  /// From a place to the nearest piece, in the plane [m].
  [[nodiscard]] double distance(const Eigen::Vector2d& place) const;
  /// The pieces that come this near to a place.
  [[nodiscard]] RouteSegments within(double radius, const Eigen::Vector2d& place) const;

 private:
  struct Segment {
    Eigen::Vector2d from;
    Eigen::Vector2d edge;
    [[nodiscard]] double distance(const Eigen::Vector2d& place) const;
  };
  RouteSegments() = default;
  std::vector<Segment> segments_;
};

}  // namespace surefoot::simulation
