// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/knots/banded_system.hpp"
#include "methods/knots/knot_window.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// What is expected of the sensor's velocity from knot to knot, learnt while it walks.
///
/// The velocity fluctuates about a slowly changing mean and is pulled back to it (an
/// Ornstein-Uhlenbeck process):
///   v_{k+1} - m = phi (v_k - m) + noise,  phi = exp(-step / correlation_time),
/// with noise variance s^2 (1 - phi^2), so that v fluctuates by s. A trotting body swings by as
/// much as 1 rad/s about a walk of constant speed, a wheeled one hardly at all: s comes from the
/// data, per axis (horizontal, vertical, tilt, heading).
class VelocityModel {
 public:
  /// `fluctuation`: s before anything was learnt, as fluctuation().
  VelocityModel(const Config::Knots& config, const Twist& fluctuation);
  /// With an ordinary trot's fluctuation.
  explicit VelocityModel(const Config::Knots& config);

  /// The first velocity that was seen, in the map's axes, of a sensor turned by `rotation`.
  void begin(const Twist& velocity, const Eigen::Quaterniond& rotation);

  /// The velocity one step after `velocity` (map axes), as expected of a sensor turned by
  /// `rotation`.
  [[nodiscard]] Twist next(const Twist& velocity, const Eigen::Quaterniond& rotation,
                           double step) const;
  /// Adds the terms that tie the window's knots together to its normal equations; they need the
  /// knots' present values, and the rotation that next() was given when they were predicted.
  void add_to(BandedSystem& system, const KnotWindow& window,
              const Eigen::Quaterniond& rotation) const;
  /// Learns from a registered window: mean velocity and, by a step of expectation maximisation,
  /// the fluctuation s. What `is_sure` tells of another mean where it is far off.
  void learn(const KnotWindow& window, const BandedSystem::Covariance& covariance,
             const Eigen::Quaterniond& rotation, bool is_sure = true);

  /// The same, but that the velocity may fluctuate `factor` times as much.
  [[nodiscard]] VelocityModel looser(double factor) const;

  /// The mean velocity, in the map's axes for a sensor turned by `rotation`.
  [[nodiscard]] Twist mean(const Eigen::Quaterniond& rotation) const;

  /// [m/s]
  [[nodiscard]] double mean_speed() const { return mean_.head<3>().norm(); }
  /// 1 for who walks, the less the slower, 0 for who stands.
  [[nodiscard]] double walking() const;

  /// s: [m/s] along x, y, z, [rad/s] about them, map axes.
  [[nodiscard]] Twist fluctuation() const { return variance_.cwiseSqrt(); }

 private:
  [[nodiscard]] double pull(double step) const;
  [[nodiscard]] Twist squares_of(const KnotWindow& window,
                                 const BandedSystem::Covariance& covariance,
                                 const Eigen::Quaterniond& rotation) const;

  Config::Knots config_;
  Twist mean_ = Twist::Zero();  // LiDAR frame
  Twist variance_;              // s^2
  int learnt_ = 0;
};

}  // namespace surefoot
