// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot run --config run.yaml: the run again, to the byte.
#include <gtest/gtest.h>

#include "process.hpp"
#include "recordings.hpp"
#include "same_files.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

class Restore : public testing::Test {
 protected:
  Restore() {
    const std::vector<Scan> scans = hall_scans(12);
    write_pcd_recording(path("in"), scans);
    std::string stamps;
    for (Scan scan : scans) {
      scan.stamp_ns += 7'000'000'000;
      stamps += stamp_line(scan);
    }
    write_content(path("stamps.txt"), stamps);
    // Every option that changes what is read or written; a relative path among them.
    const ProcessResult first = run_surefoot({"run",
                                              "in",
                                              "-o",
                                              "first",
                                              "--start",
                                              "2",
                                              "--stride",
                                              "2",
                                              "--count",
                                              "4",
                                              "--pose-of",
                                              "base",
                                              "--extrinsic",
                                              "0.1,0,0.5,0,2,10",
                                              "--map-voxel",
                                              "0.3",
                                              "--pose-rate",
                                              "20",
                                              "--no-picture",
                                              "--no-report",
                                              "--stamps",
                                              "stamps.txt",
                                              "--stamp-at",
                                              "end",
                                              "--time-unit",
                                              "auto",
                                              "--no-vertical-correction",
                                              "--set",
                                              "knots.segments=4"},
                                             scratch_.path());
    EXPECT_EQ(first.exit_code, 0) << first;
    fs::create_directory(path("elsewhere"));
  }
  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] ProcessResult again(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"run", "--config", "../first/run.yaml"});
    return run_surefoot(arguments, path("elsewhere"));
  }

  ScratchFolder scratch_;
};

TEST_F(Restore, EveryFileIsTheSame) {
  const ProcessResult result = again({"-o", "second"});
  ASSERT_EQ(result.exit_code, 0) << result;
  for (const char* name :
       {"trajectory.tum", "trajectory_dense.tum", "trajectory_kitti.txt", "map.ply"}) {
    const std::string first = file_content(path("first") / name);
    EXPECT_FALSE(first.empty()) << name;
    EXPECT_TRUE(first == file_content(path("elsewhere/second") / name)) << name;
  }
  EXPECT_EQ(lines_of(path("elsewhere/second/trajectory.tum")), 5U);
  EXPECT_FALSE(fs::exists(path("elsewhere/second/picture.png")));
  EXPECT_NE(result.errors.find("--start=2"), std::string::npos) << result;
  // And the second run's description repeats it again.
  const ProcessResult third =
      run_surefoot({"run", "--config", "second/run.yaml", "-o", "third"}, path("elsewhere"));
  ASSERT_EQ(third.exit_code, 0) << third;
  EXPECT_TRUE(file_content(path("elsewhere/third/map.ply")) == file_content(path("first/map.ply")));
}

TEST_F(Restore, FlagsGoBefore) {
  const ProcessResult result =
      again({"-o", "second", "--count", "2", "--pose-of", "lidar", "--no-map"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(lines_of(path("elsewhere/second/trajectory.tum")), 3U);
  EXPECT_NE(file_content(path("elsewhere/second/trajectory.tum")).find("T_world_lidar"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(path("elsewhere/second/map.ply")));
}

TEST_F(Restore, OptionsThatCannotBeAreRefused) {
  for (const char* options : {"options: {fly: 3}", "options: {stride: 0}", "options: {config: a}",
                              "options: {time-unit: fortnights}"}) {
    write_content(path("bad.yaml"),
                  std::string("input: {path: in}\n") + options + "\nparameters: {}\n");
    const ProcessResult result =
        run_surefoot({"run", "--config", "bad.yaml", "-o", "out"}, scratch_.path());
    EXPECT_EQ(result.exit_code, 2) << options << result;
    EXPECT_NE(result.errors.find("bad.yaml: options"), std::string::npos) << result;
    EXPECT_FALSE(fs::exists(path("out")));
  }
}

TEST(RestoreOfBytes, APathThatIsNoTextIsFoundAgain) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "gar\xe7on", hall_scans(5));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "gar\xe7on", "-o", "first", "--no-report", "--no-picture"},
        std::vector<std::string>{"run", "--config", "first/run.yaml", "-o", "again"}}) {
    const ProcessResult result = run_surefoot(arguments, scratch.path());
    ASSERT_EQ(result.exit_code, 0) << result;
  }
  expect_same_files(scratch.path() / "first", scratch.path() / "again",
                    {"trajectory.tum", "map.ply"});
}

}  // namespace
}  // namespace surefoot::test
