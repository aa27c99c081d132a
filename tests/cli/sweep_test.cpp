// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot sweep on what surefoot simulate makes.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

TEST(Sweep, HasARowForEachValue) {
  const ScratchFolder scratch;
  const ProcessResult walk = run_surefoot(
      {"simulate", "parking", "--scans", "15", "--no-footprint", "-o", "walk"}, scratch.path());
  ASSERT_EQ(walk.exit_code, 0) << walk;
  const ProcessResult result =
      run_surefoot({"sweep", "walk", "--vary", "knots.segments=1:2:1", "--count", "12", "-j", "2"},
                   scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  std::istringstream table(result.output);
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) {
    lines.push_back(std::regex_replace(line, std::regex(" +"), " "));
  }
  ASSERT_EQ(lines.size(), 5U) << result;
  EXPECT_TRUE(lines[0].starts_with("| parameter | walk | APE ratio | step ratio |")) << result;
  EXPECT_TRUE(lines[2].starts_with("| unchanged | 0.")) << result;
  EXPECT_NE(lines[2].find("| 1.00 | 1.00 |"), std::string::npos) << result;
  EXPECT_TRUE(lines[3].starts_with("| knots.segments = 1 | ")) << result;
  EXPECT_TRUE(lines[4].starts_with("| knots.segments = 2 | ")) << result;
  EXPECT_EQ(result.output.find("nan"), std::string::npos) << result;
  const std::filesystem::path folder = scratch.path() / "results/sweep";
  EXPECT_EQ(file_content(folder / "sweep.md"), result.output);
  EXPECT_EQ(lines_of(folder / "sweep.csv"), 4U);
  EXPECT_NE(file_content(folder / "sweep.json").find("\"ape_ratio\""), std::string::npos);
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
  EXPECT_NE(refusal({"nowhere", "--vary", "map.radius=50"}).find("nowhere"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.radius=50"}).find("gt.tum"), std::string::npos);
  EXPECT_NE(refusal({"in"}).find("--vary"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.radius"}).find("key=value"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "map.speed=1"}).find("map.speed"), std::string::npos);
  EXPECT_NE(refusal({"in", "--vary", "deskew.segments=1:4:1"}).find("what reads it: paper"),
            std::string::npos);
}

}  // namespace
}  // namespace surefoot::test
