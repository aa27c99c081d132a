// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/lidar_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sensors/velodyne/velodyne_model.hpp"
#include "sensors/velodyne/vlp16.hpp"

namespace surefoot::simulation {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Velodyne VLP-16: manual 63-9243 rev. E. Divergence 3.0 x 1.5 mrad, 100 m, +-3 cm (typical). The
/// angles agree with params/VLP16db.yaml of github.com/ros-drivers/velodyne, the firing times with
/// its src/lib/rawdata.cc, the nearest range with its launch file, the heights of the beams'
/// origins (41.91 mm) with src/calib_db.cpp of github.com/valgur/velodyne_decoder.
LidarModel vlp16_model() {
  LidarModel model;
  model.name = "vlp16";
  for (std::size_t laser = 0; laser < vlp16::kLasers; ++laser) {
    model.lasers.push_back({.offset_ns = vlp16::kLaserNs * static_cast<double>(laser),
                            .elevation = vlp16::kElevationDeg[laser] * kDegree,
                            .vertical_origin = 1e-3 * vlp16::kVerticalOffsetMm[laser]});
  }
  model.sequence_ns = vlp16::kSequenceNs;
  model.sequences_per_azimuth = 2;
  model.azimuth_unit = 2.0 * std::numbers::pi / vlp16::kAzimuthUnitsPerTurn;
  model.min_range = 0.4;
  model.max_range = 100.0;
  model.half_detection_range = 45.0;
  model.range_sigma = 0.01;
  model.range_unit = vlp16::kDistanceUnit;
  model.divergence_horizontal = 3.0e-3;
  model.divergence_vertical = 1.5e-3;
  model.pulse_length = 0.9;
  return model;
}

/// Velodyne VLP-32C: manual 63-9325 rev. B, tables of firing order, elevation, azimuth offset. Two
/// lasers fire at a time. All 32 pairs of angles agree with params/VeloView-VLP-32C.yaml of
/// github.com/ros-drivers/velodyne (whose rot_correction is subtracted from the azimuth: the sign
/// is the other), as does the unit of distance; the firing times with its src/lib/rawdata.cc. The
/// beams cross 42.4 mm from the axis (velodyne_decoder, as above), hence their heights on it.
LidarModel vlp32_model() {
  constexpr double kCrossing = 0.0424;  // [m]
  LidarModel model;
  model.name = "vlp32";
  const auto& models = sensors::velodyne_models();
  const auto& lasers = std::find_if(models.begin(), models.end(), [](const auto& known) {
                         return known.name == "VLP-32C";
                       })->lasers;
  for (std::size_t laser = 0; laser < lasers.size(); ++laser) {
    const double elevation = lasers[laser].elevation_deg * kDegree;
    model.lasers.push_back({.offset_ns = vlp16::kLaserNs * static_cast<double>(laser / 2),
                            .elevation = elevation,
                            .azimuth_offset = lasers[laser].azimuth_deg * kDegree,
                            .vertical_origin = -kCrossing * std::tan(elevation)});
  }
  model.sequence_ns = vlp16::kSequenceNs;
  model.azimuth_unit = 0.01 * kDegree;
  model.min_range = 0.5;
  model.max_range = 200.0;
  model.half_detection_range = 80.0;
  model.range_sigma = 0.01;
  model.range_unit = 0.004;
  model.divergence_horizontal = 3.0e-3;
  model.divergence_vertical = 1.5e-3;
  model.pulse_length = 0.9;
  return model;
}

/// Ouster OS1-64 (first generation) at 1024 columns and 10 Hz: the design values of the maker's SDK
/// (github.com/ouster-lidar/ouster-sdk, gen1_altitude_angles, gen1_azimuth_angles and the distance
/// of the beams' origin, 12.163 mm). All lasers of a column measure at once, at fixed angles of the
/// encoder. The lower half mirrors the upper one.
LidarModel os1_64_model() {
  constexpr int kBeams = 64;
  constexpr std::array<double, kBeams / 2> kUpperDeg = {
      16.611, 16.084, 15.557, 15.029, 14.502, 13.975, 13.447, 12.920, 12.393, 11.865, 11.338,
      10.811, 10.283, 9.756,  9.229,  8.701,  8.174,  7.646,  7.119,  6.592,  6.064,  5.537,
      5.010,  4.482,  3.955,  3.428,  2.900,  2.373,  1.846,  1.318,  0.791,  0.264};
  constexpr std::array<double, 4> kAzimuthDeg = {3.164, 1.055, -1.055, -3.164};
  constexpr int kColumns = 1024;
  LidarModel model;
  model.name = "os1-64";
  for (int beam = 0; beam < kBeams; ++beam) {
    const bool upper = beam < kBeams / 2;
    const double elevation_deg = upper ? kUpperDeg[static_cast<std::size_t>(beam)]
                                       : -kUpperDeg[static_cast<std::size_t>(kBeams - 1 - beam)];
    model.lasers.push_back(
        {.elevation = elevation_deg * kDegree,
         .azimuth_offset = kAzimuthDeg[static_cast<std::size_t>(beam % 4)] * kDegree});
  }
  model.sequence_ns = model.turn_ns / kColumns;
  model.radial_origin = 0.012163;
  model.min_range = 0.8;
  model.max_range = 120.0;
  model.half_detection_range = 45.0;
  model.range_sigma = 0.012;
  model.range_unit = 0.001;
  model.divergence_horizontal = 2.3e-3;  // 0.13 deg full angle
  model.divergence_vertical = 2.3e-3;
  model.pulse_length = 0.6;
  return model;
}

/// Ouster OS1-128 at 1024 columns and 10 Hz: 128 beams evenly over 42.4 degrees, as its data sheet
/// has it, and the azimuths and the distance of the beams' origin as one says of itself (the
/// OS1-128 of ../shared/data/ouster_os1, whose own elevations are within a degree of these). Else
/// as the one of 64 beams.
LidarModel os1_128_model() {
  constexpr int kBeams = 128;
  constexpr double kHighestDeg = 21.2;
  constexpr std::array<double, 4> kAzimuthDeg = {4.2, 1.4, -1.4, -4.2};
  LidarModel model = os1_64_model();
  model.name = "os1-128";
  model.lasers.clear();
  for (int beam = 0; beam < kBeams; ++beam) {
    const double elevation_deg = kHighestDeg * (1.0 - 2.0 * beam / (kBeams - 1));
    model.lasers.push_back(
        {.elevation = elevation_deg * kDegree,
         .azimuth_offset = kAzimuthDeg[static_cast<std::size_t>(beam % 4)] * kDegree});
  }
  model.radial_origin = 0.015806;
  model.min_range = 0.5;
  return model;
}

/// Hesai PandarXT-16 at 600 rpm: a column every 50 us (0.18 deg), channels 3.024 us apart, the
/// first 6 us after the column begins ("PandarXT-16_Firetime Correction File.csv" of
/// github.com/HesaiTechnology/HesaiLidar_SDK_2.0), topmost first, every second elevation of the
/// XT-32 (pandarXT.h of HesaiLidar_General_ROS), 4 mm a unit of distance (there, too).
LidarModel hesai_xt16_model() {
  constexpr int kChannels = 16;
  LidarModel model;
  model.name = "hesai-xt16";
  for (int channel = 0; channel < kChannels; ++channel) {
    model.lasers.push_back(
        {.offset_ns = 6000.0 + 3024.0 * channel, .elevation = (15.0 - 2.0 * channel) * kDegree});
  }
  model.sequence_ns = 50'000.0;
  model.azimuth_unit = 0.01 * kDegree;
  model.min_range = 0.05;
  model.max_range = 120.0;
  model.half_detection_range = 80.0;  // 10 % at 80 m
  model.range_sigma = 0.005;
  model.range_unit = 0.004;
  model.divergence_horizontal = 1.5e-3;
  model.divergence_vertical = 1.5e-3;
  model.pulse_length = 0.6;
  return model;
}

/// In the mode of 2048 columns a turn, of the same period.
LidarModel with_2048_columns(LidarModel model) {
  model.name += "-2048";
  model.sequence_ns = model.turn_ns / 2048;
  return model;
}

/// Rings by elevation, 0 the lowest.
LidarModel with_rings(LidarModel model) {
  for (Laser& laser : model.lasers) {
    laser.ring = static_cast<std::uint16_t>(
        std::count_if(model.lasers.begin(), model.lasers.end(),
                      [&](const Laser& other) { return other.elevation < laser.elevation; }));
  }
  return model;
}

}  // namespace

const std::vector<std::string>& lidar_names() {
  static const std::vector<std::string> names = {
      "vlp16", "vlp32", "os1-64", "os1-64-2048", "os1-128", "os1-128-2048", "hesai-xt16"};
  return names;
}

LidarModel lidar_model(const std::string& name) {
  if (name == "vlp16") return with_rings(vlp16_model());
  if (name == "vlp32") return with_rings(vlp32_model());
  if (name == "os1-64") return with_rings(os1_64_model());
  if (name == "os1-128") return with_rings(os1_128_model());
  if (name == "os1-64-2048") return with_rings(with_2048_columns(os1_64_model()));
  if (name == "os1-128-2048") return with_rings(with_2048_columns(os1_128_model()));
  if (name == "hesai-xt16") return with_rings(hesai_xt16_model());
  std::string known;
  for (const std::string& other : lidar_names()) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument("no LiDAR is called '" + name + "'; there are: " + known);
}

}  // namespace surefoot::simulation
