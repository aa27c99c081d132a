// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where the run ended, and how much of it there is.
#pragma once

#include <vector>

#include "evaluation/association.hpp"

namespace surefoot::evaluation {

/// Length of the path up to each pose [m], starting with 0; empty for no poses.
[[nodiscard]] std::vector<double> path_lengths(const Trajectory& trajectory);

/// The position error of the last pair after the first pair has been made to coincide.
struct EndDrift {
  double path_length = 0.0;  ///< [m] of the reference over the pairs
  double total = 0.0;        ///< [m]
  double horizontal = 0.0;   ///< [m] in the reference's world frame
  double vertical = 0.0;     ///< [m] signed: positive if the estimate ends too high
  double percent = 0.0;      ///< total in % of path_length; 0 for who did not move
};
/// From the error's three parts and the length of the reference's path.
[[nodiscard]] EndDrift drift_of(const Eigen::Vector3d& error, double path_length);
[[nodiscard]] EndDrift end_drift(const AssociatedTrajectories& pairs);

/// Share of the reference's time [0, 1] during which there is an estimate. Between two poses of the
/// estimate there is one, unless they are farther apart than three times the usual step; 0: their
/// median step, which knows nothing of poses that are missing everywhere.
/// `offset` [s] is added to the estimate's stamps. A reference of no duration is covered or not.
[[nodiscard]] double coverage(const Trajectory& reference, const Trajectory& estimate,
                              double offset, std::int64_t usual_step_ns = 0);
/// Of those that go forwards; 0 without any.
[[nodiscard]] std::int64_t median_step_ns(const std::vector<std::int64_t>& stamps_ns);

}  // namespace surefoot::evaluation
