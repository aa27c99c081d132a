// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_attempts.hpp"

#include <initializer_list>
#include <utility>

namespace surefoot {

namespace {

/// The attempts at one scan, and the best so far.
class Attempts {
 public:
  explicit Attempts(KnotPoints& points) : points_(points) {}

  void add(const KnotProblem& problem, const KnotWindow& start, const Annealing& annealing) {
    for (KnotPoints::Point& point : points_.points) point.place = {};
    KnotRegistration found = register_knots(points_, problem, start, annealing);
    const double unseen = problem.config.unseen_weight;
    const bool better = found.solved && found.disagreement(unseen) < best_.disagreement(unseen);
    if (!best_.solved || better) best_ = std::move(found);
  }

  [[nodiscard]] const KnotRegistration& best() const { return best_; }

 private:
  KnotPoints& points_;
  KnotRegistration best_;
};

/// From motions that roll or pitch faster than predicted, as at the foot of a stair; by a kernel
/// that leaves each where it is.
void add_swings(Attempts& attempts, const KnotProblem& problem, const KnotWindow& predicted) {
  Annealing annealing = usual_annealing(problem.config);
  annealing.start = problem.config.swing_kernel;
  const Eigen::Quaterniond& attitude = problem.prior.means[1].rotation;
  const double swing = problem.config.swing;
  for (const int axis : {1, 0}) {
    for (const double rate : {swing, -swing}) {
      Twist velocity = predicted.mean_velocity();
      velocity.tail<3>() += attitude * (rate * Eigen::Vector3d::Unit(axis));
      attempts.add(problem, predicted.at_velocity(velocity), annealing);
    }
  }
}

/// Whether a registration ended worse than usual.
bool is_suspicious(const KnotRegistration& found, const UsualFit& usual,
                   const Config::Knots& config) {
  return !found.converged || found.misfit > config.suspicious * usual.misfit ||
         found.disagreement(config.unseen_weight) > config.suspicious * usual.disagreement;
}

}  // namespace

void UsualFit::learn(const KnotRegistration& found, double rate, const Config::Knots& config) {
  misfit += rate * (found.misfit - misfit);
  disagreement += rate * (found.disagreement(config.unseen_weight) - disagreement);
  misfit_of_seen += rate * (found.misfit_of_seen() - misfit_of_seen);
}

double UsualFit::most_misfit_of_seen(const Config::Knots& config) const {
  return 2.0 * misfit_of_seen + config.misfit_margin;  // [K14]
}

KnotRegistration register_in_attempts(KnotPoints& points, const KnotProblem& problem,
                                      const KnotWindow& predicted, const UsualFit& usual) {
  const Config::Knots& config = problem.config;
  Attempts attempts(points);
  attempts.add(problem, predicted, usual_annealing(config));
  const KnotRegistration& best = attempts.best();
  if (!config.second_attempt || !is_suspicious(best, usual, config)) return best;

  add_swings(attempts, problem, predicted);
  // After a stumble the last velocity foretells nothing.
  const Twist mean = problem.model.mean(problem.prior.means[1].rotation);
  const KnotWindow steady = predicted.at_velocity(mean);
  const Annealing patient = patient_annealing(config);
  attempts.add(problem, predicted, patient);
  attempts.add(problem, steady, patient);
  if (best.solved && best.misfit_of_seen() <= usual.most_misfit_of_seen(config)) return best;

  // A sudden turn: the velocity fluctuates more than it was ever seen to.
  const VelocityModel looser = problem.model.looser(config.looser);
  const KnotProblem loose{problem.map, problem.prior,   looser,
                          config,      problem.workers, problem.begin_step};
  attempts.add(loose, predicted, patient);
  attempts.add(loose, steady, patient);
  return best;
}

}  // namespace surefoot
