// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What each step of the odometry is given for one scan in the middle of a walk over the campus.
#pragma once

#include <vector>

#include "config/method.hpp"
#include "core/deskew.hpp"
#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "methods/paper/local_map.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/prediction.hpp"
#include "methods/paper/registration.hpp"
#include "methods/paper/thin_scan.hpp"
#include "surefoot/config.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::benchmarks {

/// Scans after which the map around the robot is whole.
inline constexpr std::size_t kWarmUp = 100;
/// Scans that follow these.
inline constexpr std::size_t kMeasured = 100;

/// The first kWarmUp + kMeasured scans of the walk; simulated once.
[[nodiscard]] const std::vector<Scan>& campus_scans();

/// Scan number kWarmUp, and what the steps before each step make of it; one thread.
struct Moment {
  Config config = method_config("paper");
  PaperParameters paper = own_parameters<PaperParameters>(config);
  Workers workers{1};
  LocalMap map;  ///< of the scans before
  const Scan& scan;
  PreparedScan prepared;
  MotionPrior prior;
  ScanTrajectory predicted;
  std::vector<Eigen::Vector3f> deskewed;
  ThinnedScan thinned;
  Source source;  ///< with the matches and surfaces that the registration ended with
  Registration registration;

  Moment();
};

/// The moment; made once. Throws std::runtime_error if the odometry did not get there.
[[nodiscard]] const Moment& moment();

}  // namespace surefoot::benchmarks
