// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Runs on simulated walks that are hard to follow.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

/// A scene's recording `in`, and what is run of it into `out`.
ProcessResult run_of_simulated(const ScratchFolder& scratch, std::vector<std::string> scene,
                               std::vector<std::string> part) {
  scene.insert(scene.begin(), "simulate");
  scene.insert(scene.end(), {"--no-footprint", "-o", "in"});
  const ProcessResult made = run_surefoot(scene, scratch.path());
  EXPECT_EQ(made.exit_code, 0) << made;
  part.insert(part.begin(), {"run", "in", "-o", "out", "--no-report", "--no-picture"});
  ProcessResult run = run_surefoot(part, scratch.path());
  EXPECT_EQ(run.exit_code, 0) << run;
  return run;
}

// Of this runner the end of many a scan ran away by up to 14 degrees, and the scan after it, begun
// there, was lost.
TEST(Simulation, ARunnerWhoseScansEndUnlikeTheyBeginIsFollowed) {
  const ScratchFolder scratch;
  const ProcessResult run = run_of_simulated(
      scratch,
      {"forest", "--robot", "run", "--layout", "14026", "--seed", "14026", "--scans", "200"},
      {"--start", "40", "--no-map"});
  EXPECT_EQ(run.output.find("lost"), std::string::npos) << run;
}

// Where nothing is flat, and who stands begins to turn by 90 deg/s within two scans: a registration
// from the last velocity alone followed by a quarter of it, and called that ok.
TEST(Simulation, WhoLooksAroundOnAGrownHilltopIsFollowed) {
  const ScratchFolder scratch;
  const ProcessResult run = run_of_simulated(
      scratch,
      {"hilltop", "--robot", "trot", "--layout", "7903", "--seed", "7903", "--scans", "275"},
      {"--start", "230", "--count", "45"});
  EXPECT_EQ(run.output.find("lost"), std::string::npos) << run;
  const ProcessResult eval =
      run_surefoot({"eval", "in/gt.tum", "out", "--pair", "interpolate", "--csv"}, scratch.path());
  const std::size_t row = eval.output.find("ape_rotation_angle,deg,45,");
  ASSERT_NE(row, std::string::npos) << eval;
  double greatest = 0.0, mean = 0.0, median = 0.0, least = 0.0;
  ASSERT_EQ(std::sscanf(eval.output.c_str() + row, "ape_rotation_angle,deg,45,%lf,%lf,%lf,%lf",
                        &greatest, &mean, &median, &least),
            4);
  EXPECT_LT(greatest - least, 4.0);  // [deg] 2.1; it was 9.4, of the 31 scans that were not lost
}

/// The scans.csv of a trot up a stairwell.
std::string scans_up_stairs(const std::string& seed, const ScratchFolder& scratch) {
  const ProcessResult made =
      run_surefoot({"simulate", "stairwell", "--robot", "trot", "--scans", "310", "--seed", seed,
                    "--no-footprint", "-q", "-o", seed},
                   scratch.path());
  EXPECT_EQ(made.exit_code, 0) << made;
  const ProcessResult run =
      run_surefoot({"run", seed, "-q", "--no-map", "--overwrite", "-o", "out"}, scratch.path());
  EXPECT_EQ(run.exit_code, 0) << run;
  return file_content(scratch.path() / "out/scans.csv");
}

/// RMSE of what lies in out, after alignment [m].
double ape_of_run(const std::string& recording, const ScratchFolder& scratch) {
  const ProcessResult judged = run_surefoot(
      {"eval", recording + "/gt.tum", "out/trajectory.tum", "--pair", "interpolate", "--json"},
      scratch.path());
  EXPECT_EQ(judged.exit_code, 0) << judged;
  if (judged.exit_code != 0) return std::numeric_limits<double>::infinity();
  const auto errors = nlohmann::json::parse(judged.output).at(0).at("errors");
  return errors.at("ape_translation").at("rmse");
}

// A trot up a flight of stairs, which the body meets with a pitch of 30 deg within half a second:
// without attempts from other motions it is lost for 12 and 29 scans, and the second 0.14 m off.
TEST(Simulation, ATrotUpStairsIsFollowed) {
  const ScratchFolder scratch;
  for (const char* const seed : {"627", "630"}) {
    EXPECT_EQ(scans_up_stairs(seed, scratch).find(",lost,"), std::string::npos) << seed;
    EXPECT_LT(ape_of_run(seed, scratch), 0.06) << seed;  // measured: below 0.035
  }
}

// Where nothing is flat all fits nearly as well where it stood. Of 60 such walks one was taken to
// stand on (12110, 0.5 m off), and none of 220 fares worse without turns by a looser model.
TEST(Simulation, WhoBeginsToWalkOnAHilltopIsFollowed) {
  const ScratchFolder scratch;
  const std::vector<std::string> hilltop = {
      "simulate", "hilltop",  "--robot", "trot", "--scans",        "50", "--seed",
      "12202",    "--layout", "12202",   "-q",   "--no-footprint", "-o", "hilltop"};
  const ProcessResult made = run_surefoot(hilltop, scratch.path());
  ASSERT_EQ(made.exit_code, 0) << made;
  const ProcessResult run =
      run_surefoot({"run", "hilltop", "-q", "--no-map", "-o", "out"}, scratch.path());
  ASSERT_EQ(run.exit_code, 0) << run;
  // How late the motion is seen hangs on the last digits, which machines do not share. By
  // parameters that differ by a thousandth: 0.041 to 0.077, to 0.201 where the last scan is never
  // forgotten.
  EXPECT_LT(ape_of_run("hilltop", scratch), 0.1);
}

// Who lost himself on a stair and climbed on is where the map does not know; the storey below looks
// like it, and is known. Once he may be as high as that one looks, the map begins anew.
TEST(Simulation, WhoClimbsDoesNotFindHimselfAStoreyBelow) {
  const ScratchFolder scratch;
  const std::string scans = scans_up_stairs("9147", scratch);
  int lost = 0;
  for (auto at = scans.find(",lost,"); at != std::string::npos; at = scans.find(",lost,", at + 1)) {
    ++lost;
  }
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, 40);  // measured: 19; 61 where the map is looked in for 6 s
  EXPECT_EQ(scans.find("found itself again"), std::string::npos);
}

// People cross the plaza: the map does not keep their trails, and keeps the plaza.
TEST(Simulation, TheMapForgetsWhoWalkedAway) {
  const ScratchFolder scratch;
  const ProcessResult made = run_surefoot({"simulate", "plaza", "--robot", "trot", "--scans", "80",
                                           "--seed", "3", "--no-footprint", "-q", "-o", "plaza"},
                                          scratch.path());
  ASSERT_EQ(made.exit_code, 0) << made;
  const auto map_size = [&scratch](const std::string& gone_after) {
    const ProcessResult run =
        run_surefoot({"run", "plaza", "-q", "--set", "knots.gone_after=" + gone_after, "-o", "out"},
                     scratch.path());
    EXPECT_EQ(run.exit_code, 0) << run;
    const std::string map = file_content(scratch.path() / "out/map.ply");
    const std::string vertices = "element vertex ";
    return std::stod(map.substr(map.find(vertices) + vertices.size(), 20));
  };
  const double forgetful = map_size("2") / map_size("0");
  EXPECT_LT(forgetful, 0.97);  // measured: 0.938
  EXPECT_GT(forgetful, 0.90);
}

}  // namespace
}  // namespace surefoot::test
