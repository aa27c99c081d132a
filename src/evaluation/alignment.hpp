// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Bringing the estimate into the reference's frame before absolute errors are taken.
#pragma once

#include <cstddef>

#include "evaluation/association.hpp"

namespace surefoot::evaluation {

enum class AlignmentMethod {
  kNone,
  kOrigin,          ///< the first poses coincide
  kYawTranslation,  ///< least squares over positions; roll and pitch stay as estimated
  kRigid,           ///< least squares over positions, SE(3) (Umeyama 1991)
  kPoses,           ///< the same over positions and orientations, a radian counting as a metre
  kSimilarity,      ///< least squares over positions with scale, Sim(3)
  kScale,           ///< only the scale of Sim(3); rotation and origin stay as estimated
};

/// x -> pose * (scale * x). For a pose, the scale changes its translation alone.
struct Alignment {
  Pose pose;  ///< T_world_map
  double scale = 1.0;
};

/// The alignment of the estimate to the reference, found from the first `poses` pairs (0: all).
/// Throws std::runtime_error if the positions do not determine it (all in one place; for kRigid
/// and kSimilarity also all on one line). kPoses is always determined: on a straight way, where
/// positions leave the turn about it open, orientations decide.
[[nodiscard]] Alignment find_alignment(const AssociatedTrajectories& pairs, AlignmentMethod method,
                                       std::size_t poses = 0);

[[nodiscard]] Trajectory aligned(const Trajectory& trajectory, const Alignment& alignment);

}  // namespace surefoot::evaluation
