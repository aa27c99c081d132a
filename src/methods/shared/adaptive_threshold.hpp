// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "surefoot/pose.hpp"

namespace surefoot {

/// How far a registration was from its prediction [m]: the shift plus what the turn moves at
/// `max_range` [m]; KISS-ICP's eq. (7).
[[nodiscard]] double model_error(const Pose& deviation, double max_range);

/// KISS-ICP's adaptive threshold sigma: the RMS of the deviations that exceed `min_motion` [m],
/// with one deviation of `initial` [m] to begin with.
class AdaptiveThreshold {
 public:
  AdaptiveThreshold(double initial, double min_motion, double max_range)
      : min_motion_(min_motion), max_range_(max_range), squares_(initial * initial) {}

  [[nodiscard]] double threshold() const;
  void add(const Pose& deviation);

 private:
  double min_motion_;
  double max_range_;
  double squares_;
  int samples_ = 1;
};

}  // namespace surefoot
