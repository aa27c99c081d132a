// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_placement.hpp"

#include <algorithm>

#include "mapping/held_pieces.hpp"
#include "mapping/loop_solution.hpp"

namespace surefoot::mapping {

namespace {

/// Where a loop puts the second map in the first's frame.
Pose claimed(const Loop& loop, const std::vector<Piece>& pieces) {
  return pieces[loop.place].T_world_piece * loop.check.alignment.T_target_source *
         pieces[loop.query].T_world_piece.inverse();
}

/// How far the places lie apart in which the loops begin, at most [m].
double spread_of(const std::vector<Loop>& loops, const std::vector<Piece>& pieces) {
  std::vector<Eigen::Vector3d> places;
  for (const Loop& loop : loops) {
    if (is_taken(loop)) places.push_back(pieces[loop.query].T_world_piece.translation);
  }
  double most = 0.0;
  for (const Eigen::Vector3d& a : places) {
    for (const Eigen::Vector3d& b : places) most = std::max(most, (a - b).norm());
  }
  return most;
}

/// The maps as the loops that agree have them lie, moved by these together.
MapPlacement placed_by(const MapPair& pair, std::vector<Loop> loops,
                       const std::vector<std::size_t>& agreeing) {
  MapPlacement result;
  result.solved = pair.graph;
  const Pose T_first_second = claimed(loops[agreeing[agreeing.size() / 2]], pair.pieces);
  for (std::size_t i = pair.first; i < result.solved.poses.size(); ++i) {
    result.solved.poses[i] = T_first_second * result.solved.poses[i];
  }
  take_loops(result.solved, loops, agreeing);
  result.taken = static_cast<std::size_t>(std::count_if(loops.begin(), loops.end(), is_taken));
  result.spread = spread_of(loops, pair.pieces);
  result.pieces = pair.pieces;
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    result.pieces[i].T_world_piece = result.solved.poses[i];
  }
  if (result.taken > 0) {
    HeldPieces held(result.solved);
    const std::size_t place = std::find_if(loops.begin(), loops.end(), is_taken)->place;
    result.of_first = held.held_to(place, 0, pair.first);
    result.of_second = held.held_to(place, pair.first, result.pieces.size());
    result.comparison = TwoMaps(result.pieces).compare(result.of_first, result.of_second);
  }
  result.loops = std::move(loops);
  return result;
}

}  // namespace

std::vector<MapPlacement> find_placements(const MapPair& pair, const std::vector<Loop>& loops,
                                          std::size_t most) {
  std::vector<MapPlacement> placements;
  std::vector<Loop> others = loops;
  while (placements.size() < most) {
    std::vector<Loop> judged = others;
    const std::vector<std::size_t> agreeing = keep_consistent(pair.steps, judged);
    if (agreeing.empty()) break;
    for (const std::size_t i : agreeing) others[i].check.verdict = LoopVerdict::outvoted;
    placements.push_back(placed_by(pair, std::move(judged), agreeing));
  }
  return placements;
}

}  // namespace surefoot::mapping
