// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "surefoot/pose.hpp"

namespace surefoot {

/// How far poses are held back from what their scans say, by the velocity model: an error that goes
/// with the gait. What all of them are held back by alike is no error of the motion between two.
/// docs/method.md.
class HeldBack {
 public:
  /// What all poses are held back by alike.
  enum class Mean { left_out, counted };
  explicit HeldBack(Mean mean) : counts_mean_(mean == Mean::counted) {}

  /// Mean square of this pose's error.
  /// `held_back`: KnotRegistration::held_back_at(), `fluctuation`: VelocityModel::fluctuation(),
  /// both in the map's axes; `rotation`: of the pose. In the map's axes, too.
  [[nodiscard]] Matrix6 covariance(const Twist& held_back, const Twist& fluctuation,
                                   const Eigen::Quaterniond& rotation) const;

  /// Of what a pose is held back by, what a gait held back, and no map's unevenness: the pose is
  /// told so much farther on. In the map's axes, as all.
  [[nodiscard]] Twist let_go(const Twist& held_back, const Eigen::Quaterniond& rotation) const;

  /// `rate`: of the fading mean.
  void learn(const Twist& held_back, const Eigen::Quaterniond& rotation, double rate);

 private:
  [[nodiscard]] Twist shares() const;

  bool counts_mean_;
  // Fading means in the sensor's axes.
  Twist mean_ = Twist::Zero();
  Matrix6 usual_ = Matrix6::Zero();  // square of what differs from that
  // That of the last scan; fading means of its square, and of its product with the one before.
  Twist last_ = Twist::Zero();
  Twist squares_ = Twist::Zero();
  Twist products_ = Twist::Zero();
  int learnt_ = 0;  // scans
};

}  // namespace surefoot
