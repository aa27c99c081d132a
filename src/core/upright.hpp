// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace surefoot {

/// Which way is up in a cloud (LiDAR frame [m]) where no ground is seen: walls and trunks stand
/// upright, floors, landings and treads lie level. Of all directions nearer than `max_tilt_deg` to
/// the LiDAR's z axis the one along which most of both is seen; none if it does not stand out.
/// @return a unit vector; a few degrees off
[[nodiscard]] std::optional<Eigen::Vector3d> find_up(const std::vector<Eigen::Vector3f>& points,
                                                     double max_tilt_deg);

}  // namespace surefoot
