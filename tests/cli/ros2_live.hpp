// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live on ROS 2's wire, its files against those of a recording: what tests of topics and
// of services begin with.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "io/scan_sink.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "same_files.hpp"

namespace surefoot::test {

inline constexpr const char* kCloudType = "sensor_msgs::msg::dds_::PointCloud2_";

/// Of this process alone, nearly.
inline int own_domain() { return 20 + static_cast<int>(::getpid() % 80); }

/// A stamp of zero would be none.
inline std::vector<Scan> stamped_scans(int count) {
  std::vector<Scan> scans = hall_scans(count);
  for (Scan& scan : scans) scan.stamp_ns += 1'700'000'000'000'000'000;
  return scans;
}

inline std::vector<std::string> live(std::vector<std::string> more) {
  std::vector<std::string> arguments = {
      "live",        "--ros2-domain", std::to_string(own_domain()), "--ros2-interface", "lo",
      "--no-report", "--no-picture"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

class Ros2Test : public testing::Test {
 protected:
  void offline(const std::vector<Scan>& scans) {
    const auto sink = io::make_scan_sink(scratch_.path() / "scans.mcap", io::ScanFormat::mcap);
    for (const Scan& scan : scans) sink->add(scan);
    sink->finish();
    const ProcessResult result =
        run_surefoot({"run", "scans.mcap", "-o", "offline", "--no-report", "--no-picture", "-q"},
                     scratch_.path());
    ASSERT_EQ(result.exit_code, 0) << result;
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    return file_content(scratch_.path() / file);
  }
  void expect_same(const std::string& a, const std::string& b) const {
    expect_same_files(scratch_.path() / a, scratch_.path() / b,
                      {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  }
  /// What a live run's run.yaml repeats.
  void expect_repeated(const std::string& folder) const {
    const ProcessResult again = run_surefoot(
        {"run", "--config", folder + "/run.yaml", "-o", "again", "-q"}, scratch_.path());
    EXPECT_EQ(again.exit_code, 0) << again;
    expect_same(folder, "again");
  }
  /// Until a file has so many lines.
  [[nodiscard]] bool wait_for_lines(const std::string& file, std::size_t lines) const {
    for (int i = 0; i < 1000; ++i) {
      if (std::filesystem::exists(scratch_.path() / file) &&
          lines_of(scratch_.path() / file) >= lines) {
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  ScratchFolder scratch_;
};

}  // namespace surefoot::test
