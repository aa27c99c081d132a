// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "surefoot/estimate.hpp"

namespace surefoot {

/// How far a pose may have gone along directions that nothing holds. The scans there tell of no
/// motion, whether there is one or not: what was known of the velocity is not known any more.
struct Drift {
  Matrix6 covariance = Matrix6::Zero();  ///< to be added to the registration's
  double wrong_probability = 0.0;        ///< that this alone is more than 0.2 m or 3 degrees
};

/// @param weak the scan's weak directions, as the estimate names them
/// @param distance [m] RMS of the matches', by which their rotations are scaled
/// @param elapsed [s] since a scan held all directions
[[nodiscard]] Drift drift_along(const std::vector<DegenerateDirection>& weak, double distance,
                                double elapsed);

}  // namespace surefoot
