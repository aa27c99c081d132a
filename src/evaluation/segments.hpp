// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The error over stretches of fixed lengths, as the KITTI odometry benchmark defines it.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/association.hpp"

namespace surefoot::evaluation {

/// Mean errors over all stretches of one length.
struct SegmentError {
  double length = 0.0;               ///< [m] along the reference
  std::size_t count = 0;             ///< stretches; with 0 the errors are 0
  double translation_percent = 0.0;  ///< |t| of the error per length, %
  double rotation_deg_per_m = 0.0;   ///< angle of the error per length, deg/m
};

struct SegmentErrors {
  std::vector<SegmentError> by_length;
  SegmentError all;  ///< over all stretches of all lengths; its `length` is 0
};

/// 100, 200 .. 800 m as KITTI has them; for a reference shorter than 200 m a tenth of that, for
/// one shorter than 20 m a hundredth.
[[nodiscard]] std::vector<double> segment_lengths_for(double path_length);

/// From every tenth pose to the first pose that is farther than the length along the reference.
/// Throws std::invalid_argument if a length is not finite or not positive.
[[nodiscard]] SegmentErrors segment_errors(const AssociatedTrajectories& pairs,
                                           const std::vector<double>& lengths);

}  // namespace surefoot::evaluation
