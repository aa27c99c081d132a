// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What was computed is not lost by the next command, and what is wrong is not taken for a result.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "io/file_writer.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "runs/run_files.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

class NothingLost : public testing::Test {
 protected:
  NothingLost() { write_bend_recording(path("in"), 0.1, 12); }

  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] ProcessResult surefoot(const std::vector<std::string>& arguments) const {
    return run_surefoot(arguments, scratch_.path());
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& why) const {
    const ProcessResult result = surefoot(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find(why), std::string::npos) << result;
  }

 private:
  const ScratchFolder scratch_;
};

/// Which the run itself moves to its own folder.
TEST_F(NothingLost, TheLatestRunIsRepeatedAndItsMapContinued) {
  ASSERT_EQ(surefoot({"map", "in", "-q"}).exit_code, 0);
  const fs::path first = fs::canonical(path("results/latest"));
  const ProcessResult again = surefoot({"map", "--config", "results/latest/run.yaml", "-q"});
  ASSERT_EQ(again.exit_code, 0) << again;
  EXPECT_EQ(file_content(first / "trajectory.tum"),
            file_content(path("results/latest/trajectory.tum")));
  fs::remove(path("results/latest"));
  fs::create_directory_symlink(first.filename(), path("results/latest"));
  const ProcessResult on = surefoot({"run", "in", "--map", "results/latest", "-q"});
  EXPECT_EQ(on.errors.find("holds the map"), std::string::npos) << on;
  EXPECT_TRUE(fs::exists(first / "map.surefoot"));
}

TEST_F(NothingLost, ARunsOwnParametersRepeatItInItsPlace) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "a", "-q"}).exit_code, 0);
  const std::string before = file_content(path("a/trajectory.tum"));
  const ProcessResult again = surefoot({"run", "--config", "a/run.yaml", "-o", "a", "-q"});
  ASSERT_EQ(again.exit_code, 0) << again;
  EXPECT_EQ(file_content(path("a/trajectory.tum")), before);
  EXPECT_TRUE(fs::exists(path("a/run.yaml")));
}

TEST_F(NothingLost, AMapStaysUnlessItMayGo) {
  ASSERT_EQ(surefoot({"map", "in", "-o", "a", "-q"}).exit_code, 0);
  expect_refused({"run", "in", "-o", "a", "-q"}, "a map to come back to");
  EXPECT_TRUE(fs::exists(path("a/map.surefoot")));
  EXPECT_EQ(surefoot({"run", "in", "-o", "a", "-q", "--overwrite"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("a/map.surefoot")));
}

TEST_F(NothingLost, ARunStaysWhereTheNextCannotReadAScan) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "a", "-q"}).exit_code, 0);
  const std::string before = file_content(path("a/trajectory.tum"));
  expect_refused({"run", "in", "-o", "a", "-q", "--time-field", "none_such"}, "none_such");
  EXPECT_EQ(file_content(path("a/trajectory.tum")), before);
}

TEST_F(NothingLost, ARunIsNoRecordingAndARecordingNoEstimate) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "a", "-q"}).exit_code, 0);
  expect_refused({"run", "a", "-o", "b"}, "folder of a run");
  expect_refused({"eval", "in/gt.tum", "in"}, "is a recording");
  EXPECT_EQ(surefoot({"eval", "in", "a"}).exit_code, 0);
}

/// Which is read before any work, in whatever form.
TEST_F(NothingLost, ARunIsComparedWithTheTruthThatIsGiven) {
  std::string truth = "#t,x,y,z,qx,qy,qz,qw\n";
  for (const StampedPose& pose : io::read_tum(path("in/gt.tum"))) {
    const Eigen::Vector3d& t = pose.pose.translation;
    const Eigen::Quaterniond& q = pose.pose.rotation;
    truth += std::to_string(1e-9 * static_cast<double>(pose.stamp_ns));
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
      truth += "," + std::to_string(value);
    }
    truth += '\n';
  }
  write_content(path("truth.csv"), truth);
  fs::remove(path("in/gt.tum"));
  expect_refused({"run", "in", "-o", "none", "--truth", "in/000000.pcd"}, "000000.pcd");
  EXPECT_FALSE(fs::exists(path("none")));
  const ProcessResult run = surefoot({"run", "in", "-o", "a", "-q", "--truth", "truth.csv"});
  ASSERT_EQ(run.exit_code, 0) << run;
  const std::string page = file_content(path("a/report.html"));
  EXPECT_NE(page.find("truth.csv"), std::string::npos);
}

TEST_F(NothingLost, APageIsNotWrittenOverAMap) {
  ASSERT_EQ(surefoot({"run", "in", "-o", "a", "-q"}).exit_code, 0);
  expect_refused({"report", "a", "-o", "a/map.ply"}, "is no page");
  EXPECT_EQ(file_content(path("a/map.ply")).substr(0, 3), "ply");
  (void)surefoot({"check", "in", "--html", "check.html"});
  const std::string check = file_content(path("check.html"));
  EXPECT_FALSE(check.empty());
  expect_refused({"report", "a", "-o", "check.html"}, "is no page of report's");
  EXPECT_TRUE(file_content(path("check.html")) == check);
  EXPECT_EQ(surefoot({"report", "a", "-o", "page.html"}).exit_code, 0);
  EXPECT_EQ(surefoot({"report", "a", "-o", "page.html"}).exit_code, 0);
}

/// What could be read was, but a script must notice.
TEST_F(NothingLost, ABagThatWasCutShortIsNoSuccess) {
  ASSERT_EQ(surefoot({"convert", "in", "whole.mcap", "-q"}).exit_code, 0);
  const std::string whole = file_content(path("whole.mcap"));
  write_content(path("cut.mcap"), whole.substr(0, whole.size() * 3 / 4));
  EXPECT_EQ(surefoot({"run", "whole.mcap", "-o", "whole", "-q"}).exit_code, 0);
  const ProcessResult cut = surefoot({"run", "cut.mcap", "-o", "cut", "-q"});
  EXPECT_EQ(cut.exit_code, 1) << cut;
  EXPECT_NE(cut.errors.find("cut short"), std::string::npos) << cut;
}

TEST_F(NothingLost, ATruthOfAnotherTimeIsToldWithBoth) {
  Trajectory truth = io::read_tum(path("in/gt.tum"));
  for (StampedPose& pose : truth) pose.stamp_ns += 1'000'000'000'000;
  io::write_tum(path("late.tum"), truth);
  const ProcessResult late = surefoot({"run", "in", "-o", "late", "--truth", "late.tum", "-q"});
  EXPECT_EQ(late.exit_code, 0) << late;
  EXPECT_NE(late.errors.find("late.tum: tells of 1000.0"), std::string::npos) << late;
  EXPECT_NE(late.errors.find("no time in common"), std::string::npos) << late;
  EXPECT_NE(file_content(path("late/run.yaml")).find("no time in common"), std::string::npos);
  for (StampedPose& pose : truth) pose.stamp_ns -= 2'000'000'000'000;
  io::write_tum(path("early.tum"), truth);
  expect_refused({"run", "in", "-o", "early", "--truth", "early.tum"},
                 "expected a truth with the recording's stamps");
  EXPECT_FALSE(fs::exists(path("early")));
}

/// Of what was not looked at nothing is known.
TEST_F(NothingLost, AnInterruptedCheckHasNoVerdict) {
  write_long_recording(path("long"), 20'000);
  const Process process({"check", "long", "--html", "page.html"}, path(""));
  process.wait_until_catching(SIGINT);
  process.send(SIGINT);
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 130) << result;
  EXPECT_EQ(result.output.find("fit for a run"), std::string::npos) << result;
  EXPECT_FALSE(fs::exists(path("page.html")));
}

/// Half a recording under the name of a whole one is not to be told from it.
TEST_F(NothingLost, AnInterruptedConversionKeepsNothing) {
  write_long_recording(path("long"), 20'000);
  for (const char* output : {"out.mcap", "out.bag", "folder"}) {
    const Process process({"convert", "long", output}, path(""));
    const fs::path part = path(std::string(output) + ".surefoot-part");
    for (int waited = 0; !fs::exists(part) && waited < 20'000; ++waited) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    process.send(SIGINT);
    const ProcessResult result = process.wait();
    EXPECT_EQ(result.exit_code, 130) << result;
    EXPECT_NE(result.errors.find("nothing is written"), std::string::npos) << result;
    EXPECT_EQ(result.output, "");
    EXPECT_FALSE(fs::exists(path(output)));
    EXPECT_FALSE(fs::exists(part));
  }
}

}  // namespace
}  // namespace surefoot::test
