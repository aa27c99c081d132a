// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recording_writer.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "dataset/file_writer.hpp"
#include "dataset/pcd_writer.hpp"
#include "dataset/trajectory_files.hpp"
#include "sensor/vlp16.hpp"
#include "simulation/capture_writer.hpp"

namespace surefoot::app {

namespace fs = std::filesystem;

namespace {

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
}

}  // namespace

RecordingWriter::RecordingWriter(const fs::path& folder, const RecordingFormat& format,
                                 const simulation::ScannerOptions& options)
    : folder_(folder), format_(format), encoder_(options.start_ns, options.dual_return) {
  make_folder(folder_);
  if (format_.true_points) make_folder(folder_ / "true");
  if (format_.pcap) {
    capture_ =
        std::make_unique<simulation::CaptureWriter>(folder_ / "recording.pcap", vlp16::kUdpPort);
  }
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::write(const simulation::SimulatedScan& scan) {
  if (format_.pcd) {
    dataset::write_pcd(folder_ / fmt::format("{:06}.pcd", stamps_ns_.size()), scan.scan);
  }
  if (format_.true_points) write_true_points(scan);
  if (capture_) {
    for (const simulation::Vlp16DataPacket& packet : encoder_.add(scan)) {
      capture_->write(packet.sent_ns, packet.payload);
    }
  }
  stamps_ns_.push_back(scan.scan.stamp_ns);
}

void RecordingWriter::write_true_points(const simulation::SimulatedScan& scan) {
  Scan exact;
  for (std::size_t i = 0; i < scan.true_points.size(); ++i) {
    exact.points.push_back(scan.true_points[i].cast<float>());
    exact.intensities.push_back(static_cast<float>(scan.labels[i]));
  }
  dataset::write_pcd(folder_ / "true" / fmt::format("{:06}.pcd", stamps_ns_.size()), exact);
}

void RecordingWriter::finish(const Trajectory& truth) {
  if (format_.pcd) {
    std::string times;
    for (const std::int64_t stamp : stamps_ns_) {
      times += fmt::format("{}.{:09}\n", stamp / 1'000'000'000, stamp % 1'000'000'000);
    }
    dataset::write_whole_file(folder_ / "times.txt", times);
  }
  if (capture_) {
    if (const auto packet = encoder_.finish()) capture_->write(packet->sent_ns, packet->payload);
    capture_->finish();
  }
  dataset::write_tum(folder_ / "gt.tum", truth);
}

}  // namespace surefoot::app
