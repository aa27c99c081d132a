// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "surefoot/pose.hpp"

namespace surefoot {

/// A pose's covariance in the map's axes, by what the errors of the tuning seeds' 1 m motions were
/// found to be beyond their covariances (docs/method.md): more along the way and in roll about it
/// than across, and more where the velocity fluctuates.
///
/// `velocity`: the mean one of the scan, `fluctuation`: VelocityModel::fluctuation(), both in the
/// map's axes.
[[nodiscard]] Matrix6 calibrated(const Matrix6& covariance, const Twist& velocity,
                                 const Twist& fluctuation);

}  // namespace surefoot
