// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_merge.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "mapping/loop_solution.hpp"
#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kLeastHeld = 1e-6;  // information of an edge that holds anything

bool holds(const PoseEdge& edge) { return edge.information.trace() > kLeastHeld; }

/// Sets of pieces that a graph holds together, by the smallest number in each. Where the odometry
/// began anew, nothing may.
class HeldPieces {
 public:
  explicit HeldPieces(const PoseGraph& graph) : parent_(graph.poses.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const PoseEdge& edge : graph.edges) {
      if (!holds(edge)) continue;
      const auto [low, high] = std::minmax({set_of(edge.from), set_of(edge.to)});
      parent_[high] = low;
    }
  }
  std::size_t set_of(std::size_t piece) {
    while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }
  /// Those from `begin` to before `end` that are held to a piece.
  std::vector<std::size_t> held_to(std::size_t piece, std::size_t begin, std::size_t end) {
    std::vector<std::size_t> result;
    for (std::size_t i = begin; i < end; ++i) {
      if (set_of(i) == set_of(piece)) result.push_back(i);
    }
    return result;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// A map's graph behind another's. What it knew is known.
void append_graph(const SavedMap& map, PoseGraph& graph) {
  const std::size_t offset = graph.poses.size();
  for (const Piece& piece : map.pieces) graph.poses.push_back(piece.T_world_piece);
  for (PoseEdge edge : map.edges) {
    if (edge.inlier && edge.to == edge.from + 1 && holds(edge)) {
      edge.way = std::max(map.pieces[edge.to].way - map.pieces[edge.from].way, 0.0);
    }
    edge.from += offset;
    edge.to += offset;
    edge.inlier = true;
    graph.edges.push_back(edge);
  }
}

/// Steps from each piece to the next by the corrected poses, as uncertain as the odometry's: by
/// these loops agree or not. Where the odometry began anew, or maps were joined before, loops hold
/// the pieces together, or nothing does.
PoseGraph steps_of(const PoseGraph& graph) {
  constexpr double kSeam = 0.2;       // [m] standard deviation where loops alone hold
  constexpr double kSeamTurn = 0.02;  // [rad]
  HeldPieces held(graph);
  std::vector<const PoseEdge*> step(graph.poses.size(), nullptr);
  for (const PoseEdge& edge : graph.edges) {
    if (holds(edge) && edge.way > 0.0) step[edge.from] = &edge;
  }
  PoseGraph steps;
  steps.poses = graph.poses;
  steps.systematic = graph.systematic;
  for (std::size_t i = 0; i + 1 < graph.poses.size(); ++i) {
    if (held.set_of(i) != held.set_of(i + 1)) continue;
    PoseEdge edge;
    if (step[i] != nullptr) {
      edge = *step[i];
    } else {
      Twist diagonal;
      diagonal << Eigen::Vector3d::Constant(1.0 / (kSeam * kSeam)),
          Eigen::Vector3d::Constant(1.0 / (kSeamTurn * kSeamTurn));
      edge.information = diagonal.asDiagonal();
    }
    edge.from = i;
    edge.to = i + 1;
    edge.T_from_to = graph.poses[i].inverse() * graph.poses[i + 1];
    steps.edges.push_back(edge);
  }
  return steps;
}

/// Where a loop puts the second map in the first's frame.
Pose claimed(const Loop& loop, const std::vector<Piece>& pieces) {
  return pieces[loop.place].T_world_piece * loop.check.alignment.T_target_source *
         pieces[loop.query].T_world_piece.inverse();
}

/// Whether a loop leaves it open that the second map lies so, in what it holds.
bool allows(const Loop& loop, const std::vector<Piece>& pieces, const Pose& T_first_second) {
  constexpr double kMetres = 1.0;
  constexpr double kDegrees = 5.0;
  const Pose T_place_query = pieces[loop.place].T_world_piece.inverse() * T_first_second *
                             pieces[loop.query].T_world_piece;
  const AlignmentGap gap = gap_between(loop.check.alignment, T_place_query);
  return gap.metres <= kMetres && gap.degrees <= kDegrees;
}

bool taken(const Loop& loop) { return loop.check.verdict == LoopVerdict::taken; }

/// Whether the two places fit as well the other way round, or a quarter turned. Within a walk the
/// odometry would tell; here nothing does.
bool fits_turned(const Loop& loop, const VerifiableSubmap& place, const VerifiableSubmap& seen,
                 const LoopLimits& limits) {
  for (const int quarters : {1, 2, 3}) {
    Pose start = loop.check.alignment.T_target_source;
    start.rotation = start.rotation *
                     Eigen::AngleAxisd(quarters * std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
    const LoopCheck check = check_places(place, seen, turned_both_ways(start), limits);
    const AlignmentGap gap = gap_between(check.alignment, loop.check.alignment.T_target_source);
    if (check.verdict == LoopVerdict::taken && gap.degrees > 45.0) return true;
  }
  return false;
}

/// Two places of the first map that fit one of the second tell nothing if they lie apart.
void refuse_ambiguous(std::size_t begin, const std::vector<Piece>& pieces,
                      std::vector<Loop>& loops) {
  std::vector<std::size_t> ambiguous;
  for (std::size_t a = begin; a < loops.size(); ++a) {
    for (std::size_t b = begin; b < loops.size(); ++b) {
      if (a != b && taken(loops[a]) && taken(loops[b]) &&
          !allows(loops[a], pieces, claimed(loops[b], pieces))) {
        ambiguous.push_back(a);
      }
    }
  }
  for (const std::size_t loop : ambiguous) loops[loop].check.verdict = LoopVerdict::ambiguous;
}

std::vector<Loop> find_loops(const SavedMap& first, TwoMaps& maps, const MergeOptions& options) {
  PlaceIndex index;
  for (const PlaceDescriptor& place : first.places) index.add(place);
  std::vector<Loop> loops;
  for (std::size_t query = maps.first(); query < maps.pieces().size(); ++query) {
    const auto seen = maps.submap(query);
    const std::size_t begin = loops.size();
    for (const PlaceIndex::Match& match :
         distinct_places(index, first.pieces, seen->submap(), options.candidates)) {
      const auto place = maps.submap(match.place);
      Loop loop;
      loop.place = match.place;
      loop.query = query;
      loop.likeness = match.distance;
      loop.check = check_match(match, *place, *seen, options.limits);
      // What nothing holds (the way along a corridor) fits elsewhere as well.
      if (taken(loop) &&
          (loop.check.alignment.held < 6 || fits_turned(loop, *place, *seen, options.limits))) {
        loop.check.verdict = LoopVerdict::ambiguous;
      }
      loops.push_back(loop);
    }
    refuse_ambiguous(begin, maps.pieces(), loops);
  }
  return loops;
}

/// How far the places lie apart in which the loops begin, at most [m].
double spread_of(const std::vector<Loop>& loops, const std::vector<Piece>& pieces) {
  double most = 0.0;
  for (const Loop& a : loops) {
    for (const Loop& b : loops) {
      if (!taken(a) || !taken(b)) continue;
      const Eigen::Vector3d apart =
          pieces[a.query].T_world_piece.translation - pieces[b.query].T_world_piece.translation;
      most = std::max(most, apart.norm());
    }
  }
  return most;
}

/// The pieces walked about a place of the second map, over which the odometry keeps it together.
std::vector<std::size_t> pieces_about(const TwoMaps& maps, std::size_t query) {
  constexpr double kWay = 30.0;  // [m]
  const std::vector<Piece>& pieces = maps.pieces();
  std::size_t begin = query;
  std::size_t end = query + 1;
  while (!pieces[begin].restarted && pieces[query].way - pieces[begin - 1].way < kWay) --begin;
  while (end < pieces.size() && !pieces[end].restarted &&
         pieces[end].way - pieces[query].way < kWay) {
    ++end;
  }
  std::vector<std::size_t> result(end - begin);
  std::iota(result.begin(), result.end(), begin);
  return result;
}

bool fits(const MapComparison& comparison, const MergeOptions& options) {
  return comparison.near > 0 && comparison.contradicted <= options.contradicted &&
         comparison.overlap >= options.overlap;
}

/// Whether a place that fitted when it was asked alone would have the second map lie elsewhere, and
/// the maps bear it out as far as it can see.
bool fits_elsewhere(const std::vector<Loop>& asked_alone, const Pose& T_first_second,
                    HeldPieces& held, TwoMaps& maps, const MergeOptions& options) {
  return std::any_of(asked_alone.begin(), asked_alone.end(), [&](const Loop& loop) {
    const bool fitted = taken(loop) || loop.check.verdict == LoopVerdict::ambiguous;
    if (!fitted || allows(loop, maps.pieces(), T_first_second)) return false;
    const MapComparison comparison =
        maps.compare(claimed(loop, maps.pieces()), held.held_to(loop.place, 0, maps.first()),
                     pieces_about(maps, loop.query));
    return fits(comparison, options);
  });
}

/// Why the maps stay apart though loops agree; empty: nothing speaks against it. `solved` is the
/// graph with the loops in it.
std::string objection(const std::vector<Loop>& asked_alone, const Pose& T_first_second,
                      const PoseGraph& solved, TwoMaps& maps, MapJoin& join,
                      const MergeOptions& options) {
  if (join.taken < 2) return "no two places agree on how they lie";
  if (spread_of(join.loops, maps.pieces()) < options.spread) {
    return "the places that agree are one place: too little to tell it from its likes";
  }
  std::vector<Piece> moved = join.pieces;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i].T_world_piece = solved.poses[i];
  HeldPieces held(solved);
  const std::size_t place = std::find_if(join.loops.begin(), join.loops.end(), taken)->place;
  TwoMaps both(moved, join.first);
  join.comparison = both.compare(Pose{}, held.held_to(place, 0, join.first),
                                 held.held_to(place, join.first, moved.size()));
  if (!fits(join.comparison, options)) {
    return "some places agree, but what else both maps have seen does not";
  }
  if (fits_elsewhere(asked_alone, T_first_second, held, maps, options)) {
    return "they fit in more than one way: places look alike";
  }
  return "";
}

/// Both maps at the graph's poses, without what nothing holds to the first.
void fill_joint(const SavedMap& first, const SavedMap& second, const PoseGraph& graph,
                MapJoin& join) {
  HeldPieces held(graph);
  const std::size_t place = std::find_if(join.loops.begin(), join.loops.end(), taken)->place;
  SavedMap joint;
  std::vector<std::optional<std::size_t>> number(join.pieces.size());
  for (std::size_t i = 0; i < join.pieces.size(); ++i) {
    const bool kept = i < join.first || held.set_of(i) == held.set_of(place);
    if (i >= join.first) {
      join.placed.push_back(kept ? std::optional(graph.poses[i]) : std::nullopt);
    }
    if (!kept) continue;
    number[i] = joint.pieces.size();
    joint.pieces.push_back(join.pieces[i]);
    joint.pieces.back().T_world_piece = graph.poses[i];
    joint.places.push_back(i < join.first ? first.places[i] : second.places[i - join.first]);
    // What came before it may be gone.
    if (i > 0 && !number[i - 1]) joint.pieces.back().restarted = true;
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    PoseEdge edge = graph.edges[e];
    if (!number[edge.from] || !number[edge.to]) continue;
    edge.from = *number[edge.from];
    edge.to = *number[edge.to];
    const std::size_t firsts = first.edges.size();
    const std::size_t known = firsts + second.edges.size();
    edge.inlier = e < firsts ? first.edges[e].inlier : e < known && second.edges[e - firsts].inlier;
    joint.edges.push_back(edge);
  }
  join.joint = std::move(joint);
}

}  // namespace

MapJoin join_maps(const SavedMap& first, const SavedMap& second, const MergeOptions& options) {
  MapJoin join;
  join.first = first.pieces.size();
  PoseGraph graph;
  graph.systematic = systematic_drift(options.drift);
  append_graph(first, graph);
  append_graph(second, graph);
  join.pieces = first.pieces;
  join.pieces.insert(join.pieces.end(), second.pieces.begin(), second.pieces.end());
  if (join.first < join.pieces.size()) join.pieces[join.first].restarted = true;
  TwoMaps maps(join.pieces, join.first);
  join.loops = find_loops(first, maps, options);
  const std::vector<Loop> asked_alone = join.loops;
  const std::vector<std::size_t> agreeing = keep_consistent(steps_of(graph), join.loops);
  Pose T_first_second;
  if (!agreeing.empty()) {
    T_first_second = claimed(join.loops[agreeing[agreeing.size() / 2]], join.pieces);
    for (std::size_t i = join.first; i < graph.poses.size(); ++i) {
      graph.poses[i] = T_first_second * graph.poses[i];
    }
    take_loops(graph, join.loops, agreeing);
  }
  join.taken = static_cast<std::size_t>(std::count_if(join.loops.begin(), join.loops.end(), taken));
  join.message = objection(asked_alone, T_first_second, graph, maps, join, options);
  if (join.message.empty()) {
    fill_joint(first, second, graph, join);
    return join;
  }
  for (Loop& loop : join.loops) {
    if (taken(loop)) loop.check.verdict = LoopVerdict::not_joined;
  }
  join.taken = 0;
  return join;
}

}  // namespace surefoot::mapping
