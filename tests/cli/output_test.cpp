// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is written where: nothing that somebody else has made is lost, and what two runs leave is
// never mixed.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr int kEndless = 20'000;  // scans

class OutputFolder : public testing::Test {
 protected:
  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] ProcessResult run(const std::vector<std::string>& arguments) const {
    return run_surefoot(arguments, scratch_.path());
  }
  void wait_for_lines(const fs::path& file, std::size_t lines) const {
    for (int i = 0; i < 3000 && lines_of(file) < lines; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_GE(lines_of(file), lines);
  }
  ScratchFolder scratch_;
};

TEST_F(OutputFolder, OneRunAtATime) {
  write_long_recording(path("in"), kEndless);
  write_pcd_recording(path("short"), hall_scans(3));
  const ScratchFolder elsewhere;  // the two write their stdout.txt into their folders
  const Process first({"run", path("in"), "-o", path("out"), "-q"}, elsewhere.path());
  wait_for_lines(path("out/scans.csv"), 3);
  const ProcessResult second = run({"run", "short", "-o", "out", "--overwrite"});
  EXPECT_EQ(second.exit_code, 2) << second;
  EXPECT_NE(second.errors.find("out: another process"), std::string::npos) << second;
  first.send(SIGKILL);
  (void)first.wait();
  const ProcessResult third = run({"run", "short", "-o", "out"});
  EXPECT_EQ(third.exit_code, 0) << third;
  EXPECT_EQ(lines_of(path("out/scans.csv")), 4U);
}

// A full disk, or a standard error that whoever started it has closed.
TEST_F(OutputFolder, MessagesThatNobodyCanReadEndNothing) {
  write_pcd_recording(path("in"), hall_scans(6));
  const auto shell = [&](const std::string& command) {
    return run_surefoot({"-c", command, SUREFOOT_PROGRAM}, scratch_.path(), {.program = "sh"});
  };
  for (const std::string streams : {"2>&-", "2>/dev/full", ">&- 2>&-"}) {
    const ProcessResult bad = shell("exec \"$0\" info nothing " + streams);
    EXPECT_EQ(bad.exit_code, 2) << streams << bad;
    fs::remove_all(path("out"));
    const ProcessResult good = shell("exec \"$0\" run in -o out " + streams);
    EXPECT_EQ(good.signal, 0) << streams << good;
    EXPECT_TRUE(fs::exists(path("out/run.yaml"))) << streams << good;
  }
  EXPECT_EQ(shell("exec \"$0\" info in >&-").exit_code, 2);
}

// Of a pipe: a connection that is cut, a "| tee" that Ctrl-C has ended, too, a "| head".
TEST_F(OutputFolder, ReadersWhoHaveGoneEndNoRun) {
  write_pcd_recording(path("in"), hall_scans(6));
  const auto shell = [&](const std::string& command) {
    fs::remove(path("pipe"));
    const std::string gone = "mkfifo pipe; (: <pipe) & exec 3>pipe; wait; exec \"$0\" ";
    return run_surefoot({"-c", gone + command, SUREFOOT_PROGRAM}, scratch_.path(),
                        {.program = "sh"});
  };
  ASSERT_EQ(run({"run", "in", "-o", "out"}).exit_code, 0);
  for (const std::string streams : {"2>&3", "2>&3 >&3"}) {
    fs::remove(path("out/run.yaml"));
    const ProcessResult result = shell("run in -o out " + streams);  // says that it replaces files
    EXPECT_TRUE(fs::exists(path("out/run.yaml"))) << streams << result;
    EXPECT_EQ(result.signal, streams == "2>&3" ? 0 : SIGPIPE) << streams << result;
  }
  EXPECT_EQ(shell("info nothing 2>&3").exit_code, 2);
  for (const std::string command : {"datasets", "help run", "manual", "info in"}) {
    const ProcessResult result = shell(command + " >&3");
    EXPECT_EQ(result.signal, SIGPIPE) << command << result;
    EXPECT_EQ(result.errors, "") << command;
  }
}

TEST_F(OutputFolder, AKilledRunIsNotShownWithAnEarlierOnesFiles) {
  write_pcd_recording(path("short"), hall_scans(3));
  write_long_recording(path("in"), kEndless);
  ASSERT_EQ(run({"run", "short", "-o", "out", "--pose-rate", "20"}).exit_code, 0);
  ASSERT_TRUE(fs::exists(path("out/map.ply")));
  const Process second({"run", "in", "-o", "out"}, scratch_.path());
  wait_for_lines(path("out/scans.csv"), 6);
  second.send(SIGKILL);
  (void)second.wait();
  for (const char* name :
       {"run.yaml", "map.ply", "picture.png", "report.html", "trajectory_dense.tum"}) {
    EXPECT_FALSE(fs::exists(path("out") / name)) << name;
  }
}

TEST_F(OutputFolder, ForeignFilesAndTheRecordingAreKept) {
  write_pcd_recording(path("in"), hall_scans(3));
  fs::create_directory(path("mine"));
  write_content(path("mine/trajectory.tum"), "mine");
  const ProcessResult foreign = run({"run", "in", "-o", "mine"});
  EXPECT_EQ(foreign.exit_code, 2) << foreign;
  EXPECT_NE(foreign.errors.find("--overwrite"), std::string::npos) << foreign;
  EXPECT_EQ(file_content(path("mine/trajectory.tum")), "mine");
  EXPECT_EQ(run({"run", "in", "-o", "mine", "--overwrite"}).exit_code, 0);
  const ProcessResult same = run({"run", "in", "-o", "in", "--overwrite"});
  EXPECT_EQ(same.exit_code, 2) << same;
  EXPECT_FALSE(fs::exists(path("in/map.ply")));
}

TEST_F(OutputFolder, NobodysLatestIsRemoved) {
  write_pcd_recording(path("in"), hall_scans(2));
  fs::create_directories(path("results"));
  write_content(path("results/latest"), "mine");
  EXPECT_EQ(run({"run", "in"}).exit_code, 0);
  EXPECT_EQ(file_content(path("results/latest")), "mine");
}

TEST_F(OutputFolder, AFullDiskLeavesNoHalfDescription) {
  write_pcd_recording(path("in"), hall_scans(1));
  const ProcessResult result =
      run_surefoot({"run", "in", "-o", "out", "--no-map", "--no-picture", "--no-report"},
                   scratch_.path(), {.program = {}, .most_file_bytes = 1200});
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("run.yaml"), std::string::npos) << result;
  EXPECT_FALSE(fs::exists(path("out/run.yaml")));
  EXPECT_FALSE(fs::exists(path("out/run.yaml.surefoot-part")));
}

TEST_F(OutputFolder, WhatCannotBePrintedIsAnError) {
  write_pcd_recording(path("in"), hall_scans(2));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info", "in"}, {"info", "in", "--json"}, {"config"}}) {
    const ProcessResult result = run_surefoot(arguments, scratch_.path(), {.output = "/dev/full"});
    EXPECT_EQ(result.exit_code, 2) << arguments.front() << result;
    EXPECT_FALSE(result.errors.empty()) << result;
  }
}

TEST_F(OutputFolder, NamesOfScansDoNotBreakTheTable) {
  write_pcd_recording(path("in"), hall_scans(3));
  fs::rename(path("in") / scan_name(1), path("in/000001\n\r\"b,.pcd"));
  fs::remove(path("in/times.txt"));
  ASSERT_EQ(run({"run", "in", "-o", "out", "--rate", "10"}).exit_code, 0);
  EXPECT_EQ(lines_of(path("out/scans.csv")), 4U);
  const ProcessResult report = run({"report", "out", "-o", "page.html"});
  EXPECT_EQ(report.errors.find("scans.csv"), std::string::npos) << report;
}

#ifdef SUREFOOT_HAS_SIMULATION
TEST_F(OutputFolder, AShorterSimulationLeavesNoOldScans) {
  const auto simulate = [&](const char* scans, std::vector<std::string> more) {
    more.insert(more.begin(), {"simulate", "corridor", "--no-footprint", "--scans", scans});
    return run(more);
  };
  ASSERT_EQ(simulate("6", {"-o", "walk", "--true-points"}).exit_code, 0);
  ASSERT_TRUE(fs::exists(path("walk/true/000005.pcd")));
  ASSERT_EQ(simulate("2", {"-o", "walk"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("walk/000001.pcd")));
  EXPECT_FALSE(fs::exists(path("walk/000002.pcd")));
  EXPECT_FALSE(fs::exists(path("walk/true/000000.pcd")));
  EXPECT_EQ(lines_of(path("walk/times.txt")), 2U);

  write_pcd_recording(path("own"), hall_scans(3));
  const std::string before = file_content(path("own") / scan_name(0));
  const ProcessResult refused = simulate("2", {"-o", "own"});
  EXPECT_EQ(refused.exit_code, 2) << refused;
  EXPECT_NE(refused.errors.find("--overwrite"), std::string::npos) << refused;
  EXPECT_TRUE(before == file_content(path("own") / scan_name(0)));
  EXPECT_EQ(simulate("2", {"-o", "own", "--overwrite"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("own") / scan_name(2)));
}
#endif

}  // namespace
}  // namespace surefoot::test
