// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which pose of the reference (truth) belongs to which pose of the estimate.
#pragma once

#include "surefoot/trajectory.hpp"

namespace surefoot::evaluation {

enum class AssociationMethod {
  nearest,      ///< nearest stamp, from the trajectory with fewer poses to the other (evo's rule)
  interpolate,  ///< the reference is interpolated at the estimate's stamps
  index,        ///< pose by pose, for files without stamps; both must have the same length
};

struct AssociationOptions {
  AssociationMethod method = AssociationMethod::nearest;
  double max_difference = 0.01;  ///< [s] nearest: largest difference of two stamps
  double max_gap = 0.5;          ///< [s] interpolate: longest gap of the reference to bridge
  double offset = 0.0;           ///< [s] added to the estimate's stamps
};

/// Poses that belong together, by index; each pose keeps the stamp of its own trajectory.
struct AssociatedTrajectories {
  Trajectory reference;  ///< T_world_body
  Trajectory estimate;   ///< T_map_body
};

/// Throws std::invalid_argument if a trajectory is empty, not in the order of its stamps or holds
/// a pose that is not finite, and std::runtime_error if no pose finds a partner.
[[nodiscard]] AssociatedTrajectories associate(const Trajectory& reference,
                                               const Trajectory& estimate,
                                               const AssociationOptions& options);

}  // namespace surefoot::evaluation
