// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Uniform cubic B-splines: C2 everywhere, local, and as cheap as a polynomial.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace surefoot::simulation {

/// Weights of the four controls about a place between two knots, `u` in [0, 1] from the first.
[[nodiscard]] inline std::array<double, 4> bspline_weights(double u) {
  const double v = 1.0 - u;
  const double w0 = v * v * v / 6.0;
  const double w1 = (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0;
  const double w3 = u * u * u / 6.0;
  return {w0, w1, 1.0 - w0 - w1 - w3, w3};
}

/// A curve in `Channels` dimensions over the knots 0, step, 2 step, ... The curve does not pass
/// through its control points: it is their smoothing. Outside the knots it stays at its end.
template <int Channels>
class CubicBSpline {
 public:
  using Value = Eigen::Matrix<double, Channels, 1>;
  // Fixed-size arrays of doubles need no aligned vector since C++17.
  using Controls = std::vector<Value>;

  CubicBSpline() = default;
  /// @throws std::invalid_argument for fewer than four controls or a step that is not positive.
  CubicBSpline(Controls controls, double step) : controls_(std::move(controls)), step_(step) {
    if (controls_.size() < 4) throw std::invalid_argument("a cubic B-spline needs four controls");
    if (!(step_ > 0.0)) throw std::invalid_argument("the knots' step must be positive");
  }

  /// Parameter of the last knot; the first is 0.
  [[nodiscard]] double end() const { return step_ * static_cast<double>(controls_.size() - 3); }

  [[nodiscard]] Value operator()(double parameter) const {
    const auto [first, u] = locate(parameter);
    const auto [w0, w1, w2, w3] = bspline_weights(u);
    return w0 * controls_[first] + w1 * controls_[first + 1] + w2 * controls_[first + 2] +
           w3 * controls_[first + 3];
  }

  /// First derivative with respect to the parameter.
  [[nodiscard]] Value derivative(double parameter) const {
    const auto [first, u] = locate(parameter);
    const double v = 1.0 - u;
    const Value sum =
        -0.5 * v * v * controls_[first] + (1.5 * u * u - 2.0 * u) * controls_[first + 1] +
        (0.5 + u - 1.5 * u * u) * controls_[first + 2] + 0.5 * u * u * controls_[first + 3];
    return sum / step_;
  }

 private:
  [[nodiscard]] std::pair<std::size_t, double> locate(double parameter) const {
    const auto segments = static_cast<double>(controls_.size() - 3);
    const double position = std::clamp(parameter / step_, 0.0, segments);
    const auto first = std::min(static_cast<std::size_t>(position), controls_.size() - 4);
    return {first, position - static_cast<double>(first)};
  }

  Controls controls_;
  double step_ = 1.0;
};

}  // namespace surefoot::simulation
