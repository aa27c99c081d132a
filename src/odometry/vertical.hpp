// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "odometry/matches.hpp"
#include "odometry/normal_equations.hpp"
#include "odometry/parallel.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// Whether a correspondence may constrain the vertical state: Algorithm 1, line 21. `distance` is
/// |s_i - o| [m].
[[nodiscard]] bool valid_vertical(const Surface& surface, double distance,
                                  const Config::Vertical& config);

/// H_V and g_V over [dz droll dpitch] about the sensor, eqs. (21)-(33). Looks up surfaces that
/// changed and keeps them in `source`.
[[nodiscard]] NormalEquations<3> vertical_equations(Source& source, const LocalMap& map,
                                                    const Pose& T_map_lidar,
                                                    const Config::Vertical& config,
                                                    const Workers& workers);

/// A vertical update no longer than the trust region, its direction kept, eq. (34).
[[nodiscard]] Eigen::Vector3d limit_to_trust_region(const Eigen::Vector3d& delta_V,
                                                    double trust_region);

/// The full-state form of a vertical update, eq. (27).
[[nodiscard]] Twist full_vertical_update(const Eigen::Vector3d& delta_V);

}  // namespace surefoot
