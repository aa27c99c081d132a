// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// The coupled 6-DoF problem of eq. (4), which the paper argues against: H and g over
/// [dx dy dz droll dpitch dyaw] about the sensor, of point-to-point residuals with the weight of
/// eq. (19), or of point-to-plane residuals on every surface with the same weight.
[[nodiscard]] NormalEquations<6> coupled_equations(Source& source, const LocalMap& map,
                                                   const Pose& T_map_lidar,
                                                   const PaperParameters& config,
                                                   const Workers& workers);

}  // namespace surefoot
