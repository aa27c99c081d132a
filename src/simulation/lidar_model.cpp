// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/lidar_model.hpp"

#include <numbers>
#include <stdexcept>

#include "sensor/vlp16.hpp"

namespace surefoot::simulation {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Velodyne VLP-16: manual 63-9243 rev. E. Divergence 3.0 x 1.5 mrad, 100 m, +-3 cm (typical).
LidarModel vlp16_model() {
  LidarModel model;
  model.name = "vlp16";
  for (std::size_t laser = 0; laser < vlp16::kLasers; ++laser) {
    model.lasers.push_back({.offset_ns = vlp16::kLaserNs * static_cast<double>(laser),
                            .elevation = vlp16::kElevationDeg[laser] * kDegree,
                            .vertical_origin = 1e-3 * vlp16::kVerticalOffsetMm[laser],
                            .ring = vlp16::kRing[laser]});
  }
  model.sequence_ns = vlp16::kSequenceNs;
  model.sequences_per_azimuth = 2;
  model.azimuth_unit = 2.0 * std::numbers::pi / vlp16::kAzimuthUnitsPerTurn;
  model.min_range = 0.4;
  model.max_range = 100.0;
  model.full_signal_range = 45.0;
  model.range_sigma = 0.01;
  model.range_unit = vlp16::kDistanceUnit;
  model.divergence_horizontal = 3.0e-3;
  model.divergence_vertical = 1.5e-3;
  model.pulse_length = 0.9;
  return model;
}

}  // namespace

const std::vector<std::string>& lidar_names() {
  static const std::vector<std::string> names = {"vlp16"};
  return names;
}

LidarModel lidar_model(const std::string& name) {
  if (name == "vlp16") return vlp16_model();
  std::string known;
  for (const std::string& other : lidar_names()) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument("no LiDAR is called '" + name + "'; there are: " + known);
}

}  // namespace surefoot::simulation
