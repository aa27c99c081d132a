// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What was seen for moments, and through in others: it came, or went. Asked over a whole map, of
// what was seen before and after, on the same visit or another.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "mapping/piece.hpp"
#include "mapping/pose_graph.hpp"
#include "mapping/thing_sight.hpp"

namespace surefoot::mapping {

class MovedThings {
 public:
  /// The pieces stand where they belong, those of the same `held` against each other, and outlive
  /// this.
  MovedThings(const std::vector<Piece>& pieces, std::vector<std::size_t> held)
      : pieces_(pieces), held_(std::move(held)) {}

  /// Of points that were seen from a piece, in its frame [m], those that have moved away. Beams
  /// went through where they are in some moments at least, and twice as many as those in which
  /// something was hit, whoever else walked by; what stands there from the piece on stays all the
  /// same. Or later pieces hardly see anything there but beams going through. The ground never
  /// does. Pieces stand in the order in which they were walked.
  [[nodiscard]] std::vector<bool> gone(std::size_t piece,
                                       const std::vector<Eigen::Vector3f>& points);

 private:
  /// What was seen of things from a piece; null if nobody looked.
  [[nodiscard]] const ThingSight* sight(std::size_t piece);
  [[nodiscard]] std::vector<std::size_t> witnesses(std::size_t piece) const;

  const std::vector<Piece>& pieces_;
  std::vector<std::size_t> held_;
  std::vector<std::pair<std::size_t, std::unique_ptr<const ThingSight>>> kept_;
};

/// Of each piece of a graph, which are held together: the same number.
[[nodiscard]] std::vector<std::size_t> held_together(const PoseGraph& graph);

/// Drops what has moved away from the pieces' clouds.
void drop_moved(std::vector<Piece>& pieces, MovedThings& moved,
                const std::shared_ptr<CloudFile>& file);

}  // namespace surefoot::mapping
