// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/held_pieces.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace surefoot::mapping {

bool holds(const PoseEdge& edge) {
  constexpr double kLeastHeld = 1e-6;
  return edge.information.trace() > kLeastHeld;
}

HeldPieces::HeldPieces(const PoseGraph& graph) : parent_(graph.poses.size()) {
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  for (const PoseEdge& edge : graph.edges) {
    if (!holds(edge)) continue;
    const auto [low, high] = std::minmax({set_of(edge.from), set_of(edge.to)});
    parent_[high] = low;
  }
}

std::size_t HeldPieces::set_of(std::size_t piece) {
  while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
  return piece;
}

std::vector<std::size_t> HeldPieces::held_to(std::size_t piece, std::size_t begin,
                                             std::size_t end) {
  std::vector<std::size_t> result;
  for (std::size_t i = begin; i < end; ++i) {
    if (set_of(i) == set_of(piece)) result.push_back(i);
  }
  return result;
}

std::vector<std::size_t> frames_of(const PoseGraph& graph) {
  HeldPieces held(graph);
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    frames.push_back(numbers.try_emplace(held.set_of(i), numbers.size()).first->second);
  }
  return frames;
}

}  // namespace surefoot::mapping
