// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/parallel.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/paper_parameters.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot {

/// Where a registration ended.
struct Registration {
  Pose T_map_lidar;        ///< at mid-scan
  bool converged = false;  ///< the last update was below registration.convergence
  int matches = 0;         ///< correspondences of the last search
  StageReport horizontal{"horizontal"};
  StageReport vertical{"vertical"};
  StageReport coupled{"registration"};

  /// Those that this way of solving has.
  [[nodiscard]] StageReports stages(RegistrationMode mode) const {
    if (mode == RegistrationMode::coupled) return coupled;
    return {horizontal, vertical};
  }
};

/// The largest radius in which register_scan searches the map [m].
[[nodiscard]] double max_search_radius(const PaperParameters::Registration& config);

/// Registers a deskewed scan to the map: Algorithm 1, lines 8-30. `T_0` is the predicted mid-scan
/// pose; it ends where fewer than `min_matches` points have a correspondence. Leaves the last
/// matches and surfaces in `source`.
[[nodiscard]] Registration register_scan(Source& source, const LocalMap& map, const Pose& T_0,
                                         const PaperParameters& config, int min_matches,
                                         const Workers& workers, const StepObserver& begin_step);

}  // namespace surefoot
