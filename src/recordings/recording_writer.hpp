// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A simulated recording on disk. OUT/000000.pcd ... and OUT/times.txt, or OUT/recording.pcap,
// OUT/recording.mcap, OUT/rosbag2; the truth in OUT/gt.tum; every point's exact position in
// OUT/true.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/scan_sink.hpp"
#include "simulation/scanner.hpp"
#include "simulation/vlp16_encoder.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::simulation {
class CaptureWriter;
}

namespace surefoot::recordings {

struct RecordingFormat {
  bool pcd = true;
  bool pcap = false;         ///< native VLP-16 packets
  bool mcap = false;         ///< ROS 2 messages, PointCloud2
  bool rosbag2 = false;      ///< the same in a sqlite3 bag
  bool true_points = false;  ///< PCD: x y z in the map, and the point's label as intensity

  /// Of these four names those and no others.
  void choose(const std::vector<std::string>& names);
};

class RecordingWriter {
 public:
  /// Into a folder that is there. @throws std::runtime_error where a file cannot be made.
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
  std::size_t scans_ = 0;
  std::vector<std::unique_ptr<io::ScanSink>> sinks_;
  simulation::Vlp16Encoder encoder_;
  std::unique_ptr<simulation::CaptureWriter> capture_;
};

}  // namespace surefoot::recordings
