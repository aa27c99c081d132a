// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/recording_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "io/file_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/trajectory_files.hpp"
#include "recordings/recording_folder.hpp"
#include "sensors/velodyne/vlp16.hpp"
#include "simulation/capture_writer.hpp"

namespace surefoot::recordings {

namespace fs = std::filesystem;

void RecordingFormat::choose(const std::vector<std::string>& names) {
  const auto named = [&](const char* format) {
    return std::find(names.begin(), names.end(), format) != names.end();
  };
  pcd = named("pcd");
  pcap = named("pcap");
  mcap = named("mcap");
  rosbag2 = named("rosbag2");
}

RecordingWriter::RecordingWriter(const fs::path& folder, const RecordingFormat& format,
                                 const simulation::ScannerOptions& options)
    : folder_(folder), format_(format), encoder_(options.start_ns, options.dual_return) {
  if (format_.true_points) fs::create_directories(folder_ / kTrueFolder);
  using Format = io::ScanFormat;
  if (format_.pcd) sinks_.push_back(io::make_scan_sink(folder_, Format::pcd));
  if (format_.mcap) sinks_.push_back(io::make_scan_sink(folder_ / kMcapFile, Format::mcap));
  if (format_.rosbag2) sinks_.push_back(io::make_scan_sink(folder_ / kBagFolder, Format::rosbag2));
  if (format_.pcap) {
    capture_ = std::make_unique<simulation::CaptureWriter>(folder_ / kCaptureFile, vlp16::kUdpPort);
  }
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::write(const simulation::SimulatedScan& scan) {
  for (const auto& sink : sinks_) sink->add(scan.scan);
  if (format_.true_points) write_true_points(scan);
  if (capture_) {
    for (const simulation::Vlp16DataPacket& packet : encoder_.add(scan)) {
      capture_->write(packet.sent_ns, packet.payload);
    }
  }
  ++scans_;
}

void RecordingWriter::write_true_points(const simulation::SimulatedScan& scan) {
  Scan exact;
  for (std::size_t i = 0; i < scan.true_points.size(); ++i) {
    exact.points.push_back(scan.true_points[i].cast<float>());
    exact.intensities.push_back(static_cast<float>(scan.labels[i]));
  }
  io::write_pcd(folder_ / kTrueFolder / scan_file(scans_), exact);
}

void RecordingWriter::finish(const Trajectory& truth) {
  for (const auto& sink : sinks_) sink->finish();
  if (capture_) {
    if (const auto packet = encoder_.finish()) capture_->write(packet->sent_ns, packet->payload);
    capture_->finish();
  }
  io::write_tum(folder_ / kTruthFile, truth);
}

}  // namespace surefoot::recordings
