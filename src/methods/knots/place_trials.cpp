// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/place_trials.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "methods/knots/knot_search.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// A trial that disagrees so many times as much as the best one goes on as that one does.
constexpr double kWorthMore = 1.4;

/// Best first, of those that end at one place the best.
std::vector<PlaceTrial> best_of(const std::vector<std::optional<PlaceTrial>>& ends) {
  std::vector<PlaceTrial> trials;
  for (const std::optional<PlaceTrial>& end : ends) {
    if (end) trials.push_back(*end);
  }
  return best_apart(std::move(trials), ends.size(), [](const PlaceTrial& a, const PlaceTrial& b) {
    return a.disagreement < b.disagreement;
  });
}

KnotWindow predicted_at(const KnotEnd& begin, const Twist& velocity, const PreparedScan& scan,
                        const KnotProblem& problem) {
  return predict_knots(scan, begin, problem.model, problem.config).at_velocity(velocity);
}

/// The windows of all trials have their knots at the same instants.
KnotPoints points_of(const PreparedScan& scan, const std::vector<std::uint32_t>& chosen,
                     const KnotProblem& problem) {
  const KnotEnd anywhere = begin_at({}, scan, problem.config);
  return sort_points(scan, chosen, predicted_at(anywhere, Twist::Zero(), scan, problem));
}

}  // namespace

KnotEnd begin_at(const Pose& place, const PreparedScan& scan, const Config::Knots& config) {
  constexpr double kSince = 0.5;  // [s] that a place is as vague as after walking so long
  const double step = usual_step(scan, config.segments);
  return {at_rest(place, step, kSince), std::min(scan.start_ns, scan.end_ns - kInstantNs), step};
}

PlaceTrials::PlaceTrials(const PreparedScan& scan, const std::vector<std::uint32_t>& chosen,
                         const KnotProblem& problem)
    : scan_(scan),
      chosen_(chosen),
      problem_(problem),
      trials_(points_of(scan, chosen, problem), problem.config) {}

double PlaceTrials::disagreement_at(const KnotWindow& window) const {
  const KnotTrials trials(sort_points(scan_, chosen_, window), problem_.config);
  return trials.disagreement_at(window, problem_);
}

/// A trial from where the last one ended, or from what is predicted.
std::optional<PlaceTrial> PlaceTrials::run(PlaceTrial trial, double least) const {
  const KnotProblem here{problem_.map,    trial.begin.prior, problem_.model,
                         problem_.config, problem_.workers,  problem_.begin_step};
  const auto hopeless = [&](const KnotRegistration& so_far, double before) {
    return is_hopeless(trials_.disagreement(so_far), before, least);
  };
  KnotRegistration found =
      trials_.run(here, trial.window, usual_annealing(problem_.config), hopeless);
  if (!found.solved) return std::nullopt;
  trial.pose = found.window.trajectory(scan_.start_ns, scan_.end_ns).at(0.5);
  trial.disagreement = trials_.disagreement(found);
  trial.unseen = found.unseen;
  trial.window = std::move(found.window);
  return trial;
}

std::vector<PlaceTrial> PlaceTrials::from(const std::vector<PlaceStart>& starts,
                                          double least) const {
  std::vector<std::optional<PlaceTrial>> ends(starts.size());
  problem_.workers.for_each(starts.size(), [&](std::size_t i) {
    const KnotEnd begin = begin_at(starts[i].place, scan_, problem_.config);
    const KnotWindow predicted = predicted_at(begin, starts[i].velocity, scan_, problem_);
    ends[i] = run({begin, predicted, predicted, {}}, least);
  });
  std::vector<PlaceTrial> trials = best_of(ends);
  // What is about as good as the best may be better yet: from so far away it takes its time.
  ends.clear();
  for (const PlaceTrial& trial : trials) {
    if (trial.disagreement < kWorthMore * trials[0].disagreement) ends.emplace_back(trial);
  }
  problem_.workers.for_each(ends.size(), [&](std::size_t i) {
    std::optional<PlaceTrial> again = run(trials[i], least);
    if (again && again->disagreement < trials[i].disagreement) ends[i] = std::move(again);
  });
  for (std::size_t i = ends.size(); i < trials.size(); ++i) ends.emplace_back(trials[i]);
  return best_of(ends);
}

}  // namespace surefoot
