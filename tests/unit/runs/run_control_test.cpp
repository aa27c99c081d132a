// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What may be asked of a run while it goes on.
#include <fstream>
#include <iterator>

#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "runs/odometry_run.hpp"
#include "runs/run_files.hpp"
#include "runs/saved_map.hpp"
#include "support/memory_recording.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

namespace fs = std::filesystem;

std::vector<Scan> two_scans() {
  std::vector<Scan> scans(2);
  for (std::size_t n = 0; n < scans.size(); ++n) {
    scans[n].stamp_ns = 100'000'000 * static_cast<std::int64_t>(n + 1);
    for (int i = 0; i < 50; ++i) scans[n].points.push_back({5.0F, 0.1F * float(i), 0.0F});
  }
  return scans;
}

class RunControlTest : public test::Scratch {
 protected:
  /// @param ask what before its first scan.
  void run(const std::function<void(RunControl&)>& ask) {
    options_.input = folder_ / "none";
    options_.output = folder_ / "out";
    options_.no_picture = options_.no_report = true;
    RunListener listener{[](const std::string&) {}, [](std::size_t, double) {},
                         [] { return false; }};
    listener.started = [&](const fs::path&, RunControl& control) { ask(control); };
    test::MemoryRecording scans(two_scans());
    (void)run_odometry(options_, listener, scans);
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    std::ifstream in(folder_ / "out" / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  RunOptions options_;
};

TEST_F(RunControlTest, AMapThatIsNotKeptIsNotSaved) {
  run([](RunControl& control) { EXPECT_TRUE(fs::exists(control.save_map())); });
  options_.no_map = true;
  run([](RunControl& control) { EXPECT_THROW((void)control.save_map(), std::invalid_argument); });
  EXPECT_FALSE(fs::exists(folder_ / "out" / kMapFile));
}

TEST_F(RunControlTest, PosesInAMapOutliveThatItIsSearchedAgainAndThatAnotherIs) {
  for (const char* folder : {"a", "b"}) {
    fs::create_directory(folder_ / folder);
    write_saved_map(folder_ / folder / kSavedMapFile, {});
  }
  const auto found = [&](const std::string& poses) {  // where the run writes them
    std::ofstream(folder_ / "out" / kMapFrameTrajectoryFile, std::ios::app) << poses;
  };
  run([&](RunControl& control) {
    control.localize(folder_ / "a");
    found("in a");
    control.localize({});
    control.localize(folder_ / "a" / kSavedMapFile);
    EXPECT_EQ(content(kMapFrameTrajectoryFile), "in a");
    control.localize(folder_ / "b");
    EXPECT_EQ(content(kMapFrameTrajectoryFile), "");
    control.localize(folder_ / "a");  // of b there is nothing to keep
    found("in a again");
    control.localize(folder_ / "b");
  });
  EXPECT_EQ(content("trajectory_map_1.tum"), "in a");
  EXPECT_EQ(content("trajectory_map_2.tum"), "in a again");
  EXPECT_FALSE(fs::exists(folder_ / "out/trajectory_map_3.tum"));
}

TEST_F(RunControlTest, TheMapKeepsWhatCameBeforeAReset) {
  const auto points = [&] {
    std::vector<std::byte> bytes;
    io::read_whole_file(folder_ / "out" / kMapFile, bytes);
    return io::parse_ply(bytes).size;
  };
  run([](RunControl&) {});
  const std::size_t once = points();
  options_.reset_before = {200'000'000};
  run([](RunControl&) {});
  EXPECT_EQ(points(), 2 * once);
}

}  // namespace
}  // namespace surefoot::runs
