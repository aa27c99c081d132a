// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Looks, for every new piece of way, whether the robot was there before.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "mapping/drift_model.hpp"
#include "mapping/loop_verifier.hpp"
#include "mapping/piece.hpp"
#include "mapping/place_index.hpp"

namespace surefoot::mapping {

inline constexpr double kHalfStorey = 1.2;  // [m]

struct LoopOptions {
  LoopLimits limits;
  DriftModel drift;
  double way_between = 25.0;          ///< a place is not its own neighbour [m]
  double near = 8.0;                  ///< pieces so far apart still see the same [m]
  std::size_t candidates = 3;         ///< of each piece that are verified
  std::shared_ptr<CloudFile> clouds;  ///< where pieces are put away; none: in memory
};

/// A candidate, what was asked of it and what came of it.
struct Loop {
  std::size_t place = 0;  ///< the earlier piece
  std::size_t query = 0;
  double likeness = 1.0;    ///< distance of the descriptors, 0: the same
  double drift_chi2 = 0.0;  ///< of the motion that it claims, by the odometry's drift
  Matrix6 drift = Matrix6::Zero();
  LoopCheck check;
};
[[nodiscard]] inline bool is_taken(const Loop& loop) {
  return loop.check.verdict == LoopVerdict::taken;
}

/// As a graph takes it; it may still be false.
[[nodiscard]] PoseEdge edge_of(const Loop& loop);

class LoopFinder {
 public:
  explicit LoopFinder(LoopOptions options) : options_(std::move(options)) {}

  /// Looks for the piece before this one, whose neighbours are all there now.
  void add(Piece piece);
  /// Looks for the last piece.
  void finish();

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// Motions between the pieces, each to the next.
  [[nodiscard]] const std::vector<PoseEdge>& odometry() const { return odometry_; }
  /// All candidates that were verified, taken or not.
  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  [[nodiscard]] const PlaceIndex& index() const { return index_; }
  [[nodiscard]] const std::shared_ptr<CloudFile>& clouds() const { return options_.clouds; }

 private:
  void look_for(std::size_t query);
  void verify(const PlaceIndex::Match& match, const Matrix6& drift, std::size_t query,
              const VerifiableSubmap& seen);
  void refuse_ambiguous(std::size_t first);

  LoopOptions options_;
  std::vector<Piece> pieces_;
  std::vector<PoseEdge> odometry_;
  PlaceIndex index_;
  std::vector<Loop> loops_;
};

}  // namespace surefoot::mapping
