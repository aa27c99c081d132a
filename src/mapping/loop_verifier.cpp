// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_verifier.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/se3.hpp"
#include "geometry/so3.hpp"
#include "mapping/place_doubts.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kRefined = 3;       // of the starts, the best after the coarsest grid
constexpr double kSamePlaceMetres = 0.5;  // registrations that end farther away found another place
constexpr double kSamePlaceDegrees = 5.0;
constexpr double kHopeless = 0.1;  // share that lies on something on the coarsest grid: of 315
                                   // pairs that ended above 0.4, all began above 0.14
constexpr double kAsGood = 0.95;   // of the best one's share of matched points

/// Share of the points that stand where the space saw nothing, of those that it can tell about.
double contradicted(const FreeSpace& space, const std::vector<SubmapPoint>& points,
                    const Pose& T_space_points) {
  std::size_t empty = 0;
  std::size_t known = 0;
  for (const SubmapPoint& point : points) {
    const FreeSpace::Sight sight = space.at(T_space_points * point.at);
    known += sight != FreeSpace::Sight::unknown ? 1 : 0;
    empty += sight == FreeSpace::Sight::empty ? 1 : 0;
  }
  return known > 0 ? static_cast<double>(empty) / static_cast<double>(known) : 1.0;
}

/// Starts that are one after the coarsest grid mostly end at one pose.
bool near_each_other(const SubmapAlignment& one, const SubmapAlignment& other) {
  constexpr double kOne = 0.1;  // [m], kLever away
  const Pose apart = one.T_target_source.inverse() * other.T_target_source;
  return apart.translation.norm() + kLever * turn_angle(apart) < kOne;
}

/// The starts that look best after the coarsest grid, refined; the best first. `quickly`: those
/// that are one by then are refined once.
std::vector<SubmapAlignment> align_all(const RegistrationSubmap& target,
                                       const RegistrationSubmap& source,
                                       const std::vector<Pose>& starts, bool quickly) {
  std::vector<SubmapAlignment> rough;
  rough.reserve(starts.size());
  for (const Pose& start : starts) rough.push_back(align_roughly(target, source, start));
  const auto better = [](const SubmapAlignment& a, const SubmapAlignment& b) {
    return a.matched > b.matched;
  };
  std::stable_sort(rough.begin(), rough.end(), better);
  if (rough.size() > kRefined) rough.resize(kRefined);
  if (rough.front().matched < kHopeless) return rough;
  std::vector<SubmapAlignment> fine;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    std::size_t same = quickly ? 0 : i;
    while (same < i && !near_each_other(rough[same], rough[i])) ++same;
    fine.push_back(same < i ? fine[same]
                            : align_submaps(target, source, rough[i].T_target_source, 1));
  }
  std::stable_sort(fine.begin(), fine.end(), better);
  return fine;
}

/// [m] How far submaps may be bent in themselves where the alignment holds.
double bend_of(const SubmapAlignment& alignment, const Matrix6& covariance) {
  Twist scale;
  scale << 1.0, 1.0, 1.0, kLever, kLever, kLever;
  const Matrix6 scaled = scale.asDiagonal() * covariance * scale.asDiagonal();
  double worst = 0.0;
  for (int i = 0; i < alignment.held; ++i) {
    const Twist axis = alignment.axes.col(i);
    worst = std::max(worst, axis.dot(scaled * axis));
  }
  return std::sqrt(worst);
}

bool elsewhere(const SubmapAlignment& best, const SubmapAlignment& other) {
  const AlignmentGap gap = gap_between(best, other.T_target_source);
  return other.matched > kAsGood * best.matched &&
         (gap.metres > kSamePlaceMetres || gap.degrees > kSamePlaceDegrees);
}

}  // namespace

std::string_view to_string(LoopVerdict verdict) {
  switch (verdict) {
    case LoopVerdict::taken:
      return "taken";
    case LoopVerdict::little_to_see:
      return "little_to_see";
    case LoopVerdict::no_overlap:
      return "no_overlap";
    case LoopVerdict::starts_disagree:
      return "starts_disagree";
    case LoopVerdict::bent:
      return "bent";
    case LoopVerdict::free_space:
      return "free_space";
    case LoopVerdict::beyond_drift:
      return "beyond_drift";
    case LoopVerdict::other_storey:
      return "other_storey";
    case LoopVerdict::ambiguous:
      return "ambiguous";
    case LoopVerdict::alone:
      return "alone";
    case LoopVerdict::outvoted:
      return "outvoted";
    case LoopVerdict::strains:
      return "strains";
    case LoopVerdict::not_joined:
      return "not_joined";
  }
  return "?";
}

std::string_view explain(LoopVerdict verdict) {
  switch (verdict) {
    case LoopVerdict::taken:
      return "every question was answered with yes";
    case LoopVerdict::little_to_see:
      return "too few points stand upright";
    case LoopVerdict::no_overlap:
      return "too little of one lies on the other";
    case LoopVerdict::starts_disagree:
      return "registrations from several starts end apart";
    case LoopVerdict::bent:
      return "the odometry was not sure of its own way there";
    case LoopVerdict::free_space:
      return "something stands where the other saw nothing";
    case LoopVerdict::beyond_drift:
      return "the odometry cannot have gone so far astray";
    case LoopVerdict::other_storey:
      return "under a roof, and on another height";
    case LoopVerdict::ambiguous:
      return "another place fits as well, or this one otherwise";
    case LoopVerdict::alone:
      return "no other loop agrees";
    case LoopVerdict::outvoted:
      return "more loops agree on something else";
    case LoopVerdict::strains:
      return "the odometry would be bent beyond its bounds";
    case LoopVerdict::not_joined:
      return "all together do not tell surely how the maps lie";
  }
  return "?";
}

double contradiction_between(const VerifiableSubmap& one, const VerifiableSubmap& other,
                             const Pose& T_one_other) {
  return std::max(
      contradicted(one.free_space(), other.registration().standing(), T_one_other),
      contradicted(other.free_space(), one.registration().standing(), T_one_other.inverse()));
}

double missing_between(const VerifiableSubmap& one, const VerifiableSubmap& other,
                       const Pose& T_one_other) {
  const Pose T_other_one = T_one_other.inverse();
  const Outlook of_other(other.submap(), Eigen::Vector3d::Zero());
  const Outlook of_one(one.submap(), T_one_other * of_other.eye());
  return std::max(missing_in(of_other, one.registration(), T_other_one),
                  missing_in(of_one, other.registration(), T_one_other));
}

LoopCheck check_places(const VerifiableSubmap& place, const VerifiableSubmap& query,
                       const std::vector<Pose>& starts, const LoopLimits& limits) {
  LoopCheck check;
  const RegistrationSubmap& target = place.registration();
  const RegistrationSubmap& source = query.registration();
  check.verdict = LoopVerdict::beyond_drift;
  if (starts.empty()) return check;
  check.verdict = LoopVerdict::little_to_see;
  if (std::min(target.standing_count(), source.standing_count()) < limits.standing) {
    return check;
  }
  const std::vector<SubmapAlignment> forward = align_all(target, source, starts, limits.partial);
  check.alignment = forward.front();
  check.overlap = forward.front().matched;
  check.started = static_cast<int>(forward.size());
  check.verdict = LoopVerdict::no_overlap;
  if (check.overlap < limits.overlap) return check;  // the other way round would not help
  check.level = forward.front().level;
  std::vector<SubmapAlignment> backward;
  if (!limits.partial) {
    std::vector<Pose> inverse;
    inverse.reserve(starts.size());
    for (const Pose& start : starts) inverse.push_back(start.inverse());
    backward = align_all(source, target, inverse, false);
    check.overlap = std::min(check.overlap, backward.front().matched);
    check.level = std::min(check.level, backward.front().level);
  }
  check.started = static_cast<int>(forward.size() + backward.size());
  if (check.overlap < limits.overlap) return check;
  // What stands looks alike on all storeys; what lies does not, seen through a ramp. It alone holds
  // the height.
  const bool both_lie = !target.lying().empty() && !source.lying().empty();
  if (both_lie && check.level < limits.overlap) return check;

  check.verdict = LoopVerdict::starts_disagree;
  const auto agrees = [&](const Pose& pose) {
    const AlignmentGap gap = gap_between(check.alignment, pose);
    return gap.metres <= limits.gap_metres && gap.degrees <= limits.gap_degrees;
  };
  for (const SubmapAlignment& alignment : forward) {
    check.agreeing += agrees(alignment.T_target_source) ? 1 : 0;
    if (elsewhere(forward.front(), alignment)) return check;
  }
  for (const SubmapAlignment& alignment : backward) {
    check.agreeing += agrees(alignment.T_target_source.inverse()) ? 1 : 0;
  }
  const bool both_ways = backward.empty() || agrees(backward.front().T_target_source.inverse());
  if (!both_ways || check.agreeing < std::min<int>(limits.agreeing, check.started)) return check;

  const Pose& T_place_query = check.alignment.T_target_source;
  const Matrix6 bend_of_place = turned(place.submap().covariance, T_place_query.rotation);
  check.verdict = LoopVerdict::bent;
  check.bend = bend_of(check.alignment, bend_of_place + query.submap().covariance);
  if (check.bend > limits.bend) return check;
  check.contradicted = contradiction_between(place, query, T_place_query);
  if (limits.partial) {
    check.missing = missing_between(place, query, T_place_query);
    check.beside = beside_walls(target, source, T_place_query);
  }
  const bool refuted = check.contradicted > limits.contradicted || check.missing > limits.missing ||
                       check.beside > limits.beside;
  check.verdict = refuted ? LoopVerdict::free_space : LoopVerdict::taken;
  return check;
}

}  // namespace surefoot::mapping
