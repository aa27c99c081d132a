// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_attempts.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "methods/knots/knot_trials.hpp"

namespace surefoot {

namespace {

// Two registrations ended at the same place, or one has found a better one.
constexpr double kSame = 0.01, kSameAngle = 0.005;  // [m], [rad] of every knot
constexpr double kBetter = 0.98;                    // disagreements' ratio

// A looser velocity model explains more by itself: only what is clearly better was found by it. A
// hilltop's true turns were by 6 to 10 %, and staircases are lost for longer where 2 % are enough.
constexpr double kFreer = 0.95;  // disagreements' ratio

// Shares of the matches that are clouds, up to which planes and poles hold a scan, and from which
// on nothing does.
constexpr double kAllFirm = 0.3, kNoneFirm = 0.5;

// Where the last scan is nearly forgotten, so much of its information is left.
constexpr double kNearlyForgotten = 0.01;
// A map of fewer scans does not hold who has forgotten the last one.
constexpr int kKnown = 3;

// So often an end that ran away is begun anew: each time it may hold some segments longer.
constexpr int kMostEnds = 4;

// A flight's treads look alike: between two of them a narrow kernel stays, a wider one goes on.
constexpr double kWider = 2.5;

bool same_end(const KnotWindow& a, const KnotWindow& b) {
  for (std::size_t k = 2; k < a.knots.size(); ++k) {
    if ((a.knots[k].translation - b.knots[k].translation).norm() > kSame) return false;
    if (a.knots[k].rotation.angularDistance(b.knots[k].rotation) > kSameAngle) return false;
  }
  return true;
}

/// [m] between where two registrations of a scan end.
double apart(const KnotWindow& a, const KnotWindow& b) {
  return (a.knots.back().translation - b.knots.back().translation).norm();
}

bool is_better(const KnotRegistration& a, const KnotRegistration& b, double unseen_weight) {
  return a.solved && (!b.solved || a.disagreement(unseen_weight) < b.disagreement(unseen_weight));
}

/// Where other starts than the first lead: mostly to where the first did. All of them together cost
/// about three registrations.
class Attempts {
 public:
  Attempts(const KnotPoints& points, const KnotProblem& problem, const KnotRegistration& first)
      : trials_(points, problem.config), usual_(problem.model), first_(first) {
    least_ = trials_.disagreement_at(first.window, problem);
    if (first.converged) least_ *= kBetter;
  }

  /// @param least_apart [m] from where the first ended, or it has found no other place
  void add(const KnotProblem& problem, const KnotWindow& start, const Annealing& annealing,
           double least_apart = 0.0) {
    starts_.push_back({problem, start, annealing, least_apart});
  }

  /// Where one ended, and by which velocity model and prior.
  struct Best {
    KnotWindow window;
    const KnotProblem& problem;
  };
  /// If one ended better than the first did. They are independent: each is one thread's work.
  [[nodiscard]] std::optional<Best> best(const Workers& workers) const {
    std::vector<KnotRegistration> found(starts_.size());
    workers.for_each(starts_.size(), [&](std::size_t i) {
      found[i] = trials_.run(starts_[i].problem, starts_[i].window, starts_[i].annealing,
                             [this](const KnotRegistration& so_far, double before) {
                               return leads_nowhere(so_far, before);
                             });
    });
    std::optional<Best> best;
    double least = least_;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      const KnotProblem& problem = starts_[i].problem;
      const double most = &problem.model == &usual_ ? least : kFreer * least;
      if (!found[i].solved || trials_.disagreement(found[i]) >= most) continue;
      if (apart(found[i].window, first_.window) < starts_[i].least_apart) continue;
      least = trials_.disagreement(found[i]);
      best.emplace(Best{std::move(found[i].window), problem});
    }
    return best;
  }

 private:
  struct Start {
    const KnotProblem& problem;
    KnotWindow window;
    Annealing annealing;
    double least_apart;
  };

  /// Most that lead nowhere are seen to before they end.
  [[nodiscard]] bool leads_nowhere(const KnotRegistration& so_far, double before) const {
    if (is_hopeless(trials_.disagreement(so_far), before, least_)) return true;
    return first_.converged && same_end(so_far.window, first_.window);
  }

  KnotTrials trials_;
  const VelocityModel& usual_;
  const KnotRegistration& first_;
  double least_ = 1.0;
  std::vector<Start> starts_;
};

/// By a kernel that leaves a registration where it begins, or so many times as wide.
Annealing narrow_annealing(const Config::Knots& config, double times = 1.0) {
  Annealing annealing = usual_annealing(config);
  annealing.start = times * config.swing_kernel;
  return annealing;
}

/// By a kernel that sees farther than the usual one.
Annealing wide_annealing(const Config::Knots& config) {
  Annealing annealing = usual_annealing(config);
  annealing.start *= 2.0;
  return annealing;
}

/// From motions that roll or pitch faster than predicted, as at the foot of a stair.
void add_swings(Attempts& attempts, const KnotProblem& problem, const KnotWindow& predicted) {
  const Config::Knots& config = problem.config;
  const Eigen::Quaterniond& attitude = problem.prior.means[1].rotation;
  const auto add = [&](double rate, int axis, const Annealing& annealing) {
    for (const double swing : {rate, -rate}) {
      Twist velocity = predicted.mean_velocity();
      velocity.tail<3>() += attitude * (swing * Eigen::Vector3d::Unit(axis));
      attempts.add(problem, predicted.at_velocity(velocity), annealing);
    }
  };
  constexpr int kRoll = 0, kPitch = 1;
  const Annealing narrow = narrow_annealing(config);
  add(config.swing, kPitch, narrow);
  add(config.swing, kRoll, narrow);
  add(2.0 * config.swing, kPitch, narrow);
  add(config.swing, kPitch, narrow_annealing(config, kWider));
}

/// From motions that turn faster than predicted: who stands and looks around begins to, and stops,
/// within a scan, and where nothing is flat a scan fits nearly as well some degrees off.
void add_turns(Attempts& attempts, const KnotProblem& problem, const KnotWindow& predicted) {
  const Annealing annealing = narrow_annealing(problem.config);
  const double turn = problem.config.turn;
  for (const double rate : {turn, -turn, 2 * turn, -2 * turn, 3 * turn, -3 * turn}) {
    Twist velocity = predicted.mean_velocity();
    velocity[5] += rate;
    attempts.add(problem, predicted.at_velocity(velocity), annealing);
  }
}

KnotPrior nearly_forgotten(KnotPrior prior) {
  prior.information *= kNearlyForgotten;
  return prior;
}

/// By how many times a misfit is suspicious. Planes and poles tell a wrong place clearly; where
/// most points lie in clouds, a scan fits nearly as well some degrees off.
double most_of_usual(const KnotRegistration& found, const Config::Knots& config) {
  return 1.0 + (config.suspicious - 1.0) * firmness(found);
}

/// Registers from the best of attempts, if there is one; whether that ended better.
bool takes_better(const Attempts& attempts, KnotPoints& points, const KnotProblem& problem,
                  KnotRegistration& found) {
  const std::optional<Attempts::Best> best = attempts.best(problem.workers);
  if (!best) return false;
  for (KnotPoints::Point& point : points.points) point.place = {};
  KnotRegistration again =
      register_knots(points, best->problem, best->window, narrow_annealing(problem.config));
  if (!is_better(again, found, problem.config.unseen_weight)) return false;
  found = std::move(again);
  return true;
}

/// From motions that end as they went on before their end ran away, or a segment before that: what
/// is next to a bad segment is half astray itself.
/// @return whether one ended better
bool begins_end_anew(KnotPoints& points, const KnotProblem& problem, KnotRegistration& found) {
  const std::size_t from = runs_away_from(found.disagreements, problem.config.suspicious);
  if (from == found.disagreements.size()) return false;
  const Annealing narrow = narrow_annealing(problem.config);
  Attempts attempts(points, problem, found);
  for (std::size_t last = from; last > 0 && last + 2 > from; --last) {
    for (const bool changing : {false, true}) {
      attempts.add(problem, found.window.going_on_after(last - 1, changing), narrow);
    }
  }
  return takes_better(attempts, points, problem, found);
}

}  // namespace

std::size_t runs_away_from(const std::vector<double>& disagreements, double worse) {
  const double all = std::accumulate(disagreements.begin(), disagreements.end(), 0.0);
  const auto n = static_cast<double>(disagreements.size());
  std::size_t from = disagreements.size();
  double most = 0.0, before = 0.0;
  for (std::size_t s = 1; s < disagreements.size(); ++s) {
    before += disagreements[s - 1];
    const auto m = static_cast<double>(s);
    const double mean_before = before / m, mean_after = (all - before) / (n - m);
    const double step = (mean_after - mean_before) * std::sqrt(m * (n - m));  // [K39]
    if (step > most && mean_after > worse * mean_before) {
      most = step;
      from = s;
    }
  }
  return from;
}

double firmness(const KnotRegistration& found) {
  const double clouds = static_cast<double>(found.clouds) / std::max(found.matches, 1);
  return std::clamp((kNoneFirm - clouds) / (kNoneFirm - kAllFirm), 0.0, 1.0);
}

void UsualFit::learn(const KnotRegistration& found, double rate, const Config::Knots& config) {
  ++scans;
  misfit += rate * (found.misfit - misfit);
  disagreement += rate * (found.disagreement(config.unseen_weight) - disagreement);
  misfit_of_seen += rate * (found.misfit_of_seen() - misfit_of_seen);
}

double UsualFit::most_misfit_of_seen(const Config::Knots& config) const {
  return 2.0 * misfit_of_seen + config.misfit_margin;  // [K14]
}

bool is_suspicious(const KnotRegistration& found, const UsualFit& usual,
                   const Config::Knots& config) {
  const double most = most_of_usual(found, config);
  return !found.converged || found.misfit > most * usual.misfit ||
         found.disagreement(config.unseen_weight) > most * usual.disagreement;
}

KnotRegistration register_in_attempts(KnotPoints& points, const KnotProblem& problem,
                                      const KnotWindow& predicted, const UsualFit& usual) {
  const Config::Knots& config = problem.config;
  KnotRegistration first = register_knots(points, problem, predicted, usual_annealing(config));
  if (!config.second_attempt) return first;
  const auto suspicious = [&] { return is_suspicious(first, usual, config); };
  for (int end = 0; end < kMostEnds && suspicious(); ++end) {
    if (!begins_end_anew(points, problem, first)) break;
  }
  if (!suspicious()) return first;

  Attempts attempts(points, problem, first);
  add_swings(attempts, problem, predicted);
  // After a stumble the last velocity foretells nothing.
  const Twist mean = problem.model.mean(problem.prior.means[1].rotation);
  const KnotWindow steady = predicted.at_velocity(mean);
  attempts.add(problem, steady, wide_annealing(config));
  // A sudden turn: the velocity fluctuates more than it was ever seen to.
  const VelocityModel looser = problem.model.looser(config.looser);
  const KnotProblem loose{problem.map, problem.prior,   looser,
                          config,      problem.workers, problem.begin_step};
  add_turns(attempts, loose, predicted);
  // Who begins to walk: the rings of a LiDAR go with it, and where nothing is plane a scan fits
  // where the last one was nearly as well as where it is. Such freedom is for another place only:
  // about the same one it explains noise.
  const KnotPrior forgotten = nearly_forgotten(problem.prior);
  const KnotProblem free{problem.map, forgotten,       looser,
                         config,      problem.workers, problem.begin_step};
  if (usual.scans >= kKnown && firmness(first) < 1.0) {
    attempts.add(free, predicted, usual_annealing(config), config.kernel_end);
  }
  const bool wrong = first.misfit_of_seen() > usual.most_misfit_of_seen(config);
  if (wrong) {
    const Annealing patient = patient_annealing(config);
    attempts.add(loose, predicted, patient);
    attempts.add(loose, steady, patient);
  }
  takes_better(attempts, points, problem, first);
  return first;
}

}  // namespace surefoot
