// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace surefoot::evaluation {

namespace {

/// Share [0, 1] of the reference's time at which the estimate ends.
double reach(const Trajectory& reference, const Trajectory& estimate, double offset) {
  const auto begin = static_cast<double>(reference.front().stamp_ns);
  const auto end = static_cast<double>(reference.back().stamp_ns);
  const double last = static_cast<double>(estimate.back().stamp_ns) + 1e9 * offset;
  return end > begin ? std::clamp((last - begin) / (end - begin), 0.0, 1.0) : 1.0;
}

/// In percent, rounded down: 99.9 % is not all.
int whole_percent(double share) { return static_cast<int>(std::floor(100.0 * share)); }

}  // namespace

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::whole:
      return "whole";
    case Outcome::stopped:
      return "stopped";
    case Outcome::partial:
      return "partial";
    case Outcome::diverged:
      return "diverged";
    case Outcome::failed:
      break;
  }
  return "failed";
}

double standing_error(const Trajectory& reference) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto count = static_cast<double>(std::max<std::size_t>(reference.size(), 1));
  for (const StampedPose& stamped : reference) mean += stamped.pose.translation / count;
  double sum = 0.0;
  for (const StampedPose& stamped : reference) {
    sum += (stamped.pose.translation - mean).squaredNorm();
  }
  return std::sqrt(sum / count);
}

RunVerdict judge(const Trajectory& reference, const Trajectory& estimate,
                 const Evaluation& evaluation, const EvaluationOptions& options,
                 const VerdictRules& rules) {
  if (reference.empty() || estimate.empty()) {
    throw std::invalid_argument("judge: a trajectory has no poses");
  }
  if (evaluation.coverage < rules.full_coverage) {
    // What is paired by number covers all.
    const double end = reach(reference, estimate, options.association.offset);
    if (end < rules.full_coverage) {
      return {Outcome::stopped, fmt::format("stopped at {} %", whole_percent(end))};
    }
    return {Outcome::partial, fmt::format("covers only {} %", whole_percent(evaluation.coverage))};
  }
  const double error = evaluation.absolute.front().statistics.rmse;
  const double standing = rules.standing_share * standing_error(reference);
  if (error >= std::max(standing, rules.least_divergence)) return {Outcome::diverged, "diverged"};
  return {Outcome::whole, ""};
}

}  // namespace surefoot::evaluation
