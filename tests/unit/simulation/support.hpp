// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A room whose walls are known by formula, so that points can be judged without the ray caster.
#pragma once

#include <algorithm>
#include <cmath>

#include "simulation/body_motion.hpp"
#include "simulation/lidar_model.hpp"
#include "simulation/scanner.hpp"

namespace surefoot::simulation::test {

inline const Eigen::Vector3d kRoomLow(-9.0, -7.0, 0.0);
inline const Eigen::Vector3d kRoomHigh(9.0, 7.0, 5.0);

/// One box seen from inside, and a way round in it.
inline Scene room() {
  Scene scene;
  scene.name = "room";
  scene.mesh.add_box(kRoomLow, kRoomHigh, Material::concrete);
  scene.route = {{-4, -3, 0}, {4, -3, 0}, {4, 3, 0}, {-4, 3, 0}};
  return scene;
}

/// Distance of a point to the nearest of the room's six planes.
inline double distance_to_room(const Eigen::Vector3d& point) {
  return std::min((point - kRoomLow).cwiseAbs().minCoeff(),
                  (point - kRoomHigh).cwiseAbs().minCoeff());
}

inline const Pose kMount{Eigen::Quaterniond::Identity(), {0.1, 0.0, 0.16}};

/// The instant of a point, in seconds since time 0.
inline double instant(const SimulatedScan& scan, std::size_t point, const ScannerOptions& options) {
  return 1e-9 *
         static_cast<double>(scan.scan.stamp_ns - options.start_ns + scan.scan.times_ns[point]);
}

/// Amplitude of a sine of this frequency in evenly sampled values (Hann window).
inline double amplitude_at(const std::vector<double>& values, double step, double frequency) {
  constexpr double kTwoPi = 6.283185307179586;
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(values.size());
    const double weight = 1.0 - std::cos(kTwoPi * x);  // mean 1
    const double angle = kTwoPi * frequency * step * static_cast<double>(i);
    cosine += weight * (values[i] - mean) * std::cos(angle);
    sine += weight * (values[i] - mean) * std::sin(angle);
  }
  return 2.0 * std::hypot(cosine, sine) / static_cast<double>(values.size());
}

}  // namespace surefoot::simulation::test
