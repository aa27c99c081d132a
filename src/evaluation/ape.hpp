// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Absolute pose error: how far the estimate is from the reference, pose by pose.
#pragma once

#include <vector>

#include "evaluation/association.hpp"
#include "evaluation/pose_error.hpp"

namespace surefoot::evaluation {

/// Size of T_estimate^-1 T_reference for each pair (the estimate already aligned).
[[nodiscard]] std::vector<double> absolute_errors(const AssociatedTrajectories& pairs,
                                                  Relation relation);
[[nodiscard]] std::vector<SplitError> absolute_split_errors(const AssociatedTrajectories& pairs);

}  // namespace surefoot::evaluation
