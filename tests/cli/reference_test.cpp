// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot reference: a run's folder, of all scans at once.
#include <gtest/gtest.h>

#include <csignal>

#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr int kReferredScans = 12;

/// "in" in a folder of its own.
class ReferenceCommand : public testing::Test {
 protected:
  void SetUp() override { write_pcd_recording(scratch_.path() / "in", hall_scans(kReferredScans)); }

  [[nodiscard]] ProcessResult surefoot(const std::vector<std::string>& arguments) const {
    return run_surefoot(arguments, scratch_.path());
  }
  [[nodiscard]] std::string content(const fs::path& file) const {
    return file_content(scratch_.path() / file);
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
    const ProcessResult result = surefoot(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find(named), std::string::npos) << "not named: " << named << result;
    EXPECT_FALSE(fs::exists(scratch_.path() / "out")) << result;
  }

  const ScratchFolder scratch_;
};

TEST_F(ReferenceCommand, LeavesARunsFolderThatSaysWhatItIs) {
  const ProcessResult result = surefoot({"reference", "in", "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("12 scans at once"), std::string::npos) << result;
  ASSERT_EQ(surefoot({"run", "in", "-o", "run"}).exit_code, 0);
  for (const auto& file : fs::directory_iterator(scratch_.path() / "run")) {
    EXPECT_TRUE(fs::exists(scratch_.path() / "out" / file.path().filename())) << file.path();
  }
  EXPECT_NE(content("out/run.yaml").find("a reference: "), std::string::npos);
  const std::string tum = content("out/trajectory.tum");
  EXPECT_NE(tum.substr(0, tum.find('\n')).find("a reference: "), std::string::npos) << tum;
  EXPECT_EQ(io::read_tum(scratch_.path() / "out/trajectory.tum").size(), kReferredScans);
  EXPECT_NE(tum, content("run/trajectory.tum"));
}

TEST_F(ReferenceCommand, SameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    const ProcessResult result = surefoot({"reference", "in", "-o", threads, "--threads", threads});
    ASSERT_EQ(result.exit_code, 0) << result;
  }
  for (const char* name : {"trajectory.tum", "trajectory_kitti.txt", "map.ply"}) {
    EXPECT_FALSE(content(fs::path("1") / name).empty());
    EXPECT_EQ(content(fs::path("1") / name), content(fs::path("3") / name)) << name;
  }
}

TEST_F(ReferenceCommand, SameTrajectoryFromEveryContainer) {
  ASSERT_EQ(surefoot({"reference", "in", "-o", "expected"}).exit_code, 0);
  for (const std::string name : {"in.mcap", "in.bag"}) {
    ASSERT_EQ(surefoot({"convert", "in", name, "-q"}).exit_code, 0) << name;
    const ProcessResult result = surefoot({"reference", name, "-o", name + "-out"});
    ASSERT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(content(name + "-out/trajectory.tum"), content("expected/trajectory.tum")) << name;
  }
}

TEST_F(ReferenceCommand, UsesTheScansAndParametersThatItIsToldTo) {
  const ProcessResult result =
      surefoot({"reference", "in", "-o", "out", "--start", "1", "--stride", "2", "--count", "4",
                "--set", "knots.segments=4", "--pose-rate", "100"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(io::read_tum(scratch_.path() / "out/trajectory.tum").size(), 4U);
  EXPECT_NE(content("out/run.yaml").find("segments: 4"), std::string::npos);
  const ProcessResult again =
      surefoot({"reference", "--config", "out/run.yaml", "-o", "again", "-q"});
  ASSERT_EQ(again.exit_code, 0) << again;
  EXPECT_EQ(content("again/trajectory_dense.tum"), content("out/trajectory_dense.tum"));
}

TEST_F(ReferenceCommand, IsNotRepeatedAsAnOrdinaryRun) {
  ASSERT_EQ(surefoot({"reference", "in", "-o", "first", "-q"}).exit_code, 0);
  expect_refused({"run", "--config", "first/run.yaml", "-o", "out"},
                 "is of surefoot reference, which repeats it: surefoot reference --config");
  std::string old = content("first/run.yaml");  // from before it told its command
  const std::string line = "command: reference\n";
  ASSERT_NE(old.find(line), std::string::npos) << old;
  write_content(scratch_.path() / "old.yaml", old.erase(old.find(line), line.size()));
  EXPECT_EQ(surefoot({"run", "--config", "old.yaml", "-o", "run", "-q"}).exit_code, 0);
  // A run's becomes a reference where that is what is asked for.
  ASSERT_EQ(surefoot({"reference", "--config", "run/run.yaml", "-o", "again", "-q"}).exit_code, 0);
  EXPECT_EQ(content("again/trajectory.tum"), content("first/trajectory.tum"));
}

TEST_F(ReferenceCommand, RefusesWhatCannotBeOne) {
  expect_refused({"reference", "in", "-o", "out", "--method", "paper"}, "--method");
  expect_refused({"reference", "nowhere", "-o", "out"}, "nowhere");
  expect_refused({"reference", "in", "-o", "out", "--start", "12"}, "in");
  expect_refused({"reference", "in", "-o", "out", "--set", "knots.wings=2"}, "knots.wings");
}

TEST_F(ReferenceCommand, InterruptedItLeavesAnEarlierOneAlone) {
  ASSERT_EQ(surefoot({"reference", "in", "-o", "out", "-q"}).exit_code, 0);
  const std::string before = content("out/trajectory.tum");
  write_long_recording(scratch_.path() / "long", 20'000);
  const Process process({"reference", "long", "-o", "out"}, scratch_.path());
  process.wait_until_catching(SIGINT);
  process.send(SIGINT);
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 130) << result;
  EXPECT_NE(result.output.find("nothing is written"), std::string::npos) << result;
  EXPECT_EQ(content("out/trajectory.tum"), before);
  EXPECT_TRUE(fs::exists(scratch_.path() / "out/run.yaml"));
}

}  // namespace
}  // namespace surefoot::test
