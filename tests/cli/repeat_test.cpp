// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The same run gives the same bytes; a run that is interrupted leaves whole files.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <span>
#include <thread>

#include "io/files/pcd_writer.hpp"
#include "io/files/ply_reader.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

TEST(Repeat, SameBytesForAnyNumberOfThreads) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(8));
  for (const char* threads : {"1", "2", "3"}) {
    for (const char* turn : {"a", "b"}) {
      const ProcessResult result = run_surefoot(
          {"run", "in", "-o", std::string(threads) + turn, "--threads", threads}, scratch.path());
      ASSERT_EQ(result.exit_code, 0) << result;
    }
  }
  for (const char* name : {"trajectory.tum", "trajectory_kitti.txt", "map.ply"}) {
    const std::string first = file_content(scratch.path() / "1a" / name);
    EXPECT_FALSE(first.empty());
    for (const char* other : {"1b", "2a", "2b", "3a", "3b"}) {
      EXPECT_TRUE(first == file_content(scratch.path() / other / name)) << other << " " << name;
    }
  }
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, LeavesWholeFiles) {
  constexpr int kScans = 20'000;
  const ScratchFolder scratch;
  const fs::path out = scratch.path() / "out";
  write_long_recording(scratch.path() / "in", kScans);
  const Process process({"run", "in", "-o", "out"}, scratch.path());
  for (int i = 0; i < 3000 && lines_of(out / "scans.csv") < 10; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process.send(GetParam());
  const ProcessResult result = process.wait();

  EXPECT_EQ(result.exit_code, 130) << result;
  const std::size_t scans = lines_of(out / "scans.csv") - 1;  // without the header
  EXPECT_GE(scans, 9U);
  EXPECT_LT(scans, static_cast<std::size_t>(kScans));
  EXPECT_EQ(lines_of(out / "trajectory_kitti.txt"), scans);
  EXPECT_EQ(lines_of(out / "trajectory.tum"), scans + 1);  // with the comment
  for (const char* name : {"scans.csv", "trajectory.tum", "trajectory_kitti.txt"}) {
    EXPECT_EQ(file_content(out / name).back(), '\n') << name;
  }
  EXPECT_NE(file_content(out / "run.yaml").find("interrupted: true"), std::string::npos);
  const std::string map = file_content(out / "map.ply");
  EXPECT_NO_THROW((void)io::parse_ply(std::as_bytes(std::span(map))));
}

INSTANTIATE_TEST_SUITE_P(All, Interrupt, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace surefoot::test
