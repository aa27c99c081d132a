// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One number for the difference of two poses.
#pragma once

#include <string_view>

#include "surefoot/pose.hpp"

namespace surefoot::evaluation {

/// Sizes of an error pose E; zero for the identity.
enum class Relation {
  translation,     ///< |t|, m
  rotation_angle,  ///< angle of the rotation, deg
  rotation_part,   ///< Frobenius norm of R - I
  full,            ///< Frobenius norm of the 4x4 matrix E - I
};

[[nodiscard]] double size_of(const Pose& error, Relation relation);
/// "m", "deg" or "" for a norm.
[[nodiscard]] std::string_view unit_of(Relation relation);

/// An absolute error, split at the vertical z of the reference's world frame.
struct SplitError {
  double horizontal;  ///< [m]
  double vertical;    ///< [m]
  double tilt;        ///< [deg] between the two bodies' vertical axes: roll and pitch together
  double yaw;         ///< [deg] turn about the vertical, in [0, 180]
};
[[nodiscard]] SplitError split_error(const Pose& reference, const Pose& estimate);

[[nodiscard]] double degrees(double radians);

}  // namespace surefoot::evaluation
