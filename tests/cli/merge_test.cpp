// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot merge, and run --map: maps of one place become one, where the exact truth has them;
// look- alike places never do.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <vector>

#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

class MergeCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchFolder>();
    // The same buildings, other furniture, another start.
    simulated_ = simulate("campus", "3101", "3101", "150", "2.4", "one") &&
                 simulate("campus", "3101", "777", "160", "2.4", "two");
    if (!simulated_) return;  // built without the simulation
    map_part("one", "0", "150", "one-map");
    map_part("two", "40", "120", "two-map");
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  void SetUp() override {
    if (!simulated_) GTEST_SKIP() << "built without the simulation";
  }
  [[nodiscard]] static fs::path path(const std::string& name) { return scratch_->path() / name; }
  [[nodiscard]] static ProcessResult surefoot(const std::vector<std::string>& arguments) {
    return run_surefoot(arguments, scratch_->path());
  }
  static bool simulate(const std::string& scene, const std::string& layout, const std::string& seed,
                       const std::string& scans, const std::string& speed,
                       const std::string& name) {
    return surefoot({"simulate", scene, "--layout", layout, "--seed", seed, "--scans", scans,
                     "--speed", speed, "--no-footprint", "--format", "pcap", "-q", "-o", name})
               .exit_code == 0;
  }
  static void map_part(const std::string& recording, const std::string& start,
                       const std::string& count, const std::string& name) {
    const ProcessResult result =
        surefoot({"map", recording, "--start", start, "--count", count, "-o", name, "--no-report",
                  "--no-picture", "--no-map", "-q"});
    ASSERT_EQ(result.exit_code, 0) << result;
  }
  /// Goes on with a map.
  static ProcessResult continue_map(const std::string& map, const std::string& folder,
                                    bool overwrite = false) {
    std::vector<std::string> arguments = {"run", "two", "--start", "30",          "--map",
                                          map,   "-o",  folder,    "--no-report", "--no-picture"};
    if (overwrite) arguments.emplace_back("--overwrite");
    return surefoot(arguments);
  }
  /// The recording's exact pose at an instant.
  static Pose truth_at(const std::string& recording, std::int64_t stamp_ns) {
    const Trajectory truth = io::read_tum(path(recording) / "gt.tum");
    const auto next = std::find_if(truth.begin(), truth.end(), [&](const StampedPose& pose) {
      return pose.stamp_ns >= stamp_ns;
    });
    return next == truth.end() ? truth.back().pose : next->pose;  // one every 2.5 ms
  }

  /// Pieces of both maps, in the first one's frame.
  static void expect_true_pieces(const std::string& file) {
    const Trajectory map = io::read_tum(path("one-map/trajectory_optimized.tum"));
    const Pose T_truth_map = truth_at("one", map.front().stamp_ns) * map.front().pose.inverse();
    std::istringstream lines(file_content(path(file)));
    std::string line;
    std::getline(lines, line);
    std::array<int, 3> of_map{};
    while (std::getline(lines, line)) {
      int number = 0;
      double stamp = 0.0;
      Eigen::Vector3d at;
      ASSERT_EQ(std::sscanf(line.c_str(), "%d,%lf,%lf,%lf,%lf", &number, &stamp, &at.x(), &at.y(),
                            &at.z()),
                5)
          << line;
      ASSERT_TRUE(number == 1 || number == 2) << line;
      ++of_map.at(static_cast<std::size_t>(number));
      const Pose truth = truth_at(number == 1 ? "one" : "two", std::llround(1e9 * stamp));
      EXPECT_LT((T_truth_map * at - truth.translation).norm(), 0.3) << line;
    }
    EXPECT_GT(of_map[1], 3);
    EXPECT_GT(of_map[2], 3);
  }

  static inline std::unique_ptr<ScratchFolder> scratch_;
  static inline bool simulated_ = false;
};

TEST_F(MergeCommand, JoinsMapsOfOnePlace) {
  const ProcessResult result = surefoot({"merge", "one-map", "two-map", "-o", "joint"});
  ASSERT_EQ(result.exit_code, 0) << result;
  expect_true_pieces("joint/pieces.csv");
  EXPECT_NE(result.output.find("two-map: joined by"), std::string::npos) << result;
  EXPECT_GT(lines_of(path("joint/loops.csv")), 10U);
  EXPECT_GT(fs::file_size(path("joint/map.surefoot")), fs::file_size(path("one-map/map.surefoot")));
  const ProcessResult again = surefoot({"merge", "one-map", "two-map", "-o", "joint"});
  EXPECT_EQ(again.exit_code, 2) << "what is there is overwritten" << again;
  EXPECT_EQ(surefoot({"merge", "one-map", "-o", "alone"}).exit_code, 2);
  EXPECT_EQ(surefoot({"merge", "one-map", "nowhere", "-o", "alone"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(path("alone")));
}

TEST_F(MergeCommand, TellsWhatNothingHoldsAndLeavesItOut) {
  mapping::SavedMap torn = runs::read_saved_map(path("two-map"));
  const std::size_t last = torn.pieces.size() - 1;
  torn.pieces.back().restarted = true;
  std::erase_if(torn.edges, [&](const mapping::PoseEdge& edge) {
    return edge.from == last || edge.to == last;
  });
  fs::create_directory(path("torn"));
  runs::write_saved_map(path("torn/map.surefoot"), torn);
  const ProcessResult result = surefoot({"merge", "one-map", "torn", "-o", "one-and-torn"});
  ASSERT_EQ(result.exit_code, 0) << result;
  const std::string told = "torn: " + std::to_string(last) + " of its " + std::to_string(last + 1) +
                           " pieces are held to it; the others are left out";
  EXPECT_NE(result.output.find(told), std::string::npos) << result;
}

TEST_F(MergeCommand, ARunGoesOnWithAMapInItsFrame) {
  const std::string before = file_content(path("one-map/map.surefoot"));
  const ProcessResult result = continue_map("one-map", "on");
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("the map is continued"), std::string::npos) << result;
  EXPECT_EQ(file_content(path("one-map/map.surefoot")), before);
  EXPECT_FALSE(fs::exists(path("on/map_apart.surefoot")));
  const Trajectory map = io::read_tum(path("one-map/trajectory_optimized.tum"));
  const Trajectory run = io::read_tum(path("on/trajectory_optimized.tum"));
  ASSERT_GT(run.size(), 100U);
  ASSERT_FALSE(map.empty());
  const Pose T_truth_map = truth_at("one", map.front().stamp_ns) * map.front().pose.inverse();
  for (const StampedPose& pose : run) {
    const Pose truth = truth_at("two", pose.stamp_ns);
    ASSERT_LT(((T_truth_map * pose.pose).translation - truth.translation).norm(), 0.3)
        << pose.stamp_ns;
  }
  // The odometry is left alone.
  const ProcessResult plain =
      surefoot({"run", "two", "--start", "30", "-o", "plain", "--no-report", "--no-picture", "-q"});
  ASSERT_EQ(plain.exit_code, 0) << plain;
  EXPECT_EQ(file_content(path("on/trajectory.tum")), file_content(path("plain/trajectory.tum")));
  // Where a map is expected, a run without one is told how it is had.
  const std::string how = "surefoot map --config plain/run.yaml -o FOLDER";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"merge", "one-map", "plain", "-o", "both"},
        {"export", "plain", "--ply", "plain.ply"},
        {"run", "two", "--localize", "plain", "-o", "none"}}) {
    const ProcessResult told = surefoot(arguments);
    EXPECT_EQ(told.exit_code, 2) << told;
    EXPECT_NE(told.errors.find(how), std::string::npos) << told;
  }
}

TEST_F(MergeCommand, TheMapIsWrittenOverOnlyWhenAsked) {
  map_part("one", "0", "150", "own");
  const std::string before = file_content(path("own/map.surefoot"));
  const ProcessResult refused = continue_map("own", "own");
  EXPECT_EQ(refused.exit_code, 2) << refused;
  EXPECT_NE(refused.errors.find("--overwrite"), std::string::npos) << refused;
  EXPECT_EQ(file_content(path("own/map.surefoot")), before);
  const ProcessResult result = continue_map("own", "own", true);
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_GT(fs::file_size(path("own/map.surefoot")), before.size());
}

/// Two stretches of one street: four places agree on a joint that is 60 m off.
TEST_F(MergeCommand, HousesThatLookAlikeDoNotJoinMaps) {
  ASSERT_TRUE(simulate("street", "3113", "3113", "150", "2.6", "street"));
  ASSERT_TRUE(simulate("street", "3113", "777", "550", "2.6", "street-2"));
  map_part("street", "0", "150", "street-map");
  const std::string before = file_content(path("street-map/map.surefoot"));
  const ProcessResult result =
      surefoot({"run", "street-2", "--start", "350", "--map", "street-map", "-o", "street-map",
                "--overwrite", "--no-report", "--no-picture", "--no-map"});
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("the map is not continued: "), std::string::npos) << result;
  EXPECT_EQ(file_content(path("street-map/map.surefoot")), before) << "the map is lost";
  EXPECT_NE(file_content(path("street-map/run.yaml")).find("is not continued"), std::string::npos);
  const ProcessResult merged =
      surefoot({"merge", "street-map", "street-map/map_apart.surefoot", "-o", "none"});
  EXPECT_EQ(merged.exit_code, 1) << merged;
  EXPECT_FALSE(fs::exists(path("none/map.surefoot")));
  EXPECT_GT(lines_of(path("none/loops.csv")), 10U);
  // Nothing to write without it, either; with a map that can be joined there is.
  EXPECT_EQ(surefoot({"merge", "street-map", "one-map", "-o", "none-2", "--leave-out"}).exit_code,
            1);
  EXPECT_FALSE(fs::exists(path("none-2/map.surefoot")));
  const ProcessResult two =
      surefoot({"merge", "one-map", "street-map", "two-map", "-o", "two", "--leave-out"});
  EXPECT_EQ(two.exit_code, 1) << two;
  EXPECT_NE(two.output.find("street-map: not joined"), std::string::npos) << two;
  ASSERT_EQ(surefoot({"merge", "one-map", "two-map", "-o", "two-alone"}).exit_code, 0);
  EXPECT_EQ(file_content(path("two/map.surefoot")), file_content(path("two-alone/map.surefoot")));
}

}  // namespace
}  // namespace surefoot::test
