// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/normal_equations.hpp"

namespace surefoot {

/// A least-squares problem about one state.
template <int Size>
struct Linearisation {
  NormalEquations<Size> equations;
  double cost = 0.0;  // half the sum of losses
  Linearisation& operator+=(const Linearisation& other) {
    equations += other.equations;
    cost += other.cost;
    return *this;
  }
};

/// Where the minimiser ended.
template <int Size, typename State>
struct Minimum {
  State state;
  Linearisation<Size> here;  ///< at the state
  int steps = 0;             ///< accepted
  bool converged = false;    ///< ended by a tolerance, not by the number of steps
};

/// Ceres' defaults.
namespace ceres_default {
constexpr double kFirstRadius = 1e4;
constexpr double kMaxRadius = 1e16;
constexpr double kMinDiagonal = 1e-6;
constexpr double kMaxDiagonal = 1e32;
constexpr double kMinDecrease = 1e-3;         // of the predicted decrease, to accept a step
constexpr double kFunctionTolerance = 1e-6;   // of the cost
constexpr double kParameterTolerance = 1e-8;  // of the parameters' norm
constexpr double kGradientTolerance = 1e-10;
}  // namespace ceres_default

/// One Levenberg-Marquardt step: columns are scaled once and for all, then damped by their own
/// diagonal over the trust region's radius.
template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, 1> damped_step(
    const NormalEquations<Size>& equations, const Eigen::Matrix<double, Size, 1>& scale,
    double radius) {
  using namespace ceres_default;
  Eigen::Matrix<double, Size, Size> H = scale.asDiagonal() * equations.H * scale.asDiagonal();
  H.diagonal() += H.diagonal().cwiseMax(kMinDiagonal).cwiseMin(kMaxDiagonal) / radius;
  const Eigen::Matrix<double, Size, 1> scaled_g = scale.cwiseProduct(equations.g);
  return -scale.cwiseProduct(H.ldlt().solve(scaled_g));
}

/// Ceres' trust-region minimiser with its default options: Levenberg-Marquardt, at most `max_steps`
/// steps.
///
/// linearise(state) gives the problem about a state, moved(state, delta) the state after a step,
/// parameter_norm(state) the norm of Ceres' parameters (unit quaternions and translations).
template <int Size, typename State, typename Linearise, typename Moved, typename ParameterNorm>
[[nodiscard]] Minimum<Size, State> minimise(const State& start, int max_steps,
                                            const Linearise& linearise, const Moved& moved,
                                            const ParameterNorm& parameter_norm) {
  using namespace ceres_default;
  using Vector = Eigen::Matrix<double, Size, 1>;
  Minimum<Size, State> result{start, linearise(start)};
  Linearisation<Size>& here = result.here;
  const Vector scale = (1.0 + here.equations.H.diagonal().array().sqrt()).inverse();
  double radius = kFirstRadius;
  double shrink = 2.0;
  for (int step = 0; step < max_steps && !result.converged; ++step) {
    const Vector delta = damped_step(here.equations, scale, radius);
    if (!delta.allFinite()) break;
    const double predicted =
        -delta.dot(here.equations.g) - 0.5 * delta.dot(here.equations.H * delta);
    const State candidate = moved(result.state, delta);
    const Linearisation<Size> there = linearise(candidate);
    const double decrease = here.cost - there.cost;
    const bool still =
        delta.norm() <= kParameterTolerance * (parameter_norm(result.state) + kParameterTolerance);
    result.converged = still || std::abs(decrease) <= kFunctionTolerance * here.cost;
    if (result.converged) break;  // as Ceres: that step is not taken any more
    if (predicted > 0.0 && decrease > kMinDecrease * predicted) {
      const double ratio = decrease / predicted;
      radius =
          std::min(kMaxRadius, radius / std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3)));
      shrink = 2.0;
      result.state = candidate;
      here = there;
      ++result.steps;
      result.converged = here.equations.g.template lpNorm<Eigen::Infinity>() <= kGradientTolerance;
    } else {
      radius /= shrink;
      shrink *= 2.0;
    }
  }
  return result;
}

}  // namespace surefoot
