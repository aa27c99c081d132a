// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_merge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mapping/held_pieces.hpp"
#include "mapping/loop_solution.hpp"
#include "mapping/map_placement.hpp"

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

/// Whether a loop leaves it open that its pieces lie so, in what it holds.
bool allows(const Loop& loop, const std::vector<Piece>& pieces) {
  constexpr double kMetres = 1.0;
  constexpr double kDegrees = 5.0;
  const Pose T_place_query =
      pieces[loop.place].T_world_piece.inverse() * pieces[loop.query].T_world_piece;
  const AlignmentGap gap = gap_between(loop.check.alignment, T_place_query);
  return gap.metres <= kMetres && gap.degrees <= kDegrees;
}

/// Whether a place that fitted when it was asked alone would have the second map lie elsewhere, and
/// does not fit clearly better as the maps lie now. Places look alike here: of which there may be
/// more, and that these agree is no longer a sign that they are the same; unless by far more of
/// both maps agree than may well look alike.
bool fits_elsewhere(const std::vector<Loop>& asked_alone, const MapPlacement& placement,
                    const MergeOptions& options) {
  TwoMaps joint(placement.pieces);
  const auto& first = placement.of_first;
  const auto& second = placement.of_second;
  return std::any_of(asked_alone.begin(), asked_alone.end(), [&](const Loop& loop) {
    const bool fitted = is_taken(loop) || loop.check.verdict == LoopVerdict::ambiguous;
    if (!fitted || allows(loop, placement.pieces)) return false;
    if (!std::binary_search(second.begin(), second.end(), loop.query)) return false;
    if (!std::binary_search(first.begin(), first.end(), loop.place)) return false;
    if (loop.check.overlap < options.likes * placement.support()) return false;
    const MapComparison as_they_lie = joint.compare(placement.of_first, {loop.query});
    return loop.check.overlap > options.as_good * as_they_lie.overlap;
  });
}

/// Whether most of the second map lies elsewhere by the one placement than by the other; maps that
/// are bent lie a little otherwise by each of their loops.
bool lie_apart(const MapPlacement& one, const MapPlacement& other) {
  constexpr double kBent = 2.0;  // [m]
  std::vector<double> apart;
  for (const std::size_t i : one.of_second) {
    apart.push_back((one.solved.poses[i].translation - other.solved.poses[i].translation).norm());
  }
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::nth_element(apart.begin(), middle, apart.end());
  return *middle > kBent;
}

/// Whether both tell how the same pieces lie. What nothing joins is as a map of its own: that it
/// lies elsewhere speaks neither for nor against.
bool are_of_the_same(const MapPlacement& one, const MapPlacement& other) {
  return one.of_first == other.of_first && one.of_second == other.of_second;
}

/// Whether the pieces would lie otherwise as well.
bool is_doubtful(const MapPlacement& best, const std::vector<const MapPlacement*>& fitting,
                 const std::vector<Loop>& asked_alone, const MergeOptions& options) {
  const bool otherwise =
      std::any_of(fitting.begin(), fitting.end(), [&](const MapPlacement* placement) {
        return placement->support() > options.likes * best.support() &&
               are_of_the_same(best, *placement) && lie_apart(best, *placement);
      });
  return otherwise || fits_elsewhere(asked_alone, best, options);
}

/// The way in which the maps may lie by which most of them agrees; behind it those of the second
/// map's other frames in the same one of the first. None, and why, where none fits, or another one
/// fits as well.
std::vector<const MapPlacement*> choose(const std::vector<MapPlacement>& placements,
                                        const std::vector<Loop>& asked_alone,
                                        const MergeOptions& options, std::string& why_not) {
  std::vector<const MapPlacement*> fitting, chosen;
  for (const MapPlacement& placement : placements) {
    if (fits(placement, options)) fitting.push_back(&placement);
  }
  if (fitting.empty()) {
    why_not = placements.empty() ? "no two places agree on how they lie"
                                 : objection(placements.front(), options);
    return {};
  }
  std::stable_sort(fitting.begin(), fitting.end(), [](const auto* one, const auto* other) {
    return one->support() > other->support();
  });
  for (auto next = fitting.begin(); next != fitting.end(); ++next) {
    const bool is_second_best = std::any_of(fitting.begin(), next, [&](const auto* better) {
      return are_of_the_same(*better, **next);
    });
    if (is_second_best) continue;
    if (!chosen.empty() && (*next)->of_first != chosen.front()->of_first) continue;
    if (!is_doubtful(**next, fitting, asked_alone, options)) {
      chosen.push_back(*next);
    } else if (chosen.empty()) {
      why_not = "places look alike: some would have the maps lie otherwise";
      return {};
    }
  }
  return chosen;
}

/// The graph by all that was chosen. `join`: gets what came of its loops.
PoseGraph solve_together(const std::vector<const MapPlacement*>& chosen, MapJoin& join) {
  PoseGraph graph = chosen.front()->solved;
  for (std::size_t k = 1; k < chosen.size(); ++k) {
    const MapPlacement& next = *chosen[k];
    for (const std::size_t i : next.of_second) graph.poses[i] = next.solved.poses[i];
    std::vector<std::size_t> agreeing;
    for (std::size_t i = 0; i < next.loops.size(); ++i) {
      if (is_taken(next.loops[i])) agreeing.push_back(i);
    }
    take_loops(graph, join.loops, agreeing);
    join.comparison.near += next.comparison.near;
  }
  join.taken =
      static_cast<std::size_t>(std::count_if(join.loops.begin(), join.loops.end(), is_taken));
  return graph;
}

/// Both maps at the graph's poses, without what nothing holds to the first.
void fill_joint(const SavedMap& first, const SavedMap& second, const PoseGraph& graph,
                MapJoin& join) {
  HeldPieces held(graph);
  SavedMap joint;
  std::vector<std::optional<std::size_t>> number(join.pieces.size());
  for (std::size_t i = 0; i < join.pieces.size(); ++i) {
    const bool kept = held.set_of(i) < join.first;
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
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (placed[i]) return *placed[i] * pieces[first + i].T_world_piece.inverse();
  }
  return std::nullopt;
}

std::size_t MapJoin::held() const {
  return static_cast<std::size_t>(
      std::count_if(placed.begin(), placed.end(),
                    [](const std::optional<Pose>& pose) { return pose.has_value(); }));
}

MapJoin join_maps(const SavedMap& first, const SavedMap& second, const MergeOptions& options) {
  MapJoin join;
  join.first = first.pieces.size();
  join.pieces = first.pieces;
  join.pieces.insert(join.pieces.end(), second.pieces.begin(), second.pieces.end());
  if (join.first < join.pieces.size()) join.pieces[join.first].restarted = true;
  MapPair pair{join.pieces, join.first, {}, {}};
  pair.graph.systematic = systematic_drift(options.drift);
  append_graph(first, pair.graph);
  append_graph(second, pair.graph);
  pair.steps = steps_of(pair.graph);
  join.loops = find_joint_places(first, pair, options);
  const std::vector<Loop> asked_alone = join.loops;
  const std::vector<MapPlacement> placements =
      find_placements(pair, asked_alone, options.placements);
  const std::vector<const MapPlacement*> chosen =
      choose(placements, asked_alone, options, join.message);
  if (!placements.empty()) {
    const MapPlacement& shown = chosen.empty() ? placements.front() : *chosen.front();
    join.loops = shown.loops;
    join.comparison = shown.comparison;
  }
  if (!chosen.empty()) {
    fill_joint(first, second, solve_together(chosen, join), join);
    return join;
  }
  for (Loop& loop : join.loops) {
    if (is_taken(loop)) loop.check.verdict = LoopVerdict::not_joined;
  }
  return join;
}

}  // namespace surefoot::mapping
