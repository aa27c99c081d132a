// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "evaluation/ape.hpp"

namespace surefoot::evaluation {

namespace {

constexpr std::array<std::pair<Relation, const char*>, 4> kRelations = {{
    {Relation::translation, "translation"},
    {Relation::rotation_angle, "rotation_angle"},
    {Relation::rotation_part, "rotation_part"},
    {Relation::full, "full"},
}};

std::vector<NamedStatistics> absolute_statistics(const AssociatedTrajectories& pairs,
                                                 bool positions_only) {
  std::vector<NamedStatistics> result;
  for (const auto& [relation, name] : kRelations) {
    if (positions_only && relation != Relation::translation) continue;
    result.push_back({std::string("ape_") + name, std::string(unit_of(relation)),
                      statistics_of(absolute_errors(pairs, relation))});
  }
  const std::vector<SplitError> split = absolute_split_errors(pairs);
  const auto add = [&](const char* name, const char* unit, double SplitError::*part) {
    std::vector<double> errors;
    errors.reserve(split.size());
    for (const SplitError& error : split) errors.push_back(error.*part);
    result.push_back({name, unit, statistics_of(errors)});
  };
  add("ape_horizontal", "m", &SplitError::horizontal);
  add("ape_vertical", "m", &SplitError::vertical);
  if (positions_only) return result;
  add("ape_tilt", "deg", &SplitError::tilt);
  add("ape_yaw", "deg", &SplitError::yaw);
  return result;
}

std::vector<NamedStatistics> relative_statistics(const AssociatedTrajectories& pairs,
                                                 const std::vector<IndexPair>& stretches,
                                                 bool positions_only) {
  if (stretches.empty()) return {};
  std::vector<NamedStatistics> result;
  for (const auto& [relation, name] : kRelations) {
    if (positions_only) break;  // all are seen from the reference's pose
    result.push_back({std::string("rpe_") + name, std::string(unit_of(relation)),
                      statistics_of(relative_errors(pairs, stretches, relation))});
  }
  result.push_back(
      {"rpe_distance", "m", statistics_of(relative_distance_errors(pairs, stretches))});
  const std::vector<double> percents = relative_distance_error_percents(pairs, stretches);
  if (!percents.empty()) result.push_back({"rpe_distance_percent", "%", statistics_of(percents)});
  return result;
}

/// Without stamps there is one pose for each of the reference's, which associate() has checked.
double share_covered(const Trajectory& reference, const Trajectory& estimate,
                     const EvaluationOptions& options) {
  if (options.association.method == AssociationMethod::index) return 1.0;
  return coverage(reference, estimate, options.association.offset, options.usual_step_ns);
}

std::size_t count_within(const Trajectory& trajectory, std::int64_t begin_ns, std::int64_t end_ns) {
  return static_cast<std::size_t>(
      std::count_if(trajectory.begin(), trajectory.end(), [&](const StampedPose& pose) {
        return pose.stamp_ns >= begin_ns && pose.stamp_ns <= end_ns;
      }));
}

/// Poses in the time that both have, of the trajectory that has fewer there.
std::size_t most_pairs(const Trajectory& reference, const Trajectory& estimate,
                       const AssociationOptions& options) {
  if (options.method == AssociationMethod::index) return estimate.size();
  const std::int64_t offset_ns = std::llround(1e9 * options.offset);
  return std::min(count_within(estimate, reference.front().stamp_ns - offset_ns,
                               reference.back().stamp_ns - offset_ns),
                  count_within(reference, estimate.front().stamp_ns + offset_ns,
                               estimate.back().stamp_ns + offset_ns));
}

/// Without rotations there is no first pose to lay on another: the way from the first to the last
/// position, as it is aligned.
EndDrift drift_of_positions(const AssociatedTrajectories& pairs) {
  const auto way = [](const Trajectory& trajectory) -> Eigen::Vector3d {
    return trajectory.back().pose.translation - trajectory.front().pose.translation;
  };
  return drift_of(way(pairs.estimate) - way(pairs.reference), path_lengths(pairs.reference).back());
}

void check_alignment(const EvaluationOptions& options) {
  const bool by_rotation =
      options.alignment == AlignmentMethod::origin || options.alignment == AlignmentMethod::poses;
  if (options.positions_only && by_rotation) {
    throw std::runtime_error(
        "the reference has positions only, which poses cannot be aligned to; --align se3 can");
  }
}

}  // namespace

const Statistics* find_statistics(const Evaluation& evaluation, std::string_view name) {
  for (const auto* list : {&evaluation.absolute, &evaluation.relative}) {
    for (const NamedStatistics& named : *list) {
      if (named.name == name) return &named.statistics;
    }
  }
  return nullptr;
}

Evaluation evaluate(const std::string& name, const Trajectory& reference,
                    const Trajectory& estimate, const EvaluationOptions& options) {
  check_alignment(options);
  AssociatedTrajectories pairs = associate(reference, estimate, options.association);
  Evaluation result;
  result.name = name;
  result.pairs = pairs.estimate.size();
  result.poses = estimate.size();
  result.most_pairs = most_pairs(reference, estimate, options.association);
  result.coverage = share_covered(reference, estimate, options);
  result.alignment = find_alignment(pairs, options.alignment, options.alignment_poses);
  pairs.estimate = aligned(pairs.estimate, result.alignment);
  const bool positions_only = options.positions_only;
  result.absolute = absolute_statistics(pairs, positions_only);
  const Trajectory& measured = options.stretches_from_reference ? pairs.reference : pairs.estimate;
  result.relative =
      relative_statistics(pairs, find_pairs(measured, options.stretches), positions_only);
  if (positions_only) {
    result.drift = drift_of_positions(pairs);
    return result;
  }
  const double length = path_lengths(pairs.reference).back();
  const bool lengths_given = !options.segment_lengths.empty();
  result.segments =
      segment_errors(pairs, lengths_given ? options.segment_lengths : segment_lengths_for(length));
  result.drift = end_drift(pairs);
  return result;
}

}  // namespace surefoot::evaluation
