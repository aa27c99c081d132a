// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_merge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mapping/held_pieces.hpp"
#include "mapping/look_alikes.hpp"
#include "mapping/loop_solution.hpp"
#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

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

/// Whether the two places would fit otherwise as well.
bool looks_alike(const LoopCheck& check, const VerifiableSubmap& place,
                 const VerifiableSubmap& seen, const MergeOptions& options) {
  if (check.alignment.held < 6) return true;  // along a corridor, say
  return overlap_slid(check, place, seen) > options.as_good * check.overlap ||
         fits_turned(check, place, seen, options.limits);
}

std::vector<Loop> find_loops(const SavedMap& first, TwoMaps& maps, const MergeOptions& options) {
  PlaceIndex index;
  for (const PlaceDescriptor& place : first.places) index.add(place);
  std::vector<Loop> loops;
  for (std::size_t query = maps.first(); query < maps.pieces().size(); ++query) {
    const auto seen = maps.submap(query);
    for (const PlaceIndex::Match& match :
         distinct_places(index, first.pieces, seen->submap(), options.candidates)) {
      const auto place = maps.submap(match.place);
      Loop loop;
      loop.place = match.place;
      loop.query = query;
      loop.likeness = match.distance;
      loop.check = check_match(match, *place, *seen, options.limits);
      const bool under_roof = place->submap().covered && seen->submap().covered;
      if (taken(loop) && under_roof && !options.roofed) {
        loop.check.verdict = LoopVerdict::other_storey;
      } else if (taken(loop) && looks_alike(loop.check, *place, *seen, options)) {
        loop.check.verdict = LoopVerdict::ambiguous;
      }
      loops.push_back(loop);
    }
    if (options.on_piece) {
      options.on_piece(query + 1 - maps.first(), maps.pieces().size() - maps.first());
    }
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

bool fits(const MapComparison& comparison, const MergeOptions& options) {
  return comparison.near > 0 && comparison.contradicted <= options.contradicted &&
         comparison.overlap >= options.overlap;
}

/// Whether a place that fitted when it was asked alone would have the second map lie elsewhere, and
/// does not fit clearly better as the maps lie now. Places look alike here: of which there may be
/// more, and that these agree is no longer a sign that they are the same.
bool fits_elsewhere(const std::vector<Loop>& asked_alone, const Pose& T_first_second,
                    const std::vector<std::size_t>& of_first, TwoMaps& maps,
                    const MergeOptions& options) {
  return std::any_of(asked_alone.begin(), asked_alone.end(), [&](const Loop& loop) {
    const bool fitted = taken(loop) || loop.check.verdict == LoopVerdict::ambiguous;
    if (!fitted || allows(loop, maps.pieces(), T_first_second)) return false;
    const MapComparison as_they_lie = maps.compare(T_first_second, of_first, {loop.query});
    return loop.check.overlap > options.as_good * as_they_lie.overlap;
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
  if (fits_elsewhere(asked_alone, T_first_second, held.held_to(place, 0, join.first), maps,
                     options)) {
    return "places look alike: some would have the maps lie otherwise";
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

std::optional<Pose> MapJoin::begin() const {
  const auto found = std::find_if(placed.begin(), placed.end(),
                                  [](const std::optional<Pose>& pose) { return pose.has_value(); });
  return found != placed.end() ? *found : std::nullopt;
}

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
