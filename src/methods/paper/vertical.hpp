// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// Whether a correspondence may constrain the vertical state: Algorithm 1, line 21. `distance` is
/// |s_i - o| [m].
[[nodiscard]] bool valid_vertical(const Surface& surface, double distance,
                                  const PaperParameters::Vertical& config);

/// Normal equations with the sum of Omega_i, eq. (30), over what they were taken from.
struct VerticalEquations : NormalEquations<3> {
  double observability = 0.0;

  VerticalEquations& operator+=(const VerticalEquations& other) {
    NormalEquations<3>::operator+=(other);
    observability += other.observability;
    return *this;
  }
};

/// H_V and g_V over [dz droll dpitch] about the sensor, eqs. (21)-(33). Looks up surfaces that
/// changed and keeps them in `source`.
[[nodiscard]] VerticalEquations vertical_equations(Source& source, const LocalMap& map,
                                                   const Pose& T_map_lidar,
                                                   const PaperParameters::Vertical& config,
                                                   const Workers& workers);

/// A vertical update no longer than the trust region, its direction kept, eq. (34).
[[nodiscard]] Eigen::Vector3d limit_to_trust_region(const Eigen::Vector3d& delta_V,
                                                    double trust_region);

/// The full-state form of a vertical update, eq. (27).
[[nodiscard]] Twist full_vertical_update(const Eigen::Vector3d& delta_V);

}  // namespace surefoot
