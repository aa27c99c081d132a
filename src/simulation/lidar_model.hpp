// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Spinning LiDARs as their manuals say: who fires when, where to, and how well it measures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace surefoot::simulation {

/// One laser within a firing sequence.
struct Laser {
  double offset_ns = 0.0;        ///< from the start of the firing sequence
  double elevation = 0.0;        ///< [rad]
  double azimuth_offset = 0.0;   ///< added to the rotor's azimuth, clockwise positive [rad]
  double vertical_origin = 0.0;  ///< height of the beam's origin above the sensor's centre [m]
  std::uint16_t ring = 0;        ///< counted from the lowest
};

/// The rotor turns clockwise seen from above; azimuth 0 is the x axis, forward.
struct LidarModel {
  std::string name;
  std::vector<Laser> lasers;      ///< in firing order: offset_ns never falls
  double sequence_ns = 0.0;       ///< from one firing sequence to the next
  double turn_ns = 1e8;           ///< one revolution: 600 rpm
  int sequences_per_azimuth = 1;  ///< firing sequences that share one azimuth reading
  double azimuth_unit = 0.0;      ///< resolution of that reading [rad]; 0: exact
  double radial_origin = 0.0;     ///< distance of the beams' origin from the axis [m]
  double min_range = 0.0;         ///< nearer returns are not given [m]
  double max_range = 0.0;         ///< [m]
  /// Range at which a facing surface of reflectivity 0.1 is detected half of the time [m].
  double half_detection_range = 0.0;
  double range_sigma = 0.0;            ///< noise of a strong return, standard deviation [m]
  double range_unit = 0.0;             ///< quantisation [m]
  double divergence_horizontal = 0.0;  ///< full angle of the beam [rad]
  double divergence_vertical = 0.0;
  double pulse_length = 0.0;  ///< two surfaces nearer than this blend into one return [m]
};

/// Names: vlp16, vlp32, os1-64 and os1-128 (1024 columns a turn, with -2048 behind them as many),
/// hesai-xt16.
[[nodiscard]] const std::vector<std::string>& lidar_names();
/// @throws std::invalid_argument that names the models there are.
[[nodiscard]] LidarModel lidar_model(const std::string& name);

}  // namespace surefoot::simulation
