// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Of the component surefoot::mapping: find_package(surefoot COMPONENTS mapping).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// Where in a saved map the robot is, from an unknown start, by its LiDAR alone. "Not found yet" is
/// an answer; a wrong place is none.
///
///     surefoot::Odometry odometry;
///     surefoot::Localizer localizer("map.surefoot");
///     for (const surefoot::Scan& scan : scans) {
///       const surefoot::Estimate estimate = odometry.add_scan(scan);
///       localizer.add(estimate, odometry);
///       if (localizer.T_map_lidar()) ...
///     }
///
/// The same calls give the same bits. An object belongs to one thread at a time.
class Localizer {
 public:
  /// `map`: what Mapper::save() or `surefoot map` has written, or the folder with its map.surefoot.
  /// Throws std::runtime_error that names the file and says what was seen and expected.
  explicit Localizer(const std::filesystem::path& map);
  ~Localizer();
  Localizer(const Localizer&) = delete;
  Localizer& operator=(const Localizer&) = delete;
  Localizer(Localizer&&) noexcept;
  Localizer& operator=(Localizer&&) noexcept;

  /// What the odometry said of a scan, and its points [m], in the LiDAR's frame at
  /// `estimate.stamp_ns` (Odometry::deskewed_scan()); every scan, in the order in which they came.
  /// An estimate that is not trusted() has no place in the map, and changes nothing.
  void add(const Estimate& estimate, const DeskewedScan& scan);
  /// What `odometry` has just said of a scan. Its points are made only where they are looked at:
  /// of few scans, once the place is known.
  void add(const Estimate& estimate, const Odometry& odometry);

  /// Of the last scan, at mid-scan; none: not found yet, lost, or its estimate was not trusted.
  [[nodiscard]] std::optional<Pose> T_map_lidar() const;
  /// From the odometry's world to the map; none: not found yet, or lost.
  [[nodiscard]] std::optional<Pose> T_map_world() const;
  /// One sentence about the last search or check: "found", or why not.
  [[nodiscard]] const std::string& message() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace surefoot
