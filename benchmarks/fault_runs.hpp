// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Walks in which something goes wrong, and what the odometry says of itself meanwhile.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/faults.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene.hpp"
#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot::benchmarks {

/// A pose is wrong if it is farther off than this against that of so many scans before, and, if
/// that one was wrong itself, against the newest right one before it, too.
inline constexpr double kWrongDistance = 0.2;  // [m]
inline constexpr double kWrongAngle = 3.0;     // [deg]
inline constexpr std::uint64_t kWrongScans = 10;

struct WalkSpec {
  std::string scene;
  std::uint64_t seed = 1;  ///< of layout, things, gait and noise
  std::string robot;       ///< empty: what suits the scene

  /// "SCENE:SEED" or "SCENE:SEED:ROBOT". Throws std::invalid_argument.
  [[nodiscard]] static WalkSpec parse(const std::string& text);
  [[nodiscard]] std::string name() const;
};

/// A simulated walk whose scans are made once, and not before they are asked for.
class FaultWalk {
 public:
  explicit FaultWalk(const WalkSpec& spec);
  FaultWalk(const FaultWalk&) = delete;  // the scanner looks into rays_

  [[nodiscard]] const WalkSpec& spec() const { return spec_; }
  [[nodiscard]] const simulation::FaultSource& source() const { return source_; }
  /// [s] since the first scan's begin.
  [[nodiscard]] const simulation::Motion& motion() const { return scanner_->motion(); }
  /// Who goes another way through the same scene, and measures with noise of its own.
  [[nodiscard]] simulation::Scanner on_the_way(const simulation::Motion& motion,
                                               std::uint64_t seed) const;

 private:
  WalkSpec spec_;
  simulation::Scene scene_;
  mutable simulation::RayCaster rays_;
  std::unique_ptr<simulation::Scanner> scanner_;
  std::map<std::uint64_t, Scan> made_;
  simulation::FaultSource source_;
};

/// How far a motion is from the true one.
struct MotionError {
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [deg]
  [[nodiscard]] bool wrong() const { return !(distance <= kWrongDistance && angle <= kWrongAngle); }
};

/// An estimated motion between two instants against the true one.
[[nodiscard]] MotionError motion_error(const Pose& estimated, const Pose& truth);

/// How the LiDAR is mounted on whoever walks.
[[nodiscard]] Pose mount();

/// One scan of a run beside the truth.
struct JudgedScan {
  Estimate estimate;
  /// Against the pose of ten scans before, or the last one called ok before that, of the same
  /// segment; if that one was wrong and this one is right against the newest right one before it,
  /// against that one. None if there is none, or this one is not called ok.
  std::optional<MotionError> over_ten;
  /// Against the last pose before the fault; none in another segment.
  std::optional<MotionError> since_fault;

  [[nodiscard]] bool false_ok() const {
    return estimate.status == Status::ok && over_ten && over_ten->wrong();
  }
};

/// A faulty walk's first `scans`, as the odometry takes them.
[[nodiscard]] std::vector<JudgedScan> run_fault(const FaultWalk& walk, const FaultWalk& elsewhere,
                                                const simulation::Fault& fault, std::uint64_t scans,
                                                const Config& config = {});

}  // namespace surefoot::benchmarks
