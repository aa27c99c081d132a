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
  std::size_t near = 0;       ///< places of the second that lie on one of the first
  double contradicted = 0.0;  ///< contradiction_between() of them, mean
  double overlap = 0.0;       ///< overlap_between(), mean
};

/// Pieces of two maps.
class TwoMaps {
 public:
  /// The pieces must outlive this.
  explicit TwoMaps(const std::vector<Piece>& pieces) : pieces_(pieces) {}

  /// A piece with its neighbours. Some are kept, since they are asked for again.
  [[nodiscard]] std::shared_ptr<const VerifiableSubmap> submap(std::size_t piece);

  /// What both have seen as the pieces lie, by these of both.
  [[nodiscard]] MapComparison compare(const std::vector<std::size_t>& of_first,
                                      const std::vector<std::size_t>& of_second);

 private:
  const std::vector<Piece>& pieces_;
  std::deque<std::pair<std::size_t, std::shared_ptr<const VerifiableSubmap>>> kept_;
};

}  // namespace surefoot::mapping
