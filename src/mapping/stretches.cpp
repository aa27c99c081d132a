// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "mapping/loop_solution.hpp"
#include "mapping/map_comparison.hpp"
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
    // The odometry knows; who came home may have been carried.
    if (!pieces[after].restarted && after == before + 1) continue;
    if (pieces[after].frame == pieces[before].frame) continue;
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

/// Where the joined stretches, of which the second begins at piece `first`, lie near each other,
/// asked once more: now it is known where from. Not where a loop is `known`.
std::vector<Loop> look_again(const SavedMap& joint, std::size_t first,
                             const std::vector<Loop>& known, const MergeOptions& options) {
  constexpr double kMetres = 1.0;
  constexpr double kDegrees = 5.0;
  std::vector<Loop> loops;
  const std::vector<Piece>& pieces = joint.pieces;
  for (std::size_t query = first; query < pieces.size(); ++query) {
    const auto near = nearest_place(pieces, first, pieces[query].T_world_piece.translation);
    if (!near || is_taken(known, *near, query)) continue;
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

/// Adds loops to a joined map that had been overlooked, and what the odometry knows of how its
/// parts lie; false if the loops outvote that.
bool tighten(SavedMap& joint, std::vector<Loop>& loops, const std::optional<PoseEdge>& homecoming) {
  PoseGraph graph;
  for (const Piece& piece : joint.pieces) graph.poses.push_back(piece.T_world_piece);
  graph.edges = joint.edges;
  for (PoseEdge& edge : graph.edges) edge.inlier = true;
  std::vector<PoseEdge> edges;
  if (homecoming) edges.push_back(*homecoming);
  std::vector<Loop*> chosen;
  for (Loop& loop : loops) {
    if (!is_taken(loop)) continue;
    chosen.push_back(&loop);
    edges.push_back(edge_of(loop));
  }
  const std::vector<LoopVerdict> verdicts = solve_with_loops(graph, edges);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    chosen[k]->check.verdict = verdicts[edges.size() - chosen.size() + k];
  }
  for (std::size_t i = 0; i < joint.pieces.size(); ++i) {
    joint.pieces[i].T_world_piece = graph.poses[i];
  }
  for (const Loop& loop : loops) {
    if (is_taken(loop)) joint.edges.push_back(edge_of(loop));
  }
  const bool holds = homecoming && (verdicts.front() == LoopVerdict::taken ||
                                    std::none_of(loops.begin(), loops.end(),
                                                 [](const Loop& loop) { return is_taken(loop); }));
  if (holds) joint.edges.push_back(*homecoming);
  return holds;
}

/// Both as one in `group`, if they can be joined, else both as they were; the loops that were
/// compared go to `compared`. What was walked first stays where it is.
bool join(const std::vector<Piece>& walk, Group& group, Group& other, const MergeOptions& options,
          std::vector<Loop>& compared) {
  const bool swapped = other.pieces.front() < group.pieces.front();
  if (swapped) std::swap(group, other);
  MapJoin joined = join_maps(group.map, other.map, options);
  std::vector<std::size_t> numbers = group.pieces;
  numbers.insert(numbers.end(), other.pieces.begin(), other.pieces.end());
  const bool whole = joined.joint && joined.joint->pieces.size() == numbers.size() &&
                     reachable(walk, numbers, joined.joint->pieces);
  if (whole) {
    std::vector<Loop> again = look_again(*joined.joint, joined.first, joined.loops, options);
    (void)tighten(*joined.joint, again, std::nullopt);
    joined.loops.insert(joined.loops.end(), again.begin(), again.end());
  }
  for (Loop& loop : joined.loops) {
    if (!whole && is_taken(loop)) loop.check.verdict = LoopVerdict::not_joined;
    loop.place = numbers[loop.place];
    loop.query = numbers[loop.query];
    compared.push_back(std::move(loop));
  }
  if (!whole) {
    if (swapped) std::swap(group, other);
    return false;
  }
  group.map = std::move(*joined.joint);
  group.pieces = std::move(numbers);
  return true;
}

/// Both stretches' maps as one, the second where the odometry says that it lies; its edge is by
/// their numbers in it.
SavedMap laid_by(const PoseEdge& homecoming, const SavedMap& group, const SavedMap& other) {
  SavedMap joint = group;
  const std::size_t first = group.pieces.size();
  const Pose T_group_other = group.pieces[homecoming.from].T_world_piece * homecoming.T_from_to *
                             other.pieces[homecoming.to - first].T_world_piece.inverse();
  for (const Piece& piece : other.pieces) {
    joint.pieces.push_back(piece);
    joint.pieces.back().T_world_piece = T_group_other * piece.T_world_piece;
  }
  joint.places.insert(joint.places.end(), other.places.begin(), other.places.end());
  for (PoseEdge edge : other.edges) {
    edge.from += first;
    edge.to += first;
    joint.edges.push_back(edge);
  }
  return joint;
}

/// Whether what both parts of a joined map have seen is the same, as far as they lie together.
bool agrees(const SavedMap& joint, std::size_t first, const MergeOptions& options) {
  std::vector<std::size_t> numbers(joint.pieces.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(first);
  const MapComparison seen =
      TwoMaps(joint.pieces).compare({numbers.begin(), middle}, {middle, numbers.end()});
  return seen.near == 0 ||
         (seen.contradicted <= options.contradicted && seen.overlap >= options.overlap);
}

/// A stretch that came home as one with the group that it came home to, unless what both have seen
/// speaks against it; loops that they share are looked for from there, and may outvote it. Whether
/// it is the right storey, the odometry has asked. The homecoming goes to the graph if it holds.
bool come_home(const PoseEdge& homecoming, Group& group, const Group& other, MergeOptions options,
               std::vector<Loop>& compared, PoseGraph& graph) {
  const std::size_t first = group.pieces.size();
  PoseEdge edge = homecoming;
  edge.from = static_cast<std::size_t>(
      std::find(group.pieces.begin(), group.pieces.end(), homecoming.from) - group.pieces.begin());
  edge.to = first;
  SavedMap joint = laid_by(edge, group.map, other.map);
  if (!agrees(joint, first, options)) return false;
  options.roofed = true;
  std::vector<Loop> loops = look_again(joint, first, {}, options);
  if (tighten(joint, loops, edge)) graph.edges.push_back(homecoming);
  group.map = std::move(joint);
  group.pieces.insert(group.pieces.end(), other.pieces.begin(), other.pieces.end());
  for (Loop& loop : loops) {
    loop.place = group.pieces[loop.place];
    loop.query = group.pieces[loop.query];
    compared.push_back(std::move(loop));
  }
  return true;
}

/// The last group has become part of this one, which is now the last.
void put_last(std::vector<Group>& groups, std::size_t grown) {
  std::rotate(groups.begin() + static_cast<std::ptrdiff_t>(grown),
              groups.begin() + static_cast<std::ptrdiff_t>(grown) + 1, groups.end() - 1);
  groups.pop_back();
}

/// The group that holds a piece.
std::size_t group_with(std::size_t piece, const std::vector<Group>& groups) {
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
    return std::find(group.pieces.begin(), group.pieces.end(), piece) != group.pieces.end();
  });
  return static_cast<std::size_t>(found - groups.begin());
}

/// A place that was compared again, with more around it, counts as it was last answered.
std::vector<Loop> last_answers(const std::vector<Loop>& compared) {
  std::map<std::pair<std::size_t, std::size_t>, Loop> answers;
  for (const Loop& loop : compared) {
    answers[std::minmax(loop.place, loop.query)] = loop;
  }
  std::vector<Loop> result;
  result.reserve(answers.size());
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
  const std::vector<PoseEdge> homes = homecomings(pieces, options.drift);
  std::vector<Group> groups;
  for (std::size_t stretch = 0; stretch <= stretches.back(); ++stretch) {
    groups.push_back(group_of(pieces, stretches, stretch, places, graph));
    for (const PoseEdge& home : homes) {
      if (stretches[home.to] != stretch) continue;
      const std::size_t i = group_with(home.from, groups);
      if (come_home(home, groups[i], groups.back(), options, compared, graph)) put_last(groups, i);
    }
    // What has grown may fit where it did not before, and with it what waited.
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t i = 0; i + 1 < groups.size() && !grown; ++i) {
        grown = join(pieces, groups[i], groups.back(), options, compared);
        if (grown) put_last(groups, i);
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
