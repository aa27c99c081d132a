// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a moving sensor measures of a scene that stands still, and how well deskewing undoes it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/preprocess.hpp"
#include "support/random.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::test {

inline constexpr std::int64_t kStart = 5'000'000'000;  // of the scan [ns]
inline constexpr std::int64_t kEnd = 5'100'000'000;

/// Points of a static scene as a sensor that moves along `T_map_lidar(tau)` measures them.
template <typename Motion>
PreparedScan measure(const std::vector<Eigen::Vector3d>& scene, const Motion& T_map_lidar) {
  PreparedScan scan;
  scan.start_ns = kStart;
  scan.end_ns = kEnd;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const double tau = static_cast<double>(i) / static_cast<double>(scene.size() - 1);
    scan.taus.push_back(static_cast<float>(tau));
    const Eigen::Vector3d seen = T_map_lidar(scan.taus.back()).inverse() * scene[i];
    scan.points.emplace_back(seen.cast<float>());
  }
  return scan;
}

inline std::vector<Eigen::Vector3d> random_scene(Random& random, const Pose& around, int count) {
  std::vector<Eigen::Vector3d> scene;
  for (int i = 0; i < count; ++i) scene.emplace_back(around * random.vector(30.0));
  return scene;
}

/// Largest distance [m] between deskewed points, put at the true mid-scan pose, and the scene.
inline double largest_miss(const std::vector<Eigen::Vector3f>& deskewed, const Pose& T_mid,
                           const std::vector<Eigen::Vector3d>& scene) {
  double largest = 0.0;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    largest = std::max(largest, (T_mid * deskewed[i].cast<double>() - scene[i]).norm());
  }
  return largest;
}

inline constexpr double kFloatRounding = 2e-5;  // [m] floats at up to 52 m, in and out

}  // namespace surefoot::test
