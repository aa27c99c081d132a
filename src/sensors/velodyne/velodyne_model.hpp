// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Velodyne's spinning LiDARs as their manuals describe them. All send data packets of 1206 bytes,
// 12 blocks of 32 channels; they differ in what a block is, in angles and in firing times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::sensors {

struct VelodyneLaser {
  double elevation_deg = 0.0;
  double azimuth_deg = 0.0;            ///< added to the head's, clockwise
  double time_ns = 0.0;                ///< after the first laser of its firing sequence
  std::optional<double> dual_time_ns;  ///< the same with two returns, where that differs
  double height = 0.0;                 ///< of the beam's origin on the axis above the centre [m]
  /// What a calibration corrects; zero without one but for the HDL-64E [m].
  double distance = 0.0;
  double distance_x = 0.0;
  double distance_y = 0.0;
  bool two_points = false;  ///< distance_x and distance_y hold
  double vertical_offset = 0.0;
  double horizontal_offset = 0.0;
};

struct VelodyneModel {
  std::string name;
  std::optional<std::uint8_t> product;  ///< factory byte 1205; empty: any
  bool is_hdl64 = false;                ///< no factory bytes
  std::vector<VelodyneLaser> lasers;
  double distance_unit = 0.0;           ///< [m]
  std::size_t banks = 1;                ///< blocks of one firing sequence, 32 lasers each
  std::size_t sequences_per_block = 1;  ///< 2 where a sequence has 16 lasers only
  double sequence_ns = 0.0;
  double dual_sequence_ns = 0.0;  ///< with two returns; the same but for the HDL-64E
  double slow_sequence_ns = 0.0;  ///< of newer firmware; 0: the same
  double first_ns = 0.0;          ///< from the packet's time to its first firing
  bool time_is_end = false;       ///< the packet's time is that of its end
};

/// Models by name: VLP-16, Puck Hi-Res, VLP-32C, HDL-32E, HDL-64E-S2, HDL-64E-S3, VLS-128.
[[nodiscard]] const std::vector<VelodyneModel>& velodyne_models();

/// "0x21 (HDL-32E)".
[[nodiscard]] std::string velodyne_product_name(std::uint8_t product);

}  // namespace surefoot::sensors
