// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A simulated recording on disk. OUT/000000.pcd ... and OUT/times.txt, or OUT/recording.pcap; the
// truth in OUT/gt.tum; every point's exact position in OUT/true.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "simulation/scanner.hpp"
#include "simulation/vlp16_encoder.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::simulation {
class CaptureWriter;
}

namespace surefoot::app {

struct RecordingFormat {
  bool pcd = true;
  bool pcap = false;         ///< native VLP-16 packets
  bool true_points = false;  ///< PCD: x y z in the map, and the point's label as intensity
};

class RecordingWriter {
 public:
  /// @throws std::runtime_error where the folder or a file cannot be made.
  RecordingWriter(const std::filesystem::path& folder, const RecordingFormat& format,
                  const simulation::ScannerOptions& options);
  ~RecordingWriter();

  /// Scans in their order. @throws std::runtime_error where a file cannot be written.
  void write(const simulation::SimulatedScan& scan);
  /// Stamps and truth; ends the capture.
  void finish(const Trajectory& truth);

 private:
  void write_true_points(const simulation::SimulatedScan& scan);

  std::filesystem::path folder_;
  RecordingFormat format_;
  std::vector<std::int64_t> stamps_ns_;
  simulation::Vlp16Encoder encoder_;
  std::unique_ptr<simulation::CaptureWriter> capture_;
};

}  // namespace surefoot::app
