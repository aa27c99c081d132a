// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/velocity_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot {

namespace {

// Before anything was learnt: an ordinary trot's.
const Twist kFirstFluctuation = (Twist() << 0.3, 0.3, 0.3, 0.6, 0.6, 0.4).finished();

// However smoothly it rolls, a sensor's velocity may change; the model is never infinitely stiff.
constexpr double kLeastFluctuation = 0.003;  // [m/s, rad/s]

// A scan's mean velocity that is off by more standard deviations than this is another mean's: who
// drives off leaves a fading one behind.
constexpr double kAnother = 4.0;

constexpr double kWalks = 0.2;  // [m/s] of who does not stand

/// How the deviation e_k = (v_{k+1} - m) - phi (v_k - m) depends on knots k, k + 1 and k + 2: the
/// same factor for each axis. For rotations this takes the knots' turns to be small.
std::array<double, 3> slopes_of(const KnotWindow& window, std::size_t k, double phi) {
  const double before = window.duration(k), after = window.duration(k + 1);
  return {phi / before, -1.0 / after - phi / before, 1.0 / after};
}

}  // namespace

VelocityModel::VelocityModel(const Config::Knots& config, const Twist& fluctuation)
    : config_(config), variance_(fluctuation.cwiseAbs2()) {}

VelocityModel::VelocityModel(const Config::Knots& config)
    : VelocityModel(config, kFirstFluctuation) {}

void VelocityModel::begin(const Twist& velocity, const Eigen::Quaterniond& rotation) {
  mean_ = rotated(rotation.conjugate(), velocity);
  learnt_ = 1;
}

VelocityModel VelocityModel::looser(double factor) const {
  VelocityModel model = *this;
  model.variance_ *= factor * factor;
  return model;
}

Twist VelocityModel::mean(const Eigen::Quaterniond& rotation) const {
  return rotated(rotation, mean_);
}

double VelocityModel::walking() const { return std::min(mean_speed() / kWalks, 1.0); }

double VelocityModel::pull(double step) const { return std::exp(-step / config_.correlation_time); }

Twist VelocityModel::next(const Twist& velocity, const Eigen::Quaterniond& rotation,
                          double step) const {
  const Twist m = mean(rotation);
  return m + pull(step) * (velocity - m);  // [K6]
}

void VelocityModel::add_to(BandedSystem& system, const KnotWindow& window,
                           const Eigen::Quaterniond& rotation) const {
  for (std::size_t k = 0; k + 2 < window.knots.size(); ++k) {
    const double phi = pull(window.duration(k + 1));
    const Twist e =
        window.velocity(k + 1) - next(window.velocity(k), rotation, window.duration(k + 1));
    const Twist information = (variance_ * (1.0 - phi * phi)).cwiseInverse();  // [K7]
    const auto a = slopes_of(window, k, phi);
    for (std::size_t i = 0; i < 3; ++i) {
      system.add(k + i, a[i] * information.cwiseProduct(e));
      for (std::size_t j = 0; j <= i; ++j) {
        system.add(k + i, k + j, (a[i] * a[j] * information).asDiagonal());
      }
    }
  }
}

/// Expectation of e^2 / (1 - phi^2), given the scan, in the mean of its segments.
Twist VelocityModel::squares_of(const KnotWindow& window,
                                const BandedSystem::Covariance& covariance,
                                const Eigen::Quaterniond& rotation) const {
  const double phi = pull(window.step);
  Twist squares = Twist::Zero();
  for (std::size_t k = 1; k + 2 < window.knots.size(); ++k) {
    const Twist e = window.velocity(k + 1) - next(window.velocity(k), rotation, window.step);
    squares += e.cwiseAbs2();
    const auto a = slopes_of(window, k, phi);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        squares += a[i] * a[j] * covariance(k + i, k + j).diagonal();
      }
    }
  }
  return squares / ((1.0 - phi * phi) * static_cast<double>(window.segments() - 1));
}

void VelocityModel::learn(const KnotWindow& window, const BandedSystem::Covariance& covariance,
                          const Eigen::Quaterniond& rotation, bool is_sure) {
  if (window.segments() > 1) {
    const Twist seen = alike(squares_of(window, covariance, rotation));
    variance_ += config_.learning_rate * (seen - variance_);  // [K15]
    variance_ = variance_.cwiseMax(kLeastFluctuation * kLeastFluctuation);
  }
  ++learnt_;
  const Twist seen = rotated(window.knots.back().rotation.conjugate(), window.mean_velocity());
  // [K16] The mean of all scans until they are more than the fading mean's memory.
  const Twist off = seen - mean_;
  Twist share = Twist::Constant(std::max(config_.mean_rate, 1.0 / learnt_));
  if (is_sure) {
    const Twist squares = alike(off.cwiseAbs2()).cwiseQuotient(variance_).cwiseMax(1e-9);
    share = share.cwiseMax(Twist::Ones() - kAnother * kAnother * squares.cwiseInverse());
  }
  mean_ += share.cwiseProduct(off);
}

}  // namespace surefoot
