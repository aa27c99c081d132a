// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "odometry/matches.hpp"
#include "odometry/normal_equations.hpp"
#include "odometry/parallel.hpp"
#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// Fills in a registered estimate's covariance and weak directions (weakest first), and makes it
/// `degenerate` if there are any: from the point-to-plane normal equations (24) of all six degrees
/// of freedom at the final pose, on every surface that the matches lie on.
///
/// Point-to-point equations (14) would not do: they claim to know the way along a corridor, since
/// each point is as near to its own nearest neighbour there as anywhere.
void assess(Source& source, const LocalMap& map, const Pose& T_map_lidar, const Config& config,
            const Workers& workers, Estimate& estimate);

/// The weak directions alone, from a scan's point-to-plane normal equations and the weighted sum of
/// its points' squared distances [m^2].
void report_weak_directions(const NormalEquations<6>& equations, double squared_distance,
                            const Pose& T_map_lidar, const Config::Health& config,
                            Estimate& estimate);

/// The covariance of a pose that was only predicted: as far as a registration may correct it.
[[nodiscard]] Matrix6 unregistered_covariance(const Config::Health& config);

}  // namespace surefoot
