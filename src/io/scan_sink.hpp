// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans out, to any of the formats that scans are stored in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "io/scan_fields.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

enum class ScanFormat { pcd, ply, kitti_bin, las, mcap, rosbag2, ros1_bag };

/// "pcd", "ply", "bin", "las", "mcap", "rosbag2", "bag", in the order of ScanFormat.
[[nodiscard]] const std::vector<std::string>& scan_format_names();
/// Throws std::invalid_argument for another name.
[[nodiscard]] ScanFormat scan_format_named(const std::string& name);

/// Whether it is a folder of files, or else one.
[[nodiscard]] constexpr bool is_folder(ScanFormat format) {
  return format != ScanFormat::mcap && format != ScanFormat::ros1_bag;
}
/// Whether each scan has a file of its own.
[[nodiscard]] constexpr bool has_file_a_scan(ScanFormat format) {
  return format < ScanFormat::mcap;
}

/// Whether it holds messages.
[[nodiscard]] constexpr bool is_bag(ScanFormat format) { return !has_file_a_scan(format); }

struct SinkOptions {
  std::string topic = "/points";  ///< of a bag
  std::string frame = "lidar";    ///< of its messages
  /// Of formats with a file a scan: the path is that of the only scan's file, not of a folder.
  bool one_file = false;
};

class ScanSink {
 public:
  virtual ~ScanSink() = default;
  /// Why the format cannot hold a scan at all; empty: it can.
  [[nodiscard]] virtual std::string refusal(const Scan& /*scan*/,
                                            std::span<const FurtherField> /*further*/ = {}) const {
    return {};
  }
  /// Scans in their order, but for refused ones, and what the recording has of their points
  /// besides. Throws WriteError.
  /// @param logged_ns when it was recorded; 0: at its stamp
  void add(const Scan& scan, std::span<const FurtherField> further = {},
           std::int64_t logged_ns = 0);
  /// What becomes of every scan besides; empty: nothing.
  [[nodiscard]] virtual std::string remark() const { return {}; }
  /// Ends the recording; throws WriteError.
  virtual void finish() = 0;
  /// Fields of the scans so far that the format cannot hold: "t, ring"; empty: nothing is lost.
  [[nodiscard]] std::string lost() const;

 protected:
  [[nodiscard]] virtual bool holds(const Column& column) const = 0;
  /// The columns that it holds.
  virtual void write(const Scan& scan, std::span<const Column> columns, std::int64_t logged_ns) = 0;

 private:
  [[nodiscard]] std::vector<Column> held(const Scan& scan, std::span<const FurtherField> further);

  std::set<std::string> lost_;
  std::vector<Column> last_;  // of the last scan that has points; without their values
};

/// A folder of scans with times.txt, a folder of a ROS 2 bag (sqlite3), or one file: MCAP with
/// ROS 2 messages, ROS 1 bag. Throws WriteError naming what cannot be made.
[[nodiscard]] std::unique_ptr<ScanSink> make_scan_sink(const std::filesystem::path& path,
                                                       ScanFormat format,
                                                       const SinkOptions& options = {});

/// The bag of a format that is one (is_bag). Throws WriteError.
[[nodiscard]] std::shared_ptr<BagWriter> make_bag(const std::filesystem::path& path,
                                                  ScanFormat format);
/// A topic of a bag that others write to as well; whoever finishes it first ends the bag.
[[nodiscard]] std::unique_ptr<ScanSink> make_topic_sink(std::shared_ptr<BagWriter> bag,
                                                        const SinkOptions& options);

}  // namespace surefoot::io
