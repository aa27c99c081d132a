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
#include "support/scratch.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::runs {
namespace {

namespace fs = std::filesystem;

/// Scans out of memory.
class Scans : public io::Recording {
 public:
  explicit Scans(std::vector<Scan> scans) : scans_(std::move(scans)) {}
  std::optional<io::ScanItem> next() override {
    if (next_ == scans_.size()) return std::nullopt;
    io::ScanItem item;
    item.name = "scan " + std::to_string(next_);
    item.scan = scans_[next_++];
    return item;
  }
  std::optional<std::size_t> size() const override { return scans_.size(); }
  void skip(std::size_t scans) override { next_ = std::min(next_ + scans, scans_.size()); }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return "memory"; }

 private:
  std::vector<Scan> scans_;
  std::size_t next_ = 0;
  std::vector<std::string> notes_;
};

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
  Scans recording_{test::take_scans(test::furnished_hall(), test::standing({}), 3)};
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
