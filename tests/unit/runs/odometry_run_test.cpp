// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/odometry_run.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/file_writer.hpp"
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
  std::ifstream file(folder_ / "out" / kDescriptionFile);
  const std::string description{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(description.find("no map after loops: "), std::string::npos) << description;
}

}  // namespace
}  // namespace surefoot::runs
