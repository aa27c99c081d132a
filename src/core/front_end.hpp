// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// What every front-end works with; it outlives them.
struct Session {
  const Config config;
  Workers workers;
  StepObserver begin_step = [](Step) {};
};

/// A method: scans in, estimates out, all in the map's frame. Odometry checks the scans before and
/// brings the estimates to the caller's world.
class FrontEnd {
 public:
  FrontEnd() = default;
  FrontEnd(const FrontEnd&) = delete;
  FrontEnd& operator=(const FrontEnd&) = delete;
  virtual ~FrontEnd() = default;

  /// One usable scan whose middle is later than that of the scan before, lost or not. It stays
  /// where it is until the next one is added.
  virtual Estimate add(const PreparedScan& scan) = 0;

  /// The last trusted pose; nothing before the first scan.
  [[nodiscard]] virtual std::optional<StampedPose> last_pose() const = 0;
  /// As Estimate::twist.
  [[nodiscard]] virtual Twist velocity() const = 0;
  [[nodiscard]] virtual const LevelReport& level() const = 0;
  [[nodiscard]] virtual const DeskewedScan& deskewed_scan() const = 0;
  /// The local map's points [m].
  [[nodiscard]] virtual std::vector<Eigen::Vector3d> local_map() const = 0;
  /// As Odometry::emptied_cubes(), in the map's frame, by the last scan that was added.
  [[nodiscard]] virtual Cubes emptied_cubes() const { return {}; }
};

/// The front-end that config.method names.
[[nodiscard]] std::unique_ptr<FrontEnd> make_front_end(const Session& session);
/// One of this kind.
template <typename Kind>
[[nodiscard]] std::unique_ptr<FrontEnd> make_front_end(const Session& session) {
  return std::make_unique<Kind>(session);
}

}  // namespace surefoot
