// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/observability.hpp"

#include <cmath>

namespace surefoot {

double distance_observability(double distance, const PaperParameters::Vertical& config) {
  const double d_0 = config.near_distance;
  const double beta = config.distance_decay;
  if (distance < d_0) return 1.0;  // [Eq 28]
  return 1.0 / (1.0 + beta * (distance - d_0) * (distance - d_0));
}

double normal_observability(const Eigen::Vector3d& normal,
                            const PaperParameters::Vertical& config) {
  const double eta = std::abs(normal.z());  // [Eq 29]
  return config.normal_power == 1.0 ? eta : std::pow(eta, config.normal_power);
}

double observability(double distance, const Eigen::Vector3d& normal,
                     const PaperParameters::Vertical& config) {
  return distance_observability(distance, config) *
         normal_observability(normal, config);  // [Eq 30]
}

double robust_term(double distance, double residual, const PaperParameters::Vertical& config) {
  if (distance < config.near_distance) {  // [Eq 31]
    return std::abs(residual) <= config.near_gate ? 1.0 : config.near_suppression;
  }
  const double kappa2 = config.kernel_scale * config.kernel_scale;
  return kappa2 / (kappa2 + residual * residual);
}

}  // namespace surefoot
