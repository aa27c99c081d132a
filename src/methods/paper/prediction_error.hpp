// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "surefoot/pose.hpp"

namespace surefoot {

/// How far the motion prior's predictions were off lately.
///
/// A scan is deskewed by its prediction. Where the body swings faster than scans come, that is
/// wrong by as much as the prediction is, all of a scan's points share the error, and no residual
/// tells it: at a trot, covariances from residuals alone are 30 to 70 times too small.
class PredictionError {
 public:
  /// A scan predicted at T_0 was registered at T_map_lidar.
  void add(const Pose& T_0, const Pose& T_map_lidar);
  /// What deskewing by such predictions adds to a pose's covariance, ordered as
  /// Estimate::covariance.
  [[nodiscard]] Matrix6 deskew_covariance() const;

 private:
  Matrix6 mean_square_ = Matrix6::Zero();  // fading mean of e e^T, map axes about the sensor
};

}  // namespace surefoot
