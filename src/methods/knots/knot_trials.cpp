// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_trials.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// So many points tell where a start leads and, roughly, how well the scan fits there.
constexpr std::size_t kTried = 500;

// Iterations once the kernel has narrowed.
constexpr int kSettling = 6;

std::size_t stride_of(const KnotPoints& points) {
  return std::max<std::size_t>(points.points.size() / kTried, 1);
}

/// Every so many-th point of each segment, with no place in the map.
KnotPoints every(std::size_t stride, const KnotPoints& points) {
  KnotPoints some;
  for (std::size_t s = 0; s + 1 < points.begins.size(); ++s) {
    some.begins.push_back(some.points.size());
    for (std::size_t i = points.begins[s]; i < points.begins[s + 1]; i += stride) {
      some.points.push_back(points.points[i]);
      some.points.back().place = {};
    }
  }
  some.begins.push_back(some.points.size());
  return some;
}

/// Each of the points that are left counts as so many.
Config::Knots weighed(Config::Knots config, std::size_t stride) {
  config.independence *= static_cast<double>(stride);
  return config;
}

int most_iterations(const Annealing& annealing, double kernel_end) {
  const double narrowed = std::log(kernel_end / annealing.start) / std::log(annealing.decay);
  return static_cast<int>(std::ceil(std::max(narrowed, 0.0))) + kSettling;
}

}  // namespace

KnotTrials::KnotTrials(const KnotPoints& points, const Config::Knots& config)
    : KnotTrials(points, config, stride_of(points)) {}

KnotTrials::KnotTrials(const KnotPoints& points, const Config::Knots& config, std::size_t stride)
    : points_(every(stride, points)), config_(weighed(config, stride)) {}

KnotRegistration KnotTrials::run(const KnotProblem& problem, const KnotWindow& start,
                                 const Annealing& annealing, const Abandon& abandon) const {
  Annealing some = annealing;
  some.max_iterations =
      std::min(annealing.max_iterations, most_iterations(annealing, config_.kernel_end));
  return register_from(start, problem, some, abandon);
}

double KnotTrials::disagreement_at(const KnotWindow& window, const KnotProblem& problem) const {
  const Annealing look{config_.kernel_end, 1.0, 1};
  return disagreement(register_from(window, problem, look, {}));
}

KnotRegistration KnotTrials::register_from(const KnotWindow& start, const KnotProblem& problem,
                                           const Annealing& annealing,
                                           const Abandon& abandon) const {
  KnotPoints points = points_;
  // The observer is one thread's own: if there are several, it is told nothing of each one's.
  const StepObserver nobody = [](Step) {};
  const StepObserver& observer = problem.workers.threads() > 1 ? nobody : problem.begin_step;
  const KnotProblem some{problem.map, problem.prior, problem.model, config_, alone_, observer};
  return register_knots(points, some, start, annealing, abandon);
}

}  // namespace surefoot
