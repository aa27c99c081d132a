// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which pieces of way a graph holds together. Where the odometry began anew, nothing may.
#pragma once

#include <cstddef>
#include <vector>

#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Whether an edge has information enough to hold anything.
[[nodiscard]] bool holds(const PoseEdge& edge);

class HeldPieces {
 public:
  explicit HeldPieces(const PoseGraph& graph);
  /// The smallest number of those that are held together with a piece.
  [[nodiscard]] std::size_t set_of(std::size_t piece);
  /// Those from `begin` to before `end` that are held to a piece.
  [[nodiscard]] std::vector<std::size_t> held_to(std::size_t piece, std::size_t begin,
                                                 std::size_t end);

 private:
  std::vector<std::size_t> parent_;
};

/// Of each piece of a graph the number of its frame, of those that nothing joins, as they come.
[[nodiscard]] std::vector<std::size_t> frames_of(const PoseGraph& graph);

}  // namespace surefoot::mapping
