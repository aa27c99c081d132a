// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Two maps laid over each other: whether what both have seen is the same.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "mapping/loop_verifier.hpp"
#include "mapping/piece.hpp"

namespace surefoot::mapping {

/// Over the pieces of one map that lie near one of the other.
struct MapComparison {
  std::size_t near = 0;       ///< places that were compared
  double contradicted = 0.0;  ///< contradiction_between() of them, mean
  double overlap = 0.0;       ///< overlap_between(), mean
};

/// Pieces of two maps, those of the first before those of the second.
class TwoMaps {
 public:
  /// The pieces must outlive this.
  TwoMaps(const std::vector<Piece>& pieces, std::size_t first) : pieces_(pieces), first_(first) {}

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] std::size_t first() const { return first_; }

  /// A piece with its neighbours. Some are kept, since they are asked for again.
  [[nodiscard]] std::shared_ptr<const VerifiableSubmap> submap(std::size_t piece);

  /// What both have seen if the second map lies so in the first's frame, by these pieces of both.
  [[nodiscard]] MapComparison compare(const Pose& T_first_second,
                                      const std::vector<std::size_t>& of_first,
                                      const std::vector<std::size_t>& of_second);

 private:
  const std::vector<Piece>& pieces_;
  std::size_t first_;
  std::deque<std::pair<std::size_t, std::shared_ptr<const VerifiableSubmap>>> kept_;
};

}  // namespace surefoot::mapping
