// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/prediction_error.hpp"

namespace surefoot {

namespace {

// The mean goes over about ten scans, one second: two strides of a trot.
constexpr double kForget = 0.1;

// Share of the prediction's squared error that is left in the pose. Found on the simulated suite's
// tuning recordings: the normalised error squared of a scan's motion is then 0.3 (stairs, wheels)
// to 1.7 (trots) in the median of each; 0.9 is a perfect covariance's.
constexpr double kShare = 0.5;

}  // namespace

void PredictionError::add(const Pose& T_0, const Pose& T_map_lidar) {
  Twist error;
  error << T_map_lidar.translation - T_0.translation,
      so3_log(T_map_lidar.rotation * T_0.rotation.conjugate());
  mean_square_ = (1.0 - kForget) * mean_square_ + kForget * error * error.transpose();
}

Matrix6 PredictionError::deskew_covariance() const { return kShare * mean_square_; }

}  // namespace surefoot
