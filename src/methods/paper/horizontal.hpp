// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// H_H and g_H over [dx dy dyaw] about the sensor, eqs. (13)-(19).
[[nodiscard]] NormalEquations<3> horizontal_equations(const Source& source, const Pose& T_map_lidar,
                                                      const PaperParameters::Horizontal& config,
                                                      const Workers& workers);

/// The full-state form of a horizontal update, eq. (17).
[[nodiscard]] Twist full_horizontal_update(const Eigen::Vector3d& delta_H);

}  // namespace surefoot
