// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a person meets who tries the program for the first time.
#include <gtest/gtest.h>

#include "capture.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

class FirstHour : public testing::Test {
 protected:
  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] ProcessResult run(const std::vector<std::string>& arguments) const {
    return run_surefoot(arguments, scratch_.path());
  }
  [[nodiscard]] std::string refusal(const std::vector<std::string>& arguments) const {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    return result.errors;
  }
  ScratchFolder scratch_;
};

TEST_F(FirstHour, AMisspeltCommandIsRecognised) {
  EXPECT_NE(refusal({"runn", "in"}).find("did you mean 'run'?"), std::string::npos);
  EXPECT_NE(refusal({"comapre"}).find("did you mean 'compare'?"), std::string::npos);
  EXPECT_EQ(refusal({"walk"}).find("did you mean"), std::string::npos);
  EXPECT_NE(refusal({"run", "in", "--out", "x"}).find("did you mean '--output'?"),
            std::string::npos);
  EXPECT_NE(refusal({"run", "in", "--cuont", "5"}).find("did you mean '--count'?"),
            std::string::npos);
  EXPECT_NE(refusal({"info", "in", "-o", "out"}).find("info: not expected: -o out; --help"),
            std::string::npos);
}

TEST_F(FirstHour, HelpSpeaksOfWords) {
  for (const char* command : {"run", "info", "eval", "compare", "ablate", "sweep"}) {
    const ProcessResult help = run({command, "--help"});
    EXPECT_EQ(help.output.find("ENUM"), std::string::npos) << help;
    EXPECT_EQ(help.output.find("value in {"), std::string::npos) << help;
  }
  write_pcd_recording(path("in"), hall_scans(1));
  const std::string error = refusal({"run", "in", "--stamp-at", "middle"});
  EXPECT_NE(error.find("'middle'; expected one of start, end"), std::string::npos) << error;
  EXPECT_NE(refusal({"eval", "a", "b", "--align", "up"}).find("one of none, origin"),
            std::string::npos);
}

TEST_F(FirstHour, MillimetresAreRefused) {
  std::vector<Scan> scans = hall_scans(2);
  for (Scan& scan : scans) {
    for (Eigen::Vector3f& point : scan.points) point *= 1000.0F;
  }
  write_pcd_recording(path("in"), scans);
  const std::string error = refusal({"run", "in", "-o", "out"});
  EXPECT_NE(error.find("in: 000000.pcd: half of the points"), std::string::npos) << error;
  EXPECT_NE(error.find("millimetres?"), std::string::npos) << error;
  EXPECT_FALSE(fs::exists(path("out")));
  const ProcessResult told = run({"info", "in"});
  EXPECT_NE(told.output.find("millimetres?"), std::string::npos) << told;
}

TEST_F(FirstHour, ACaptureMayLieInAFolderAndBeWrittenInCapitals) {
  std::vector<std::string> packets = vlp16_packets(3);
  packets.pop_back();
  fs::create_directory(path("in"));
  write_content(path("in/walk.PCAP"), pcap_file(packets));
  write_content(path("in/notes.txt"), "");
  ASSERT_EQ(run({"run", "in/walk.PCAP", "-o", "file"}).exit_code, 0);
  const ProcessResult folder = run({"run", "in", "-o", "folder"});
  ASSERT_EQ(folder.exit_code, 0) << folder;
  const std::string trajectory = file_content(path("file/trajectory.tum"));
  EXPECT_GT(lines_of(path("file/trajectory.tum")), 1U);
  EXPECT_EQ(trajectory, file_content(path("folder/trajectory.tum")));
  write_content(path("in/other.pcapng"), "");
  EXPECT_NE(refusal({"run", "in", "-o", "two"}).find("2 captures and 1 other file;"),
            std::string::npos);
}

TEST_F(FirstHour, WhatTheSystemRefusesIsSaidPlainly) {
  write_pcd_recording(path("in"), hall_scans(2));
  write_content(path("a_file"), "");
  fs::copy(path("in"), path("with_truth"));
  io::write_tum(path("with_truth/gt.tum"), {{0, Pose()}, {300'000'000, Pose()}});
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "in", "-o", "a_file"},
        {"run", "in", "-o", "a_file/out"},
        {"compare", "with_truth", "-o", "a_file"},
        {"compare", "with_truth", "-o", "a_file/out"}}) {
    const std::string error = refusal(arguments);
    EXPECT_EQ(error.find("filesystem error"), std::string::npos) << error;
    EXPECT_NE(error.find("a_file"), std::string::npos) << error;
  }
}

TEST_F(FirstHour, ARunsFolderIsNoRecording) {
  write_pcd_recording(path("in"), hall_scans(3));
  ASSERT_EQ(run({"run", "in", "-o", "out"}).exit_code, 0);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "out", "-o", "again"},
        {"info", "out"},
        {"check", "out"},
        {"convert", "out", "out.mcap"}}) {
    EXPECT_NE(refusal(arguments).find("is the folder of a run"), std::string::npos) << arguments[0];
  }
}

TEST_F(FirstHour, EvalTakesARunsFolder) {
  write_pcd_recording(path("in"), hall_scans(3));
  ASSERT_EQ(run({"run", "in", "-o", "out/one"}).exit_code, 0);
  fs::copy_file(path("out/one/trajectory.tum"), path("in/gt.tum"));
  const ProcessResult result = run({"eval", "in", "out/one/", "--align", "none"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("one: 3 of 3 poses paired"), std::string::npos) << result;
}

TEST_F(FirstHour, EvalShiftsByWholeEpochs) {
  Trajectory early, late;
  for (int i = 0; i < 5; ++i) {
    const Pose pose{Eigen::Quaterniond::Identity(), {0.1 * i, 0.01 * i * i, 0.0}};
    early.push_back({i * 100'000'000LL, pose});
    late.push_back({1'795'000'000'000'000'000LL + i * 100'000'000LL, pose});
  }
  io::write_tum(path("early.tum"), early);
  io::write_tum(path("late.tum"), late);
  const ProcessResult result =
      run({"eval", "late.tum", "early.tum", "--align", "none", "--offset", "1795000000"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("5 of 5 poses paired"), std::string::npos) << result;
}

TEST_F(FirstHour, StampsBeyondAllTimeAreRefused) {
  write_content(path("far.tum"), "-9223372036 0 0 0 0 0 0 1\n9223372036 1 0 0 0 0 0 1\n");
  EXPECT_NE(refusal({"eval", "far.tum", "far.tum"}).find("1970"), std::string::npos);
}

TEST_F(FirstHour, AMissingTruthIsToldBeforeAnythingIsRun) {
  write_pcd_recording(path("in"), hall_scans(2));
  for (const char* command : {"compare", "ablate"}) {
    EXPECT_NE(refusal({command, "in"}).find("gt.tum"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("results")));
  }
}

TEST_F(FirstHour, AReportOfARunWithoutScansIsNoCrash) {
  write_pcd_recording(path("in"), hall_scans(3));
  ASSERT_EQ(run({"run", "in", "-o", "out"}).exit_code, 0);
  const std::string csv = file_content(path("out/scans.csv"));
  write_content(path("out/scans.csv"), csv.substr(0, csv.find('\n') + 1));
  const ProcessResult result =
      run({"report", "out", "--truth", "out/trajectory.tum", "-o", "page.html"});
  EXPECT_EQ(result.signal, 0) << result;
  EXPECT_LE(result.exit_code, 2) << result;
}

}  // namespace
}  // namespace surefoot::test
