// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot compare in parts: of its runs, of a recording's scans, and so of the truth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "compare_fixture.hpp"

namespace surefoot::test {
namespace {

TEST_F(Compare, PartsGiveWhatTheWholeGives) {
  const std::vector<std::string> all = {"left", "right", "--methods", "paper,icp", "--no-figures"};
  const auto in = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = all;
    arguments.insert(arguments.end(), {"-o", folder});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return compare(arguments);
  };
  ASSERT_EQ(in("whole", {}).exit_code, 0);
  const ProcessResult second = in("parts", {"--part", "2/3"});
  EXPECT_EQ(second.exit_code, 0) << second;
  EXPECT_TRUE(second.output.empty()) << second;
  EXPECT_TRUE(fs::exists(scratch_.path() / "parts/runs/left/icp"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "parts/runs/left/paper"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "parts/compare.json"));
  EXPECT_EQ(in("parts", {"--part", "3/3"}).exit_code, 0);
  EXPECT_EQ(in("parts", {"--part", "1/3"}).exit_code, 0);
  const ProcessResult end = in("parts", {});
  EXPECT_NE(end.errors.find("2 methods; 4 done before"), std::string::npos) << end;
  EXPECT_EQ(errors_of(results("parts")), errors_of(results("whole")));
}

// compare, ablate and sweep alike.
TEST_F(Compare, EveryKindOfComparisonHasParts) {
  const std::vector<std::vector<std::string>> commands = {
      {"compare", "left", "--methods", "icp,paper", "-o", "c", "--no-figures"},
      {"sweep", "left", "--method", "paper", "--vary", "map.radius=50,60", "-o", "s"},
      {"ablate", "left", "-o", "a", "--no-figures"}};
  for (const std::vector<std::string>& command : commands) {
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), command.begin(), command.end());
      return run_surefoot(more, scratch_.path());
    };
    for (const char* part : {"0/3", "4/3", "3", "1/3x", "-1/3", "/"}) {
      const ProcessResult refused = with({std::string("--part=") + part});
      EXPECT_EQ(refused.exit_code, 2) << refused;
      EXPECT_NE(refused.errors.find("expected NUMBER/OF"), std::string::npos) << refused;
    }
    const ProcessResult listed = with({"--list-runs"});
    std::istringstream lines(listed.output);
    std::vector<json> runs;
    for (std::string line; std::getline(lines, line);) runs.push_back(json::parse(line));
    ASSERT_GE(runs.size(), 2U) << listed;
    EXPECT_EQ(runs[1]["recording"], (scratch_.path() / "left").string()) << listed;
    const fs::path out = scratch_.path() / command[0].substr(0, 1);
    EXPECT_FALSE(fs::exists(out)) << "listing does something";

    const ProcessResult second = with({"--part", runs[1]["part"]});
    EXPECT_EQ(second.exit_code, 0) << second;
    EXPECT_TRUE(fs::exists(out / runs[1]["folder"].get<std::string>() / "trajectory.tum"))
        << second;
    EXPECT_FALSE(fs::exists(out / runs[0]["folder"].get<std::string>())) << second;
    EXPECT_FALSE(fs::exists(out / "compare.json")) << second;
    const ProcessResult end = with({});
    EXPECT_NE(end.errors.find("; 1 done before"), std::string::npos) << end;
    EXPECT_TRUE(fs::exists(out / "compare.json")) << end;
  }
}

// Whoever gave the runs to several machines is told by each.
TEST_F(Compare, APartThatFailsSaysSo) {
  fs::create_directory(scratch_.path() / "broken");
  write_content(scratch_.path() / "broken" / scan_name(0), "no point cloud");
  fs::copy_file(scratch_.path() / "left/gt.tum", scratch_.path() / "broken/gt.tum");
  fs::remove(scratch_.path() / "right/gt.tum");
  const auto part = [&](const std::string& number) {
    return compare({"broken", "right", "left", "--methods", "icp", "-o", "out", "--part", number});
  };
  EXPECT_EQ(part("1/3").exit_code, 1);
  EXPECT_EQ(part("1/3").exit_code, 1) << "done before, and forgotten";
  const ProcessResult blind = part("2/3");
  EXPECT_EQ(blind.exit_code, 2) << blind;
  EXPECT_NE(blind.errors.find("right/gt.tum"), std::string::npos) << blind;
  EXPECT_EQ(part("3/3").exit_code, 0);
  EXPECT_TRUE(fs::exists(scratch_.path() / "out/runs/left/icp/1/trajectory.tum"));
}

TEST_F(Compare, TheRunsOfASetAreListedWithoutMakingIt) {
  const ProcessResult listed =
      compare({"--suite", "reporting", "--list-runs", "--methods", "icp", "-o", "out"});
  EXPECT_EQ(listed.exit_code, 0) << listed;
  EXPECT_NE(listed.output.find("campus-trot/icp/1"), std::string::npos) << listed;
  EXPECT_FALSE(fs::exists(scratch_.path() / "out"));
}

TEST_F(Compare, PartOfTheScansIsComparedWithPartOfTheTruth) {
  ASSERT_EQ(compare({"left", "--count", "6", "-o", "out", "--no-figures"}).exit_code, 0);
  EXPECT_EQ(result(results("out"), "left", "paper")["outcome"], "whole");
  EXPECT_EQ(results("out")["rules"]["cover"], "auto");
  ASSERT_EQ(
      compare({"left", "--count", "6", "--cover", "truth", "-o", "out", "--no-figures"}).exit_code,
      0);
  EXPECT_EQ(result(results("out"), "left", "paper")["outcome_text"], "stopped at 45 %");
  EXPECT_EQ(results("out")["rules"]["cover"], "truth");
}

/// A recording's truth, so much [s] later.
std::string later_truth(const std::string& text, double by) {
  std::istringstream truth(text);
  std::string later;
  for (std::string line; std::getline(truth, line);) {
    const std::size_t blank = line.find(' ');
    later += line.starts_with('#')
                 ? line
                 : fmt::format("{:.9f}{}", std::stod(line) + by, line.substr(blank));
    later += '\n';
  }
  return later;
}

// The last scan's partner is taken a little after it.
TEST_F(Compare, PartOfATruthHoldsThePartnersOfItsEnds) {
  for (const double by : {0.003, -0.003}) {
    write_content(scratch_.path() / "beside.tum", later_truth(content("left/gt.tum"), by));
    ASSERT_EQ(compare({"left", "--methods", "paper", "--no-figures", "-o", "beside", "--count", "6",
                       "--truth=beside.tum", "--max-diff", "0.005"})
                  .exit_code,
              0);
    EXPECT_EQ(result(results("beside"), "left", "paper")["evaluation"]["pairs"], 6) << by;
  }
}

TEST_F(Compare, PartOfATruthWhoseClockIsOffIsTheSamePart) {
  write_content(scratch_.path() / "later.tum", later_truth(content("left/gt.tum"), 2.0));
  for (const std::vector<std::string>& part :
       {std::vector<std::string>{"--count", "6"}, std::vector<std::string>{"--cover=recording"}}) {
    std::vector<std::string> usual = {"left", "--methods", "paper", "--no-figures", "-o", "usual"};
    std::vector<std::string> moved = usual;
    moved.back() = "moved";
    moved.insert(moved.end(), {"--truth=later.tum", "--offset", "2"});
    for (auto* arguments : {&usual, &moved}) {
      arguments->insert(arguments->end(), part.begin(), part.end());
      ASSERT_EQ(compare(*arguments).exit_code, 0);
    }
    const json one = result(results("usual"), "left", "paper");
    const json other = result(results("moved"), "left", "paper");
    EXPECT_EQ(other["outcome"], "whole") << other;
    EXPECT_NEAR(other["evaluation"]["coverage"].get<double>(), one["evaluation"]["coverage"], 1e-6);
    EXPECT_EQ(other["evaluation"]["pairs"], one["evaluation"]["pairs"]);
  }
}

}  // namespace
}  // namespace surefoot::test
