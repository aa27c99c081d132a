// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recording_writer.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace surefoot::app {

namespace fs = std::filesystem;

namespace {

void write_file(const fs::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

template <typename Value>
void append(std::string& bytes, Value value) {
  char raw[sizeof(Value)];
  std::memcpy(raw, &value, sizeof(Value));
  bytes.append(raw, sizeof(Value));
}

std::string pcd_header(std::string_view fields, std::string_view sizes, std::string_view types,
                       std::string_view counts, std::size_t points) {
  return fmt::format(
      "# .PCD v0.7\nVERSION 0.7\nFIELDS {}\nSIZE {}\nTYPE {}\nCOUNT {}\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      fields, sizes, types, counts, points, points);
}

std::string scan_pcd(const Scan& scan) {
  std::string bytes = pcd_header("x y z intensity time ring", "4 4 4 4 4 2", "F F F F F U",
                                 "1 1 1 1 1 1", scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, scan.points[i](axis));
    append(bytes, scan.intensities[i]);
    append(bytes, static_cast<float>(1e-9 * scan.times_ns[i]));
    append(bytes, scan.rings[i]);
  }
  return bytes;
}

std::string true_pcd(const simulation::SimulatedScan& scan) {
  std::string bytes =
      pcd_header("x y z label", "8 8 8 1", "F F F U", "1 1 1 1", scan.true_points.size());
  for (std::size_t i = 0; i < scan.true_points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, scan.true_points[i](axis));
    append(bytes, scan.labels[i]);
  }
  return bytes;
}

std::string seconds(std::int64_t stamp_ns) {
  return fmt::format("{}.{:09}", stamp_ns / 1'000'000'000, stamp_ns % 1'000'000'000);
}

std::string tum_line(const StampedPose& stamped) {
  const Eigen::Vector3d& t = stamped.pose.translation;
  const Eigen::Quaterniond& q = stamped.pose.rotation;
  return fmt::format("{} {:.9f} {:.9f} {:.9f} {:.12f} {:.12f} {:.12f} {:.12f}\n",
                     seconds(stamped.stamp_ns), t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
}

}  // namespace

RecordingWriter::RecordingWriter(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw std::runtime_error(folder_.string() + ": cannot be made: " + error.message());
  }
}

void RecordingWriter::write_scan(const simulation::SimulatedScan& scan) {
  write_file(folder_ / fmt::format("{:06}.pcd", stamps_ns_.size()), scan_pcd(scan.scan));
  stamps_ns_.push_back(scan.scan.stamp_ns);
}

void RecordingWriter::write_true_points(const simulation::SimulatedScan& scan) {
  fs::create_directories(folder_ / "true");
  write_file(folder_ / "true" / fmt::format("{:06}.pcd", stamps_ns_.size() - 1), true_pcd(scan));
}

void RecordingWriter::finish(const Trajectory& truth) {
  std::string times;
  for (const std::int64_t stamp : stamps_ns_) times += seconds(stamp) + "\n";
  write_file(folder_ / "times.txt", times);
  std::string poses = "# LiDAR in the map: t x y z qx qy qz qw\n";
  for (const StampedPose& stamped : truth) poses += tum_line(stamped);
  write_file(folder_ / "gt.tum", poses);
}

}  // namespace surefoot::app
