// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/scan_sink.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "io/bags/message_source.hpp"
#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "io/files/las_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/messages/point_cloud2_writer.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

class BagSink final : public ScanSink {
 public:
  BagSink(std::shared_ptr<BagWriter> bag, SinkOptions options)
      : bag_(std::move(bag)),
        options_(std::move(options)),
        topic_(bag_->add_topic(options_.topic, point_cloud2_definition())) {}

  [[nodiscard]] std::string refusal(const Scan& scan,
                                    std::span<const FurtherField> further) const override {
    std::string why = stamp_refusal(scan);
    if (!why.empty()) return why;
    constexpr std::uint64_t kHead = 1 << 10;  // of the message, and of each field
    std::uint64_t bytes = kHead + options_.frame.size();
    for (const Column& column : written_columns(scan, further)) {
      if (!holds(column)) continue;
      bytes += kHead + column.name.size() +
               std::uint64_t{scan.points.size()} * column.count * size_of(column.type);
    }
    if (bytes <= kMostMessageBytes) return {};
    return "its message would have some " + std::to_string(bytes >> 20) +
           " MiB; readers take at most 256 MiB";
  }

  void finish() override { bag_->finish(); }

 private:
  // ROS 1 counts seconds from 1970 in 32 bits without a sign, ROS 2 with one.
  [[nodiscard]] std::string stamp_refusal(const Scan& scan) const {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const bool ros1 = bag_->flavour() == MessageWriter::Flavour::ros1;
    const std::int64_t least = ros1 ? 0 : std::numeric_limits<std::int32_t>::min() * kSecond;
    const std::int64_t seconds =
        ros1 ? std::numeric_limits<std::uint32_t>::max() : std::numeric_limits<std::int32_t>::max();
    if (scan.stamp_ns >= least && scan.stamp_ns < (seconds + 1) * kSecond) return {};
    return "it is stamped " + format_seconds(scan.stamp_ns) + " s; ROS " +
           (ros1 ? "1 has times from 0" : "2 has times from -2147483648") + " to " +
           std::to_string(seconds) + " s";
  }

  [[nodiscard]] bool holds(const Column& column) const override {
    return fits_point_cloud2(column);
  }
  void write(const Scan& scan, std::span<const Column> columns, std::int64_t logged_ns) override {
    const CloudHead head{scan.stamp_ns, options_.frame, is_dense(scan)};
    bag_->write(topic_, logged_ns != 0 ? logged_ns : scan.stamp_ns,
                format_point_cloud2(head, columns, scan.points.size(), bag_->flavour()));
  }

  std::shared_ptr<BagWriter> bag_;
  SinkOptions options_;
  std::size_t topic_;
};

class FileSink final : public ScanSink {
 public:
  /// @param path a folder of files, or the only one.
  FileSink(fs::path path, ScanFormat format, bool one_file)
      : path_(std::move(path)), format_(format), one_file_(one_file) {
    std::error_code error;
    if (!one_file_) fs::create_directories(path_, error);
    if (error) throw WriteError(path_.string() + ": cannot be made: " + error.message());
  }

  [[nodiscard]] std::string refusal(const Scan& scan,
                                    std::span<const FurtherField> /*further*/) const override {
    if (format_ == ScanFormat::kitti_bin && scan.points.empty()) {
      return "it has no points; a .bin without any is an empty file, which nobody takes for a scan";
    }
    if (format_ != ScanFormat::las) return {};
    const auto is_far = [](const Eigen::Vector3f& point) {
      constexpr float kLasReach = 1e6F;  // [m] LAS has millimetres in 32 bits
      return point.allFinite() && point.cwiseAbs().maxCoeff() >= kLasReach;
    };
    const bool far = std::any_of(scan.points.begin(), scan.points.end(), is_far);
    return far ? "a point lies 1000 km away or more; LAS holds nearer ones, in millimetres" : "";
  }

  [[nodiscard]] std::string remark() const override {
    std::string text =
        one_file_ ? "lost: the scan's stamp, which a file alone has no room for" : "";
    if (format_ != ScanFormat::las) return text;
    return text + (text.empty() ? "" : "\n") + "lost: digits below the millimetre" +
           (lost_points_ ? ", and points that are not finite" : "");
  }

  void finish() override {
    if (!one_file_) write_whole_file(path_ / "times.txt", stamps_);
  }

 private:
  [[nodiscard]] bool holds(const Column& column) const override {
    const auto is_column = [&](const char* name) { return column.name == name; };
    if (format_ == ScanFormat::pcd) return true;
    if (format_ == ScanFormat::las && is_column("intensity")) return false;
    if (format_ == ScanFormat::ply) return fits_ply(column);
    return std::any_of(kKittiColumns.begin(), kKittiColumns.end(), is_column);
  }

  void write(const Scan& scan, std::span<const Column> columns,
             std::int64_t /*logged_ns*/) override {
    char name[32];
    std::snprintf(name, sizeof(name), "%06zu.%s", scans_++,
                  scan_format_names()[static_cast<std::size_t>(format_)].c_str());
    const fs::path file = one_file_ ? path_ : path_ / name;
    write_whole_file(file, format_ == ScanFormat::las ? format_las(finite_points(scan))
                                                      : content(columns, scan.points.size()));
    stamps_ += format_seconds(scan.stamp_ns) + '\n';
  }

  std::vector<Eigen::Vector3d> finite_points(const Scan& scan) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3f& point : scan.points) {
      if (point.allFinite()) points.push_back(point.cast<double>());
    }
    lost_points_ = lost_points_ || points.size() < scan.points.size();
    return points;
  }

  [[nodiscard]] std::string content(std::span<const Column> columns, std::size_t points) const {
    if (format_ == ScanFormat::pcd) return format_pcd(columns, points, PcdData::binary);
    if (format_ == ScanFormat::ply) return format_ply(columns, points, PlyFlavour::binary);
    std::vector<Column> all(columns.begin(), columns.end());
    const float none = 0.0F;
    if (all.size() < kKittiColumns.size()) {
      all.push_back({"intensity", ScalarType::f32, reinterpret_cast<const std::byte*>(&none), 0});
    }
    std::string bytes;
    append_points(bytes, all, points);
    return bytes;
  }

  static constexpr std::array<const char*, 4> kKittiColumns = {"x", "y", "z", "intensity"};
  fs::path path_;
  ScanFormat format_;
  bool one_file_;
  std::string stamps_;
  std::size_t scans_ = 0;
  bool lost_points_ = false;  ///< of LAS: those that are not finite
};

}  // namespace

std::vector<Column> ScanSink::held(const Scan& scan, std::span<const FurtherField> further) {
  std::vector<Column> columns;
  for (const Column& column : written_columns(scan, further)) {
    if (holds(column)) {
      columns.push_back(column);
    } else if (constexpr std::size_t kMostNames = 100; lost_.size() < kMostNames) {
      lost_.insert(column.name);
    }
  }
  return columns;
}

/// A scan without points has the fields of those before: readers of many files expect the same in
/// each.
void ScanSink::add(const Scan& scan, std::span<const FurtherField> further,
                   std::int64_t logged_ns) {
  if (scan.points.empty() && !last_.empty()) return write(scan, last_, logged_ns);
  const std::vector<Column> columns = held(scan, further);
  write(scan, columns, logged_ns);
  if (scan.points.empty()) return;
  last_ = columns;
  for (Column& column : last_) column.first = nullptr;
}

std::string ScanSink::lost() const {
  std::string names;
  for (const std::string& name : lost_) names += (names.empty() ? "" : ", ") + name;
  return names;
}

const std::vector<std::string>& scan_format_names() {
  static const std::vector<std::string> names = {"pcd",  "ply",     "bin", "las",
                                                 "mcap", "rosbag2", "bag"};
  return names;
}

ScanFormat scan_format_named(const std::string& name) {
  const std::vector<std::string>& names = scan_format_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::invalid_argument("no format is called '" + name + "'");
  return static_cast<ScanFormat>(found - names.begin());
}

std::unique_ptr<ScanSink> make_scan_sink(const fs::path& path, ScanFormat format,
                                         const SinkOptions& options) {
  if (is_bag(format)) return make_topic_sink(make_bag(path, format), options);
  return std::make_unique<FileSink>(path, format, options.one_file);
}

std::shared_ptr<BagWriter> make_bag(const fs::path& path, ScanFormat format) {
  if (format == ScanFormat::mcap) return make_mcap_bag(path);
  if (format == ScanFormat::rosbag2) return make_sqlite_bag(path);
  return make_ros1_bag(path);
}

std::unique_ptr<ScanSink> make_topic_sink(std::shared_ptr<BagWriter> bag,
                                          const SinkOptions& options) {
  return std::make_unique<BagSink>(std::move(bag), options);
}

}  // namespace surefoot::io
