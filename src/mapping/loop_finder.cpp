// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_finder.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "geometry/se3.hpp"
#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kSigmas = 3.0;

/// Through a ramp or a stairwell one storey is seen from the other; that is no return, and the two
/// sides of a slab are easily taken for one.
bool over_each_other(const Pose& T_place_query) {
  constexpr double kSlope = 0.2;
  const Eigen::Vector3d& t = T_place_query.translation;
  return std::abs(t.z()) > kHalfStorey + kSlope * t.head<2>().norm();
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// Whether the odometry leaves it open that a rough pose is right. A corridor looks the same the
/// other way round; the odometry knows.
bool left_open(const Pose& rough, const Pose& by_odometry, const Matrix6& drift) {
  constexpr double kRoughMetres = 6.0;
  constexpr double kRoughTurn = 0.4;  // [rad]
  constexpr double kMostSigmas = 4.0;
  const Pose apart = by_odometry.inverse() * rough;
  const double sigma = std::sqrt(drift.topLeftCorner<3, 3>().trace());
  const double sigma_turn = std::sqrt(drift.bottomRightCorner<3, 3>().trace());
  return apart.translation.norm() < kRoughMetres + kMostSigmas * sigma &&
         turn_angle(apart) < kRoughTurn + kMostSigmas * sigma_turn;
}

/// From where registration starts: what the descriptors say, and what the odometry says where it
/// can know, each turned a little both ways.
std::vector<Pose> starts_of(const Pose& by_descriptor, const Pose& by_odometry,
                            const Matrix6& drift) {
  constexpr double kKnown = 4.0;  // [m] standard deviation
  std::vector<Pose> rough;
  if (left_open(by_descriptor, by_odometry, drift)) rough.push_back(by_descriptor);
  if (std::sqrt(drift.topLeftCorner<3, 3>().trace()) < kKnown) rough.push_back(by_odometry);
  std::vector<Pose> starts;
  for (const Pose& pose : rough) {
    for (const Pose& start : turned_both_ways(pose)) starts.push_back(start);
  }
  return starts;
}

}  // namespace

PoseEdge edge_of(const Loop& loop) {
  PoseEdge edge;
  edge.from = loop.place;
  edge.to = loop.query;
  edge.T_from_to = loop.check.alignment.T_target_source;
  edge.information = loop.check.alignment.information;
  edge.inlier = false;
  return edge;
}

void LoopFinder::add(Piece piece) {
  put_away(piece, options_.clouds);
  pieces_.push_back(std::move(piece));
  if (pieces_.size() < 2) return;
  odometry_.push_back(odometry_edge(pieces_, pieces_.size() - 2, options_.drift));
  look_for(pieces_.size() - 2);
}

void LoopFinder::finish() {
  if (!pieces_.empty() && index_.size() < pieces_.size()) look_for(pieces_.size() - 1);
}

void LoopFinder::look_for(std::size_t query) {
  Submap submap = make_submap(pieces_, query);
  const std::vector<OffsetDescriptor> descriptors = describe_with_offsets(submap);
  const std::vector<Matrix6> drifts = drifts_to(pieces_, odometry_, query, options_.drift);
  // Where the odometry began anew it says nothing of what lies before.
  std::size_t stretch = query;
  while (stretch > 0 && !pieces_[stretch].restarted) --stretch;
  const auto within_reach = [&](std::size_t place) {
    if (place < stretch) return false;
    if (pieces_[query].way - pieces_[place].way < options_.way_between) return false;
    const double apart =
        (pieces_[query].T_world_piece.translation - pieces_[place].T_world_piece.translation)
            .norm();
    const double sigma = std::sqrt(drifts[place].topLeftCorner<3, 3>().trace());
    return apart < options_.near + kSigmas * sigma;
  };
  const auto matches = index_.search(descriptors, within_reach, options_.candidates);
  index_.add(descriptors.front().descriptor);
  if (matches.empty()) return;
  const VerifiableSubmap seen(std::move(submap));
  const std::size_t first = loops_.size();
  for (const PlaceIndex::Match& match : matches) {
    verify(match, drifts[match.place], query, seen);
  }
  refuse_ambiguous(first);
}

void LoopFinder::verify(const PlaceIndex::Match& match, const Matrix6& drift, std::size_t query,
                        const VerifiableSubmap& seen) {
  const VerifiableSubmap place(make_submap(pieces_, match.place));
  const Pose by_descriptor = rough_pose(match, place.submap(), seen.submap());
  const Pose by_odometry =
      pieces_[match.place].T_world_piece.inverse() * pieces_[query].T_world_piece;
  Loop loop;
  loop.place = match.place;
  loop.query = query;
  loop.likeness = match.distance;
  loop.drift = drift;
  loop.check =
      check_places(place, seen, starts_of(by_descriptor, by_odometry, drift), options_.limits);
  const Pose& found = loop.check.alignment.T_target_source;
  const Twist claimed = se3_log(by_odometry.inverse() * found);
  // Only what the registration holds is claimed; the rest may be anything.
  const Matrix6 own = (loop.check.alignment.information + 1e-6 * Matrix6::Identity()).inverse();
  loop.drift_chi2 = claimed.dot((drift + own).ldlt().solve(claimed));
  if (loop.check.verdict == LoopVerdict::taken) {
    const bool roofed = place.submap().covered && seen.submap().covered;
    const double lifted = (pieces_[match.place].T_world_piece * found).translation.z() -
                          pieces_[query].T_world_piece.translation.z();
    if (loop.drift_chi2 > kChi2Of6At999) {
      loop.check.verdict = LoopVerdict::beyond_drift;
    } else if ((roofed && std::abs(lifted) > kHalfStorey) || over_each_other(found)) {
      loop.check.verdict = LoopVerdict::other_storey;
    }
  }
  loops_.push_back(loop);
}

/// Two places that both fit, and cannot both be right, tell nothing.
void LoopFinder::refuse_ambiguous(std::size_t first) {
  constexpr double kMetres = 1.0;
  constexpr double kDegrees = 5.0;
  std::vector<std::size_t> ambiguous;
  for (std::size_t a = first; a < loops_.size(); ++a) {
    for (std::size_t b = first; b < loops_.size(); ++b) {
      if (a == b || loops_[a].check.verdict != LoopVerdict::taken ||
          loops_[b].check.verdict != LoopVerdict::taken) {
        continue;
      }
      const std::size_t early = std::min(loops_[a].place, loops_[b].place);
      const std::size_t late = std::max(loops_[a].place, loops_[b].place);
      const Pose world_a =
          pieces_[loops_[a].place].T_world_piece * loops_[a].check.alignment.T_target_source;
      const Pose world_b =
          pieces_[loops_[b].place].T_world_piece * loops_[b].check.alignment.T_target_source;
      const Pose apart = world_a.inverse() * world_b;
      const Matrix6 drift = drift_between(pieces_, odometry_, early, late, options_.drift);
      const double metres = kMetres + kSigmas * std::sqrt(drift.topLeftCorner<3, 3>().trace());
      const double turn =
          kDegrees + degrees(kSigmas * std::sqrt(drift.bottomRightCorner<3, 3>().trace()));
      // What neither holds (the way along a corridor) may differ.
      const AlignmentGap gap =
          gap_between(loops_[a].check.alignment, loops_[a].check.alignment.T_target_source * apart);
      if (gap.metres > metres || gap.degrees > turn) ambiguous.push_back(a);
    }
  }
  for (const std::size_t loop : ambiguous) loops_[loop].check.verdict = LoopVerdict::ambiguous;
}

}  // namespace surefoot::mapping
