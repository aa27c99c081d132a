// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings.hpp"

#include <algorithm>
#include <cstdio>

#include "io/file_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::test {

namespace fs = std::filesystem;

std::vector<Scan> hall_scans(int count) {
  Twist velocity = Twist::Zero();
  velocity[0] = kGlideSpeed;
  const Pose start{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  return take_scans(furnished_hall(), constant_velocity(start, velocity), count);
}

void write_bend_recording(const fs::path& folder, double yaw_rate, std::size_t count,
                          std::size_t thin_from) {
  Twist velocity = Twist::Zero();
  velocity[0] = 1.0;
  velocity[5] = yaw_rate;
  const MotionFunction motion =
      constant_velocity({Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}}, velocity);
  const int scans_count = static_cast<int>(count);
  std::vector<Scan> scans = take_scans(furnished_hall(), motion, scans_count, {.columns = 180});
  for (std::size_t i = thin_from; i < scans.size(); ++i) {
    const auto thinned = [](auto& values) {
      std::size_t kept = 0;
      for (std::size_t p = 0; p < values.size(); p += 2) values[kept++] = values[p];
      values.resize(std::min(kept, values.size()));
    };
    thinned(scans[i].points);
    thinned(scans[i].times_ns);
    thinned(scans[i].intensities);
    thinned(scans[i].rings);
  }
  write_pcd_recording(folder, scans);
  Trajectory truth;
  for (int i = 5; i <= 10 * scans_count - 5; ++i) {
    truth.push_back({std::int64_t{i} * 10'000'000, motion(0.01 * i)});
  }
  io::write_tum(folder / "gt.tum", truth);
}

std::string big_endian_ply(const Scan& scan) {
  std::string bytes = "ply\nformat binary_big_endian 1.0\nelement vertex " +
                      std::to_string(scan.points.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const Eigen::Vector3f& point : scan.points) {
    for (int axis = 0; axis < 3; ++axis) {
      std::string value;
      io::append_bytes(value, point[axis]);
      bytes.append(value.rbegin(), value.rend());
    }
  }
  return bytes;
}

std::string kitti_bin(const Scan& scan) {
  std::string bytes;
  for (const Eigen::Vector3f& point : scan.points) {
    for (int axis = 0; axis < 3; ++axis) io::append_bytes(bytes, point[axis]);
    io::append_bytes(bytes, 0.5F);
  }
  return bytes;
}

std::string stamp_line(const Scan& scan) {
  char text[40];
  std::snprintf(text, sizeof(text), "%lld.%09lld\n",
                static_cast<long long>(scan.stamp_ns / 1'000'000'000),
                static_cast<long long>(scan.stamp_ns % 1'000'000'000));
  return text;
}

void write_pcd_recording(const fs::path& folder, const std::vector<Scan>& scans) {
  fs::create_directories(folder);
  std::string times;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    io::write_pcd(folder / scan_name(i), scans[i]);
    times += stamp_line(scans[i]);
  }
  write_content(folder / "times.txt", times);
}

void write_long_recording(const fs::path& folder, int scans) {
  fs::create_directory(folder);
  io::write_pcd(folder / scan_name(0), hall_scans(1).front());
  for (int i = 1; i < scans; ++i) {
    fs::create_hard_link(folder / scan_name(0), folder / scan_name(static_cast<std::size_t>(i)));
  }
}

std::string scan_name(std::size_t index) {
  char name[32];
  std::snprintf(name, sizeof(name), "%06zu.pcd", index);
  return name;
}

}  // namespace surefoot::test
