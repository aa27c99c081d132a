// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/knots/knot_points.hpp"
#include "methods/knots/knot_prior.hpp"
#include "methods/knots/knot_window.hpp"
#include "methods/knots/surfel_map.hpp"
#include "methods/knots/velocity_model.hpp"
#include "surefoot/config.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot {

/// What all registrations of a scan have in common.
struct KnotProblem {
  const SurfelMap& map;
  const KnotPrior& prior;
  const VelocityModel& model;
  const Config::Knots& config;
  const Workers& workers;
  const StepObserver& begin_step;
};

/// How the robust kernel narrows.
struct Annealing {
  double start;  ///< [m] its first scale
  double decay;  ///< factor on its scale per iteration
  int max_iterations;
};

[[nodiscard]] Annealing usual_annealing(const Config::Knots& config);
/// From farther away and in smaller steps, for what the usual one loses.
[[nodiscard]] Annealing patient_annealing(const Config::Knots& config);

/// Where the registration of a window ended.
struct KnotRegistration {
  KnotWindow window;
  BandedSystem::Covariance covariance;  ///< of the knots, as they were weighed; valid if solved
  /// Of the knots, were every residual counted in full and a cloud by its worth; valid if solved.
  BandedSystem::Covariance full_covariance;
  /// How far the knots are held back from where residuals counted in full would have them, by the
  /// last scan and the velocity model; valid if solved.
  std::vector<Twist> held_back;
  bool solved = false;  ///< every step had a finite solution
  bool converged = false;
  int iterations = 0;
  int settling = 0;  ///< of them, those whose kernel had narrowed to its end
  int matches = 0;
  int clouds = 0;                      ///< of the matches, those that are no plane and no pole
  double misfit = 1.0;                 ///< 0: every point lies on its surfel; 1: no point near any
  double unseen = 1.0;                 ///< share of the points where the map has no surfel
  NormalEquations<6> rigid;            ///< of the scan as one rigid body, at the last iteration
  Matrix6 doubtful = Matrix6::Zero();  ///< of its H, what clouds claim and are not worth
  double squared_distance = 0.0;       ///< weighted sum of |s|^2 over the matches
  std::vector<double> disagreements;   ///< disagreement() of each segment, at the last iteration
  /// SegmentSums::neighbours of each segment, likewise.
  std::vector<std::array<Twist, 3>> neighbours;

  /// Information of the window's last two knots, all others integrated out; valid if solved.
  Matrix12 last_two = Matrix12::Zero();

  /// The misfit, with little weight on the points where the map has no surfel.
  [[nodiscard]] double disagreement(double unseen_weight) const;
  /// The misfit of the points where the map has a surfel; 1 if there are none.
  [[nodiscard]] double misfit_of_seen() const;
  /// Of the pose at an instant of the window, residuals counted in full; valid if solved.
  [[nodiscard]] Matrix6 covariance_at(std::int64_t instant_ns) const;
  [[nodiscard]] Twist held_back_at(std::int64_t instant_ns) const;
};

/// Asked after every iteration once the kernel has narrowed: whether to go no further.
/// @param before the disagreement of the iteration before
using Abandon = std::function<bool(const KnotRegistration& so_far, double before)>;

/// Whether what disagrees so much, and so much an iteration before, is not going to end better than
/// what disagrees least.
[[nodiscard]] bool is_hopeless(double disagreement, double before, double least);

/// Finds the knots that explain a scan best: residuals to the map's surfels, the prior of the first
/// two knots, and the velocity model.
/// @param start the knots, at first
///
/// The problem is far from convex, since a point changes its surfel as it moves. So the first
/// iterations trust neither far residuals' smallness nor the surfels much: the kernel is wide, the
/// noise as large, and both narrow from step to step; the velocity model, and not the surfels,
/// shapes the motion at first.
/// @param abandon if there is one: where it says so the registration ends, unsolved
[[nodiscard]] KnotRegistration register_knots(KnotPoints& points, const KnotProblem& problem,
                                              const KnotWindow& start, const Annealing& annealing,
                                              const Abandon& abandon = {});

}  // namespace surefoot
