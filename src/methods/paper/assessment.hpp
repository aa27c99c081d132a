// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/paper_parameters.hpp"
#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// Fills in a registered estimate's covariance and weak directions (weakest first), and makes it
/// `degenerate` if there are any: from the point-to-plane normal equations (24) of all six degrees
/// of freedom at the final pose, on every surface that the matches lie on.
void assess(Source& source, const LocalMap& map, const Pose& T_map_lidar,
            const PaperParameters::Vertical& config, const Config::Health& health,
            const Workers& workers, Estimate& estimate);

}  // namespace surefoot
