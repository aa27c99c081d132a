// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Bringing the estimate into the reference's frame before absolute errors are taken.
#pragma once

#include <cstddef>

#include "evaluation/association.hpp"

namespace surefoot::evaluation {

enum class AlignmentMethod {
  none,
  origin,           ///< the first poses coincide
  yaw_translation,  ///< least squares over positions; roll and pitch stay as estimated
  rigid,            ///< least squares over positions, SE(3) (Umeyama 1991)
  poses,            ///< the same over positions and orientations, a radian counting as a metre
  similarity,       ///< least squares over positions with scale, Sim(3)
  scale,            ///< only the scale of Sim(3); rotation and origin stay as estimated
};

/// x -> pose * (scale * x). For a pose, the scale changes its translation alone.
struct TrajectoryAlignment {
  Pose pose;  ///< T_world_map
  double scale = 1.0;
};

/// The alignment of the estimate to the reference, found from the first `poses` pairs (0: all).
/// Throws std::runtime_error if the positions do not determine it (all in one place; for rigid
/// and similarity also all on one line). poses is always determined: on a straight way, where
/// positions leave the turn about it open, orientations decide.
[[nodiscard]] TrajectoryAlignment find_alignment(const AssociatedTrajectories& pairs,
                                                 AlignmentMethod method, std::size_t poses = 0);

/// Whether the positions hardly decide a turn, as those of a nearly straight way, of a stay, or of
/// one no wider than what is left after alignment: then noise does, and rotation errors are any. So
/// also where they do not decide it at all. Only where positions alone are asked.
[[nodiscard]] bool leaves_turn_open(const AssociatedTrajectories& pairs, AlignmentMethod method,
                                    std::size_t poses = 0);

[[nodiscard]] Trajectory aligned(const Trajectory& trajectory,
                                 const TrajectoryAlignment& alignment);

}  // namespace surefoot::evaluation
