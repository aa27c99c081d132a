// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/normal_equations.hpp"
#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// Name of a direction's largest part [x y z roll pitch yaw, map axes], in axes turned by the
/// sensor's heading.
[[nodiscard]] std::string name_direction(const Twist& direction, const Pose& T_map_lidar);

/// Names several at right angles, each by its largest part that none before it is named by.
void name_directions(const Pose& T_map_lidar, std::vector<DegenerateDirection>& directions);

/// Names what a registered scan hardly constrains, weakest first, from its point-to-plane normal
/// equations of all six degrees of freedom and the weighted sum of its points' squared distances
/// [m^2]; makes the estimate `degenerate` if there is anything.
///
/// Point-to-point equations would not do: they claim to know the way along a corridor, since each
/// point is as near to its own nearest neighbour there as anywhere.
void report_weak_directions(const NormalEquations<6>& equations, double squared_distance,
                            const Pose& T_map_lidar, const Config::Health& config,
                            Estimate& estimate);

/// The covariance of a pose that was only predicted: as far as a registration may correct it.
[[nodiscard]] Matrix6 unregistered_covariance(const Config::Health& config);

}  // namespace surefoot
