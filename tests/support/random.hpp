// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "surefoot/pose.hpp"

namespace surefoot::test {

/// Random values that are the same on every machine (the standard's distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double normal(double sigma) {
    const double radius = std::sqrt(-2.0 * std::log(uniform(0x1p-53, 1.0)));
    return sigma * radius * std::cos(2.0 * std::numbers::pi * uniform(0.0, 1.0));
  }
  /// Every coordinate in [-size, size).
  Eigen::Vector3d vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }
  Eigen::Vector3d unit_vector() {
    const double x = normal(1.0), y = normal(1.0);
    return Eigen::Vector3d(x, y, normal(1.0)).normalized();
  }
  /// Translation [m] and rotation vector [rad], each coordinate up to the given size.
  Twist twist(double translation, double rotation) {
    Twist twist;
    twist.head<3>() = vector(translation);
    twist.tail<3>() = vector(rotation);
    return twist;
  }
  Pose pose(double translation, double max_angle) {
    const Eigen::Vector3d place = vector(translation);
    return {so3_exp(uniform(0.0, max_angle) * unit_vector()), place};
  }
  std::uint64_t below(std::uint64_t size) { return engine_() % size; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace surefoot::test
