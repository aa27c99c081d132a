// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Beside the odometry, which it leaves alone: cuts the way into pieces, finds where it came back,
// and corrects what the odometry got wrong in between.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "mapping/loop_finder.hpp"
#include "mapping/pose_graph.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::mapping {

struct MapperOptions {
  PieceOptions pieces;
  LoopOptions loops;
  bool close_loops = true;
  /// Where the file without a name is made in which what was seen is put away; empty: where
  /// temporary files go.
  std::filesystem::path folder;
};

/// Corrected from odometry, T_world_odometry, at a time along the walk: smooth between the pieces,
/// whose corrected poses are given. The pieces stand in the order in which they were walked.
[[nodiscard]] Pose correction_at(const std::vector<Piece>& pieces,
                                 const std::vector<Pose>& corrected, std::int64_t time_ns);

class WalkMapper {
 public:
  explicit WalkMapper(const MapperOptions& options);

  /// A scan that was registered, in the order in which they came.
  void add(const PlacedScan& scan, const DeskewedScan& points);
  /// The same, already cut into pieces.
  void add(Piece piece) { finder_.add(std::move(piece)); }
  /// Ends the last piece, chooses among the loops and moves the pieces.
  void finish();

  [[nodiscard]] const std::vector<Piece>& pieces() const { return finder_.pieces(); }
  /// Where what was seen is put away; none: in memory.
  [[nodiscard]] const std::shared_ptr<CloudFile>& clouds() const { return finder_.clouds(); }
  /// What they look like, each; after finish().
  [[nodiscard]] const PlaceIndex& places() const { return finder_.index(); }
  /// Every candidate; after finish() with its final verdict.
  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  [[nodiscard]] std::size_t taken() const;
  /// After finish(): the pieces' corrected poses, the odometry's motions and the loops taken.
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  /// The same with what finish() has found.
  [[nodiscard]] Pose correction(std::int64_t time_ns) const;

 private:
  void close_loops();

  MapperOptions options_;
  PieceBuilder builder_;
  LoopFinder finder_;
  std::vector<Loop> loops_;
  PoseGraph graph_;
};

}  // namespace surefoot::mapping
