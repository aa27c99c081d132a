// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate and suite, and surefoot sweep on what they make.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "dataset/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

void simulate(const std::string& output, const ScratchFolder& scratch) {
  const ProcessResult result = run_surefoot(
      {"simulate", "parking", "--scans", "15", "--no-footprint", "-o", output}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
}

TEST(Simulation, CommandsHaveHelp) {
  const ScratchFolder scratch;
  for (const char* command : {"simulate", "suite"}) {
    const ProcessResult result = run_surefoot({command, "--help"}, scratch.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.output.find("Options:"), std::string::npos) << result;
    EXPECT_NE(result.output.find("--output"), std::string::npos) << result;
    EXPECT_TRUE(result.errors.empty()) << result;
  }
  const ProcessResult scenes = run_surefoot({"simulate", "--list"}, scratch.path());
  EXPECT_EQ(scenes.exit_code, 0) << scenes;
  EXPECT_NE(scenes.output.find("parking"), std::string::npos) << scenes;
}

TEST(Simulation, SameSeedSameBytes) {
  const ScratchFolder scratch;
  simulate("a", scratch);
  simulate("b", scratch);
  EXPECT_GT(dataset::read_tum(scratch.path() / "a" / "gt.tum").size(), 15U);
  for (const char* name : {"gt.tum", "times.txt", "scene.json", "000000.pcd", "000014.pcd"}) {
    const std::string content = file_content(scratch.path() / "a" / name);
    EXPECT_FALSE(content.empty()) << name;
    EXPECT_TRUE(content == file_content(scratch.path() / "b" / name)) << name;
  }
}

TEST(Sweep, HasARowForEachValue) {
  const ScratchFolder scratch;
  simulate("walk", scratch);
  const ProcessResult result =
      run_surefoot({"sweep", "walk", "--vary", "deskew.segments=1,2", "--count", "12", "-j", "2"},
                   scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  std::istringstream table(result.output);
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5U) << result;
  EXPECT_TRUE(lines[0].starts_with("| parameter | walk | APE ratio | step ratio |")) << result;
  EXPECT_TRUE(lines[2].starts_with("| unchanged | 0.")) << result;
  EXPECT_NE(lines[2].find("| 1.00 | 1.00 |"), std::string::npos) << result;
  EXPECT_TRUE(lines[3].starts_with("| deskew.segments = 1 | ")) << result;
  EXPECT_TRUE(lines[4].starts_with("| deskew.segments = 2 | ")) << result;
  EXPECT_EQ(result.output.find("nan"), std::string::npos) << result;
}

TEST(Sweep, BadInputIsRefused) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(2));
  const auto refusal = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "sweep");
    const ProcessResult result = run_surefoot(arguments, scratch.path());
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_TRUE(result.output.empty()) << result;
    return result.errors;
  };
  EXPECT_NE(refusal({"nowhere", "--vary", "map.voxel_size=1"}).find("nowhere"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.voxel_size=1"}).find("gt.tum"), std::string::npos);
  EXPECT_NE(refusal({"in"}).find("--vary"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.voxel_size"}).find("key=value"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.speed=1"}).find("map.speed"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::test
