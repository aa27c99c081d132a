// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The weights of the vertical stage, section 3.4.
#pragma once

#include <Eigen/Core>

#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// gamma(d): trust in a point `distance` [m] from the sensor, eq. (28).
[[nodiscard]] double distance_observability(double distance,
                                            const PaperParameters::Vertical& config);
/// eta(n): how well a surface of this unit normal constrains the vertical state, eq. (29).
[[nodiscard]] double normal_observability(const Eigen::Vector3d& normal,
                                          const PaperParameters::Vertical& config);
/// Omega = gamma * eta, eq. (30).
[[nodiscard]] double observability(double distance, const Eigen::Vector3d& normal,
                                   const PaperParameters::Vertical& config);
/// rho: robust term of a point-to-plane residual [m], a gate near the sensor and Cauchy's kernel
/// farther away, eq. (31).
[[nodiscard]] double robust_term(double distance, double residual,
                                 const PaperParameters::Vertical& config);

}  // namespace surefoot
