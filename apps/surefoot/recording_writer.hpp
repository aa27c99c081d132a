// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A simulated recording on disk: scans as PCD, their stamps, the truth, and how it was made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulation/scanner.hpp"

namespace surefoot::app {

/// Writes DIR/000000.pcd ..., DIR/times.txt, DIR/gt.tum; the caller adds scene.json.
class RecordingWriter {
 public:
  /// @throws std::runtime_error where the folder cannot be made.
  explicit RecordingWriter(const std::filesystem::path& folder);

  /// @throws std::runtime_error where a file cannot be written.
  void write_scan(const simulation::SimulatedScan& scan);
  /// Per-point true positions and labels, beside the scans: DIR/true/000000.pcd.
  void write_true_points(const simulation::SimulatedScan& scan);
  /// times.txt and gt.tum.
  void finish(const Trajectory& truth);

 private:
  std::filesystem::path folder_;
  std::vector<std::int64_t> stamps_ns_;
};

}  // namespace surefoot::app
