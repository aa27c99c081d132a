// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the page of a live run is told.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot::live_page {

/// A scan's answer, as the page shows it.
struct PageScan {
  std::string name;
  std::int64_t stamp_ns = 0;
  std::string status;  ///< as scans.csv has it
  std::string message;
  int segment = 0;
  Pose T_world_lidar;
  double wrong_probability = 0.0;  ///< NaN: not told
  std::string weak;                ///< names of the weak directions, between blanks
  double latency_ms = 0.0;         ///< from its last packet to its pose
};

/// A deskewed scan, in the LiDAR's frame at mid-scan.
struct PageCloud {
  std::vector<Eigen::Vector3f> points;  ///< [m]
  Pose T_world_lidar;
  int segment = 0;
};

/// How the run keeps up.
struct PageFigures {
  std::uint64_t used = 0, dropped = 0, left_out = 0;  ///< scans; the last ones during pauses
  std::uint64_t received = 0, lost = 0;               ///< packets or messages
  double latency_p50_ms = 0.0, latency_p99_ms = 0.0, latency_max_ms = 0.0;
  bool paused = false;
};

}  // namespace surefoot::live_page
