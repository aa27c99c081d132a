// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Of the component surefoot::mapping: find_package(surefoot COMPONENTS mapping).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// What came of a map that was to be continued.
struct JoinReport {
  bool joined = false;
  std::size_t compared = 0;  ///< places
  std::size_t loops = 0;     ///< between the two maps, that were taken
  std::string message;       ///< one sentence: why it was not joined; else empty
};

/// A map of a walk: beside an odometry, which it leaves alone, it finds the places that were
/// visited before, and corrects what the odometry got wrong in between. docs/mapping.md says what
/// is asked of a loop.
///
///     surefoot::Odometry odometry;
///     surefoot::Mapper mapper;
///     for (const surefoot::Scan& scan : scans) {
///       const surefoot::Estimate estimate = odometry.add_scan(scan);
///       if (estimate.trusted()) mapper.add(estimate, odometry.deskewed_scan());
///     }
///     mapper.finish();
///     mapper.save("map.surefoot");
///
/// The same calls give the same bits. An object belongs to one thread at a time.
class Mapper {
 public:
  Mapper();
  ~Mapper();
  Mapper(const Mapper&) = delete;
  Mapper& operator=(const Mapper&) = delete;
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;

  /// What the odometry said of a scan, and its points [m], in the LiDAR's frame at
  /// `estimate.stamp_ns` (Odometry::deskewed_scan()); in the order in which they came. An estimate
  /// that is not trusted() is passed over. Throws std::logic_error after finish().
  void add(const Estimate& estimate, const DeskewedScan& scan);

  /// Ends the walk, chooses among the loops and moves the poses. Throws std::logic_error when it is
  /// called again, std::runtime_error where loops were found and the library was built without
  /// Ceres.
  void finish();

  // After finish(); before, all of these throw std::logic_error.

  /// Joins the map to a saved one: map.surefoot, or the folder that it lies in. Where that succeeds
  /// everything below is in that one's frame, and save() writes both as one; else nothing changes.
  /// Throws std::runtime_error that names the file if it cannot be read, std::logic_error after it
  /// succeeded: a walk is joined to one map.
  JoinReport join(const std::filesystem::path& map);

  /// T_map_lidar at mid-scan, one an estimate that was added and trusted, after all loops. Without
  /// those of stretches that nothing holds to a map that it was joined to; where it was joined to
  /// none, stretches that no loop holds together are each in a frame of their own.
  [[nodiscard]] Trajectory trajectory() const;
  /// T_map_world at an instant [ns, the sensor's epoch]: from the odometry's world to the map,
  /// smooth between instants. At the nearest end of the walk where the instant lies outside of it;
  /// for the last time, where the sensor's clock was set back and showed it twice. None in those
  /// stretches.
  [[nodiscard]] std::optional<Pose> T_map_world(std::int64_t stamp_ns) const;
  /// How many loops within the walk were taken, of so many places that were compared.
  [[nodiscard]] std::size_t loops() const;
  [[nodiscard]] std::size_t compared() const;

  /// Writes the map, to come back to with Localizer, `surefoot run --localize`, join(): the old
  /// file or the whole new one is there. Throws std::runtime_error that names the file.
  void save(const std::filesystem::path& file) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace surefoot
