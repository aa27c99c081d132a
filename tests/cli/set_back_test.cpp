// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A recording that begins with a scan of no use, and whose clock is set back on the way: what a run
// and a reference leave of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kSecond = 1'000'000'000, kSet = 900 * kSecond;
constexpr std::size_t kBefore = 15, kRefused = 10, kSetBackScans = 35;

class SetBackClock : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<Scan> scans = hall_scans(kSetBackScans);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      scans[i].stamp_ns += (i < kBefore ? 1000 : 100) * kSecond;
    }
    scans[0].points.resize(5);
    scans[0].times_ns.resize(5);
    scans[0].intensities.resize(std::min<std::size_t>(scans[0].intensities.size(), 5));
    scans[0].rings.resize(std::min<std::size_t>(scans[0].rings.size(), 5));
    write_pcd_recording(path("in"), scans);
  }
  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }

  /// The poses of a file, by which clock they are stamped.
  struct Counted {
    std::size_t before = 0, after = 0;
  };
  [[nodiscard]] Counted poses_of(const std::string& file) const {
    Counted counted;
    for (const StampedPose& pose : io::read_tum(path(file))) {
      ++(pose.stamp_ns > kSet ? counted.before : counted.after);
    }
    return counted;
  }
  [[nodiscard]] double least_first_seen(const std::string& file) const {
    std::vector<std::byte> bytes;
    io::read_whole_file(path(file), bytes);
    const io::PointTable table = io::parse_ply(bytes);
    double least = std::numeric_limits<double>::max();
    io::for_each_value(*table.find("first_seen"), table.size, [&](std::size_t, auto value) {
      least = std::min(least, static_cast<double>(value));
    });
    return least;
  }
  const ScratchFolder scratch_;
};

TEST_F(SetBackClock, IsFollowedByWhatARunLeaves) {
  const ProcessResult result =
      run_surefoot({"run", "in", "-o", "out", "--no-repair-stamps", "--pose-rate", "100",
                    "--map-voxel", "0.2", "--loop-closure"},
                   scratch_.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const Counted all = poses_of("out/trajectory.tum");
  EXPECT_EQ(all.before, kBefore - 1);
  EXPECT_EQ(all.after, kSetBackScans - kBefore - kRefused);
  const Counted dense = poses_of("out/trajectory_dense.tum");
  EXPECT_GT(dense.before, all.before);
  EXPECT_GT(dense.after, all.after);
  EXPECT_EQ(least_first_seen("out/map.ply"), 0.0) << "of the first scan that was placed";
  const Counted moved = poses_of("out/trajectory_optimized.tum");
  EXPECT_EQ(moved.before, all.before);
  EXPECT_EQ(moved.after, all.after);
}

TEST_F(SetBackClock, HasTimeInCommonWithItsTruth) {
  const std::vector<std::string> run = {"run", "in", "--no-repair-stamps", "-q", "--no-map", "-o"};
  const auto run_with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), run.begin(), run.end());
    return run_surefoot(more, scratch_.path());
  };
  ASSERT_EQ(run_with({"first"}).exit_code, 0);
  Trajectory truth = io::read_tum(path("first/trajectory.tum"));
  std::erase_if(truth, [](const StampedPose& pose) { return pose.stamp_ns < kSet; });
  io::write_tum(path("truth.tum"), truth);
  const ProcessResult result = run_with({"second", "--truth", "truth.tum"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(result.errors.find("no time in common"), std::string::npos) << result;
}

TEST_F(SetBackClock, OneWrongStampRefusesNoTruth) {
  std::vector<Scan> scans = hall_scans(20);
  io::write_tum(path("truth.tum"), {{scans[1].stamp_ns, {}}, {scans.back().stamp_ns, {}}});
  scans[0].stamp_ns += 5000 * kSecond;
  write_pcd_recording(path("odd"), scans);
  const ProcessResult result = run_surefoot(
      {"run", "odd", "-o", "out", "--no-repair-stamps", "--truth", "truth.tum"}, scratch_.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(io::read_kitti_poses(path("out/trajectory_kitti.txt")).size(), scans.size());
}

TEST_F(SetBackClock, IsFollowedByAReference) {
  const ProcessResult result =
      run_surefoot({"reference", "in", "-o", "out", "--no-repair-stamps"}, scratch_.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const Counted all = poses_of("out/trajectory.tum");
  EXPECT_EQ(all.before, kBefore - 1);
  EXPECT_EQ(all.after, kSetBackScans - kBefore - kRefused);
}

}  // namespace
}  // namespace surefoot::test
