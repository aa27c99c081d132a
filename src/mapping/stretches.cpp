// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mapping/loop_solution.hpp"
#include "mapping/place_search.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::mapping {

namespace {

/// Stretches that are held together: a map, and which of the walk's pieces it consists of.
struct Group {
  SavedMap map;
  std::vector<std::size_t> pieces;
};

Group group_of(const std::vector<Piece>& pieces, const std::vector<std::size_t>& stretches,
               std::size_t stretch, const PlaceIndex& places, const PoseGraph& graph) {
  Group group;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (stretches[i] != stretch) continue;
    group.pieces.push_back(i);
    group.map.pieces.push_back(pieces[i]);
    group.map.pieces.back().T_world_piece = graph.poses[i];
    group.map.places.push_back(places.place(i));
  }
  const std::size_t first = group.pieces.front();
  for (PoseEdge edge : graph.edges) {
    if (stretches[edge.from] != stretch || stretches[edge.to] != stretch) continue;
    edge.from -= first;
    edge.to -= first;
    group.map.edges.push_back(edge);
  }
  return group;
}

/// [m/s] The fastest that the walk went from one piece to the next.
double fastest(const std::vector<Piece>& pieces) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double time = seconds(pieces[i + 1].time_ns - pieces[i].time_ns);
    if (pieces[i + 1].restarted || time <= 0.0) continue;
    most = std::max(most, (pieces[i + 1].way - pieces[i].way) / time);
  }
  return most;
}

/// Whether the robot can have gone from where it was last known to where it is known again, in the
/// time between. No odometry says so, but it walks.
bool reachable(const std::vector<Piece>& pieces, const std::vector<std::size_t>& numbers,
               const std::vector<Piece>& placed) {
  constexpr double kFaster = 1.5;  // than it ever went
  constexpr double kAbout = 5.0;   // [m] a piece's length
  const double speed = kFaster * fastest(pieces);
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> in_order;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    in_order.emplace_back(numbers[i], placed[i].T_world_piece.translation);
  }
  std::sort(in_order.begin(), in_order.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < in_order.size(); ++i) {
    const auto& [before, here] = in_order[i];
    const auto& [after, there] = in_order[i + 1];
    if (!pieces[after].restarted && after == before + 1) continue;  // the odometry knows
    const double time = seconds(pieces[after].time_ns - pieces[before].time_ns);
    if ((there - here).norm() > speed * time + kAbout) return false;
  }
  return true;
}

/// The nearest place of the first `first` pieces on the same height; none: nothing is near.
std::optional<std::size_t> nearest_place(const std::vector<Piece>& pieces, std::size_t first,
                                         const Eigen::Vector3d& at) {
  constexpr double kNear = 5.0;  // [m]
  std::optional<std::size_t> nearest;
  double distance = kNear;
  for (std::size_t i = 0; i < first; ++i) {
    const Eigen::Vector3d apart = pieces[i].T_world_piece.translation - at;
    if (std::abs(apart.z()) > kHalfStorey || apart.norm() >= distance) continue;
    distance = apart.norm();
    nearest = i;
  }
  return nearest;
}

bool is_taken(const std::vector<Loop>& loops, std::size_t place, std::size_t query) {
  return std::any_of(loops.begin(), loops.end(), [&](const Loop& loop) {
    return is_taken(loop) && loop.place == place && loop.query == query;
  });
}

/// Where the joined stretches lie near each other, asked once more: now it is known where from.
std::vector<Loop> look_again(const SavedMap& joint, const MapJoin& join,
                             const MergeOptions& options) {
  constexpr double kMetres = 1.0;
  constexpr double kDegrees = 5.0;
  std::vector<Loop> loops;
  const std::vector<Piece>& pieces = joint.pieces;
  for (std::size_t query = join.first; query < pieces.size(); ++query) {
    const auto near = nearest_place(pieces, join.first, pieces[query].T_world_piece.translation);
    if (!near || is_taken(join.loops, *near, query)) continue;
    const VerifiableSubmap place(make_submap(pieces, *near));
    const VerifiableSubmap seen(make_submap(pieces, query));
    const Pose expected = pieces[*near].T_world_piece.inverse() * pieces[query].T_world_piece;
    Loop loop;
    loop.place = *near;
    loop.query = query;
    loop.likeness = distance_between(joint.places[*near], joint.places[query]).distance;
    loop.check = check_places(place, seen, turned_both_ways(expected), options.limits);
    const AlignmentGap gap = gap_between(loop.check.alignment, expected);
    if (is_taken(loop) && (gap.metres > kMetres || gap.degrees > kDegrees)) {
      loop.check.verdict = LoopVerdict::ambiguous;
    } else if (is_taken(loop) && place.submap().covered && seen.submap().covered &&
               !options.roofed) {
      loop.check.verdict = LoopVerdict::other_storey;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Adds loops to a joined map that had been overlooked.
void tighten(SavedMap& joint, std::vector<Loop>& loops) {
  PoseGraph graph;
  for (const Piece& piece : joint.pieces) graph.poses.push_back(piece.T_world_piece);
  graph.edges = joint.edges;
  for (PoseEdge& edge : graph.edges) edge.inlier = true;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (is_taken(loops[i])) chosen.push_back(i);
  }
  take_loops(graph, loops, chosen);
  for (std::size_t i = 0; i < joint.pieces.size(); ++i) {
    joint.pieces[i].T_world_piece = graph.poses[i];
  }
  for (const Loop& loop : loops) {
    if (is_taken(loop)) joint.edges.push_back(edge_of(loop));
  }
}

/// Both as one in `group`, if they can be joined; the loops that were compared go to `compared`.
/// What was walked first stays where it is.
bool join(const std::vector<Piece>& walk, Group& group, Group& other, const MergeOptions& options,
          std::vector<Loop>& compared) {
  if (other.pieces.front() < group.pieces.front()) std::swap(group, other);
  MapJoin joined = join_maps(group.map, other.map, options);
  std::vector<std::size_t> numbers = group.pieces;
  numbers.insert(numbers.end(), other.pieces.begin(), other.pieces.end());
  const bool whole = joined.joint && joined.joint->pieces.size() == numbers.size() &&
                     reachable(walk, numbers, joined.joint->pieces);
  if (whole) {
    std::vector<Loop> again = look_again(*joined.joint, joined, options);
    tighten(*joined.joint, again);
    joined.loops.insert(joined.loops.end(), again.begin(), again.end());
  }
  for (Loop& loop : joined.loops) {
    if (!whole && is_taken(loop)) loop.check.verdict = LoopVerdict::not_joined;
    loop.place = numbers[loop.place];
    loop.query = numbers[loop.query];
    compared.push_back(std::move(loop));
  }
  if (!whole) return false;
  group.map = std::move(*joined.joint);
  group.pieces = std::move(numbers);
  return true;
}

/// A place that was compared again, with more around it, counts as it was last answered.
std::vector<Loop> last_answers(const std::vector<Loop>& compared) {
  std::map<std::pair<std::size_t, std::size_t>, Loop> answers;
  for (const Loop& loop : compared) {
    answers[std::minmax(loop.place, loop.query)] = loop;
  }
  std::vector<Loop> result;
  for (auto& [pair, loop] : answers) result.push_back(loop);
  return result;
}

}  // namespace

std::vector<std::size_t> stretches_of(const std::vector<Piece>& pieces) {
  std::vector<std::size_t> result;
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0 && pieces[i].restarted) ++stretch;
    result.push_back(stretch);
  }
  return result;
}

std::vector<Loop> join_stretches(const std::vector<Piece>& pieces, const PlaceIndex& places,
                                 PoseGraph& graph, const MergeOptions& options) {
  std::vector<Loop> compared;
  const std::vector<std::size_t> stretches = stretches_of(pieces);
  if (stretches.empty() || stretches.back() == 0) return compared;
  std::vector<Group> groups;
  for (std::size_t stretch = 0; stretch <= stretches.back(); ++stretch) {
    groups.push_back(group_of(pieces, stretches, stretch, places, graph));
    // What has grown may fit where it did not before, and with it what waited.
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t i = 0; i + 1 < groups.size() && !grown; ++i) {
        grown = join(pieces, groups[i], groups.back(), options, compared);
        if (!grown) continue;
        std::rotate(groups.begin() + static_cast<std::ptrdiff_t>(i),
                    groups.begin() + static_cast<std::ptrdiff_t>(i) + 1, groups.end() - 1);
        groups.pop_back();
      }
    }
  }
  for (const Group& group : groups) {
    for (std::size_t i = 0; i < group.pieces.size(); ++i) {
      graph.poses[group.pieces[i]] = group.map.pieces[i].T_world_piece;
    }
  }
  compared = last_answers(compared);
  for (const Loop& loop : compared) {
    if (is_taken(loop)) graph.edges.push_back(edge_of(loop));
  }
  return compared;
}

}  // namespace surefoot::mapping
