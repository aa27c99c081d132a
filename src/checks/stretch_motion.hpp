// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a stretch was walked: whether it tells anything of times.
#pragma once

#include <optional>

#include "surefoot/trajectory.hpp"

namespace surefoot::checks {

struct StretchMotion {
  double reach_m = 0.0;     ///< from its first pose to the farthest
  double way_m = 0.0;       ///< walked, by steps that noise does not make
  double turned_deg = 0.0;  ///< in all, about any axis, likewise

  /// What sways less is told from noise by nobody.
  [[nodiscard]] bool stood_still() const { return reach_m < 0.1 && turned_deg < 2.0; }
  [[nodiscard]] bool on_the_spot() const { return reach_m < 0.3; }
};

/// Nothing of less than two poses.
[[nodiscard]] std::optional<StretchMotion> motion_along(const Trajectory& path);

}  // namespace surefoot::checks
