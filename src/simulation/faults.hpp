// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings in which something goes wrong: what drivers, sensors, files and those who carry them
// do to scans, each with the truth of where the sensor was all the same.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "surefoot/pose.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::simulation {

/// A walk that a fault is done to: any scan of it, whichever was asked before, and the truth.
struct FaultSource {
  std::function<Scan(std::uint64_t index)> scan;
  std::function<Pose(std::int64_t instant_ns)> T_map_lidar;
};

struct FaultyScan {
  Scan scan;
  Pose T_map_lidar;  ///< where the sensor was at the scan's middle, whatever the scan shows
  int place = 0;     ///< poses of different places do not compare
};

/// The scans before a fault, those that one of limited length lasts for, and all.
inline constexpr std::uint64_t kFaultBegins = 30, kFaultLasts = 20, kFaultyScans = 100;
/// No fault asks for a scan of the walk behind this one.
inline constexpr std::uint64_t kFaultReach = 750;

struct Fault {
  std::string name;
  std::string what;  ///< one line
  /// Scan `n` of the faulty recording, of a walk and of one elsewhere.
  std::function<FaultyScan(std::uint64_t n, const FaultSource& walk, const FaultSource& elsewhere)>
      scan;
  bool ends = true;  ///< what is seen in the end fits what was seen at first
};

/// All of them; the first one does nothing.
[[nodiscard]] const std::vector<Fault>& fault_catalogue();

}  // namespace surefoot::simulation
