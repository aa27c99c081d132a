// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A run within a saved map: poses in the map's frame, and scan by scan whether the place is known.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "mapping/map_localizer.hpp"
#include "mapping/placed_scans.hpp"
#include "mapping/walk_clock.hpp"
#include "runs/map_outcome.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::runs {

class LocalizationRun {
 public:
  /// @param T_lidar_written as for the run's other trajectories.
  LocalizationRun(mapping::SavedMap map, const Pose& T_lidar_written);

  /// Where trajectory_map.tum and localization.csv are written, line by line: before the first
  /// scan. Throws io::WriteError.
  void open(const std::filesystem::path& folder);
  /// From an unknown place again, in this map. Poses in another one's frame are kept beside
  /// trajectory_map.tum, as trajectory_map_1.tum, _2 and so on.
  void begin_anew(mapping::SavedMap map, bool is_another);
  /// From the run's world to the map; none: not found yet, or lost.
  [[nodiscard]] const std::optional<Pose>& T_map_world() const { return localizer_.T_map_world(); }

  /// Every scan; one whose pose was not measured has no place in the map. Throws io::WriteError.
  void add(const Estimate& estimate, const mapping::ScanPoints& points);
  [[nodiscard]] LocalizationOutcome finish() const { return outcome_; }

 private:
  void write(const std::string& row);
  void keep_poses();

  mapping::MapLocalizer localizer_;
  Pose T_lidar_written_;
  std::filesystem::path folder_;
  std::ofstream poses_;  // T_map_written
  std::ofstream csv_;
  LocalizationOutcome outcome_;
  mapping::WalkClock clock_;  // of the first scan, and of those whose stamps were believed
  mapping::PlacedScans placed_;
};

}  // namespace surefoot::runs
