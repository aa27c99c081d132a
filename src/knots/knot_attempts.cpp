// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/knot_attempts.hpp"

#include <initializer_list>
#include <utility>

namespace surefoot {

namespace {

// A registration whose misfit or disagreement is so many times the usual is tried again.
constexpr double kSuspicious = 1.25;
// Beyond twice the usual and this, it is wrong.
constexpr double kMisfitMargin = 0.15;

// At the foot of a stair the body pitches by some degrees within a scan: starts that swing by so
// much [rad/s], and a kernel [m] that leaves each where it is.
constexpr double kSwing = 2.0;
constexpr double kNarrow = 0.2;

// What would still be lost, with so many times the usual fluctuation.
constexpr double kLooser = 3.0;

// Among attempts, a point where the map has no surfel counts as this: who climbs a stair sees much
// that is new, and a wrong pose that brings some of it near an old wall must not win by that.
constexpr double kUnseen = 0.2;

/// How badly the scan disagrees with what of the map it sees.
double disagreement(const KnotRegistration& found) {
  return found.misfit - (1.0 - kUnseen) * found.unseen;
}

/// The attempts at one scan, and the best so far.
class Attempts {
 public:
  Attempts(KnotPoints& points, const KnotProblem& problem) : points_(points), problem_(problem) {}

  void add(const KnotWindow& start, const VelocityModel& model, const Annealing& annealing) {
    for (KnotPoints::Point& point : points_.points) point.place = {};
    KnotRegistration found =
        register_knots(points_, problem_.map, start, problem_.prior, model, annealing,
                       problem_.config, problem_.workers, problem_.begin_step);
    const bool better = found.solved && disagreement(found) < disagreement(best_);
    if (!best_.solved || better) best_ = std::move(found);
  }

  [[nodiscard]] const KnotRegistration& best() const { return best_; }

 private:
  KnotPoints& points_;
  const KnotProblem& problem_;
  KnotRegistration best_;
};

/// From motions that roll or pitch faster than predicted.
void add_swings(Attempts& attempts, const KnotProblem& problem, const KnotWindow& predicted) {
  Annealing annealing = usual_annealing(problem.config);
  annealing.start = kNarrow;
  const Eigen::Quaterniond& attitude = problem.prior.means[1].rotation;
  for (const int axis : {1, 0}) {
    for (const double rate : {kSwing, -kSwing}) {
      Twist velocity = predicted.mean_velocity();
      velocity.tail<3>() += attitude * (rate * Eigen::Vector3d::Unit(axis));
      attempts.add(predicted.at_velocity(velocity), problem.model, annealing);
    }
  }
}

}  // namespace

void UsualFit::learn(const KnotRegistration& found, double rate) {
  misfit += rate * (found.misfit - misfit);
  disagreement += rate * (surefoot::disagreement(found) - disagreement);
}

double UsualFit::most_misfit() const { return 2.0 * misfit + kMisfitMargin; }

KnotRegistration register_in_attempts(KnotPoints& points, const KnotProblem& problem,
                                      const KnotWindow& predicted, const UsualFit& usual) {
  Attempts attempts(points, problem);
  attempts.add(predicted, problem.model, usual_annealing(problem.config));
  const KnotRegistration& best = attempts.best();
  const bool suspicious = !best.converged || best.misfit > kSuspicious * usual.misfit ||
                          disagreement(best) > kSuspicious * usual.disagreement;
  if (!suspicious || !problem.config.second_attempt) return best;

  add_swings(attempts, problem, predicted);
  // After a stumble the last velocity foretells nothing.
  const Twist mean = problem.model.mean(problem.prior.means[1].rotation);
  const KnotWindow steady = predicted.at_velocity(mean);
  const Annealing patient = patient_annealing(problem.config);
  attempts.add(predicted, problem.model, patient);
  attempts.add(steady, problem.model, patient);
  if (best.solved && best.misfit <= usual.most_misfit()) return best;

  // A sudden turn: the velocity fluctuates more than it was ever seen to.
  const VelocityModel looser = problem.model.looser(kLooser);
  attempts.add(predicted, looser, patient);
  attempts.add(steady, looser, patient);
  return best;
}

}  // namespace surefoot
