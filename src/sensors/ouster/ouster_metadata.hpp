// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What an Ouster says about itself in its metadata JSON, of any firmware: without it its packets
// cannot be understood.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace surefoot::sensors {

/// Where the fields of a pixel lie [bits]; 0 bits: it has no such field.
struct OusterField {
  unsigned at = 0;
  unsigned bits = 0;
  unsigned shift = 0;  ///< the value counts in units of 2^shift
};

/// A format of lidar packets (`udp_profile_lidar`).
struct OusterProfile {
  std::string name;
  std::size_t pixel_bytes = 0;
  OusterField range, reflectivity, signal;
  OusterField range_2, reflectivity_2, signal_2;  ///< of the second return

  [[nodiscard]] bool is_legacy() const { return name == "LEGACY"; }
  [[nodiscard]] bool is_dual() const { return range_2.bits > 0; }
};

struct OusterMetadata {
  std::string product;  ///< "OS-1-128"
  OusterProfile profile;
  std::size_t columns_per_frame = 0;
  std::size_t columns_per_packet = 0;
  std::size_t pixels = 0;        ///< a column
  std::size_t first_column = 0;  ///< of the window that is measured
  std::size_t last_column = 0;
  double rate_hz = 10.0;
  std::vector<double> elevation_deg;
  std::vector<double> azimuth_deg;  ///< of the beams from the encoder's angle
  Eigen::Matrix4d T_lidar_beam = Eigen::Matrix4d::Identity();    ///< [m]
  Eigen::Matrix4d T_sensor_lidar = Eigen::Matrix4d::Identity();  ///< [m]

  [[nodiscard]] std::size_t column_header_bytes() const { return profile.is_legacy() ? 16 : 12; }
  [[nodiscard]] std::size_t header_bytes() const { return profile.is_legacy() ? 0 : 32; }
  [[nodiscard]] std::size_t column_bytes() const {
    return column_header_bytes() + pixels * profile.pixel_bytes + (profile.is_legacy() ? 4 : 0);
  }
  [[nodiscard]] std::size_t packet_bytes() const {
    return 2 * header_bytes() + columns_per_packet * column_bytes();  // a footer like the header
  }
  [[nodiscard]] std::size_t window_columns() const {
    return (last_column + columns_per_frame - first_column) % columns_per_frame + 1;
  }
};

/// Throws CalibrationError naming what is missing or contradicts itself.
[[nodiscard]] OusterMetadata parse_ouster_metadata(const std::string& json);

/// Whether a size is that of some Ouster's lidar packets, of 16 columns and any profile.
[[nodiscard]] bool is_ouster_size(std::size_t bytes);

}  // namespace surefoot::sensors
