// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/adaptive_threshold.hpp"

#include <cmath>

#include "geometry/se3.hpp"

namespace surefoot {

double model_error(const Pose& deviation, double max_range) {
  const double angle = turn_angle(deviation);
  return deviation.translation.norm() + 2.0 * max_range * std::sin(0.5 * angle);
}

double AdaptiveThreshold::threshold() const { return std::sqrt(squares_ / samples_); }

void AdaptiveThreshold::add(const Pose& deviation) {
  const double error = model_error(deviation, max_range_);
  if (error <= min_motion_) return;
  squares_ += error * error;
  ++samples_;
}

}  // namespace surefoot
