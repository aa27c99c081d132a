// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/odometry_run.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/file_writer.hpp"
#include "runs/report_maker.hpp"
#include "runs/run_files.hpp"
#include "support/memory_recording.hpp"
#include "support/scratch.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::runs {
namespace {

namespace fs = std::filesystem;

class OdometryRunTest : public test::Scratch {
 protected:
  OdometryRunTest() {
    options_.input = "memory";
    options_.is_live = true;
    options_.output = folder_ / "out";
    options_.no_picture = options_.no_report = true;
    listener_.say = [](const std::string&) {};
    listener_.progress = [](std::size_t, double) {};
    listener_.interrupted = [] { return false; };
  }

  [[nodiscard]] std::string text_of(const char* name) const {
    std::ifstream file(options_.output / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  RunOptions options_;
  RunListener listener_;
  test::MemoryRecording recording_{test::take_scans(test::furnished_hall(), test::standing({}), 3)};
};

/// Hours of odometry are not lost with it.
TEST_F(OdometryRunTest, AMapThatCannotBeFinishedLeavesTheRest) {
  options_.loop_closure = options_.no_loops = true;
  listener_.started = [](const fs::path& folder, RunControl&) {
    fs::create_directory(folder / kLoopsFile);  // where a file is to be
  };
  EXPECT_THROW((void)run_odometry(options_, listener_, recording_), io::WriteError);
  for (const char* name : {kMapFile, kTrajectoryFile, kScansFile}) {
    EXPECT_TRUE(fs::exists(folder_ / "out" / name)) << name;
  }
  const std::string description = text_of(kDescriptionFile);
  EXPECT_NE(description.find("no map after loops: "), std::string::npos) << description;
}

TEST_F(OdometryRunTest, APageThatCannotBeWrittenIsALoss) {
  if (!has_report_page()) GTEST_SKIP() << "built without the report";
  options_.no_report = false;
  listener_.started = [](const fs::path& folder, RunControl&) {
    fs::create_directory(folder / kReportFile);
  };
  const RunOutcome outcome = run_odometry(options_, listener_, recording_);
  ASSERT_EQ(outcome.losses.size(), 1);
  EXPECT_NE(outcome.losses[0].find(std::string("no ") + kReportFile), std::string::npos);
  EXPECT_EQ(outcome.poses, 3);
}

TEST_F(OdometryRunTest, InterruptedBeforeItsFirstScanLeavesTheEarlierRun) {
  options_.loop_closure = options_.save_map = options_.overwrite = true;
  test::MemoryRecording again = recording_;
  (void)run_odometry(options_, listener_, recording_);
  std::map<std::string, std::string> before;
  for (const char* name : {kMapFile, kTrajectoryFile, kScansFile, kSavedMapFile}) {
    before[name] = text_of(name);
    EXPECT_FALSE(before[name].empty()) << name;
  }
  listener_.interrupted = [] { return true; };
  const RunOutcome outcome = run_odometry(options_, listener_, again);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.scans(), 0);
  for (const auto& [name, text] : before) EXPECT_EQ(text_of(name.c_str()), text) << name;
}

/// The files are new by then.
TEST_F(OdometryRunTest, InterruptedOnceItHasBegunWritesAPose) {
  bool interrupted = false;
  listener_.started = [&](const fs::path&, RunControl&) { interrupted = true; };
  listener_.interrupted = [&] { return interrupted; };
  const RunOutcome outcome = run_odometry(options_, listener_, recording_);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.poses, 1);
}

}  // namespace
}  // namespace surefoot::runs
