// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate, and runs on what it makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

void simulate(const std::string& output, const ScratchFolder& scratch) {
  const ProcessResult result = run_surefoot(
      {"simulate", "parking", "--scans", "15", "--no-footprint", "-o", output}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
}

TEST(Simulation, CommandsHaveHelp) {
  const ScratchFolder scratch;
  for (const char* command : {"simulate", "suite"}) {
    const ProcessResult result = run_surefoot({command, "--help"}, scratch.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.output.find("Options:"), std::string::npos) << result;
    EXPECT_NE(result.output.find("--output"), std::string::npos) << result;
    EXPECT_TRUE(result.errors.empty()) << result;
  }
  const ProcessResult scenes = run_surefoot({"simulate", "--list"}, scratch.path());
  EXPECT_EQ(scenes.exit_code, 0) << scenes;
  EXPECT_NE(scenes.output.find("parking"), std::string::npos) << scenes;
}

TEST(Simulation, SameSeedSameBytes) {
  const ScratchFolder scratch;
  simulate("a", scratch);
  simulate("b", scratch);
  EXPECT_GT(io::read_tum(scratch.path() / "a" / "gt.tum").size(), 15U);
  for (const char* name : {"gt.tum", "times.txt", "scene.json", "000000.pcd", "000014.pcd"}) {
    const std::string content = file_content(scratch.path() / "a" / name);
    EXPECT_FALSE(content.empty()) << name;
    EXPECT_TRUE(content == file_content(scratch.path() / "b" / name)) << name;
  }
}

TEST(Simulation, RainDustAndPeopleAreMadeAndToldInTheSceneFile) {
  const ScratchFolder scratch;
  const ProcessResult result =
      run_surefoot({"simulate", "corridor", "--scans", "3", "--no-footprint", "--rain", "0.05",
                    "--dust", "0.1", "--people", "2", "-o", "wet"},
                   scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const auto scene = nlohmann::json::parse(file_content(scratch.path() / "wet" / "scene.json"));
  EXPECT_EQ(scene.at("rain"), 0.05);
  EXPECT_EQ(scene.at("dust"), 0.1);
  EXPECT_EQ(scene.at("people"), 2);
}

TEST(Simulation, AnotherWayThroughASceneIsWalked) {
  const ScratchFolder scratch;
  write_content(scratch.path() / "way.txt", "20 5 0 # begins here\n30 5 0\n30 15 0\n20 15 0\n");
  std::vector<std::string> words{"simulate", "playground",     "--route", "way.txt", "--scans",
                                 "3",        "--no-footprint", "-o",      "walk"};
  ASSERT_EQ(run_surefoot(words, scratch.path()).exit_code, 0);
  const auto truth = io::read_tum(scratch.path() / "walk" / "gt.tum");
  ASSERT_FALSE(truth.empty());
  const Eigen::Vector3d begins = truth.front().pose.translation;
  EXPECT_LT((begins.head<2>() - Eigen::Vector2d(20.0, 5.0)).norm(), 2.0) << begins.transpose();
  words[3] = "none.txt";
  words.emplace_back("--overwrite");
  const ProcessResult missing = run_surefoot(words, scratch.path());
  EXPECT_EQ(missing.exit_code, 2) << missing;
  EXPECT_NE(missing.errors.find("none.txt"), std::string::npos) << missing;
}

TEST(Simulation, AMeshsNameMayHoldAnyByte) {
  const ScratchFolder scratch;
  const std::string name = "m\xFC.obj";
  write_content(scratch.path() / name,
                "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3\nf 1 3 4\n"
                "v 8 -50 0\nv 8 50 0\nv 8 50 9\nf 5 6 7\n");
  write_content(scratch.path() / "way.txt", "0 0 0\n6 0 0\n6 3 0\n");
  const ProcessResult result = run_surefoot(
      {"simulate", name, "--route", "way.txt", "--scans", "1", "--no-footprint", "-o", "walk"},
      scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_TRUE(fs::exists(scratch.path() / "walk" / "scene.json"));
}

TEST(Simulation, DrawsAnAnimation) {
  const ScratchFolder scratch;
  const ProcessResult result =
      run_surefoot({"simulate", "corridor", "--animation", "walk.png"}, scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  const std::string content = file_content(scratch.path() / "walk.png");
  EXPECT_TRUE(content.starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(content.substr(37, 4), "acTL");  // after the signature and IHDR
  EXPECT_LT(content.size(), 3'000'000U);
  const ProcessResult gif =
      run_surefoot({"simulate", "corridor", "--animation", "walk.gif"}, scratch.path());
  EXPECT_EQ(gif.exit_code, 2) << gif;
  EXPECT_NE(gif.errors.find(".png"), std::string::npos) << gif;
}

TEST(Simulation, BagsHoldWhatThePcdFilesHold) {
  const ScratchFolder scratch;
  const ProcessResult result = run_surefoot(
      {"simulate", "parking", "--scans", "2", "--format", "pcd,mcap,rosbag2", "-o", "out"},
      scratch.path());
  ASSERT_EQ(result.exit_code, 0) << result;
  for (const char* bag : {"out/recording.mcap", "out/rosbag2"}) {
    fs::remove_all(scratch.path() / "back");
    const ProcessResult back = run_surefoot({"convert", bag, "back"}, scratch.path());
    ASSERT_EQ(back.exit_code, 0) << back;
    for (const char* name : {"000000.pcd", "000001.pcd", "times.txt"}) {
      EXPECT_EQ(file_content(scratch.path() / "back" / name),
                file_content(scratch.path() / "out" / name))
          << bag << " " << name;
    }
  }
}

/// As a folder and by its file or bag, beside which the truth lies.
TEST(Simulation, EveryFormatAloneIsOpenedWithItsTruth) {
  for (const char* format : {"pcd", "pcap", "mcap", "rosbag2"}) {
    const ScratchFolder scratch;
    const ProcessResult made = run_surefoot(
        {"simulate", "campus", "--scans", "12", "--format", format, "--no-footprint", "-o", "out"},
        scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made;
    for (const char* input :
         {"out", "out/recording.pcap", "out/recording.mcap", "out/rosbag2", "out/rosbag2/"}) {
      if (!fs::exists(scratch.path() / input)) continue;
      const ProcessResult run =
          run_surefoot({"run", input, "-o", "run", "--no-picture", "--overwrite"}, scratch.path());
      EXPECT_EQ(run.exit_code, 0) << format << ' ' << input << run;
      const std::string page = scratch.path() / "run/report.html";
      if (!fs::exists(page)) continue;  // built without the page
      const std::string text = file_content(page);
      EXPECT_NE(text.find("\"ape_translation\""), std::string::npos) << format << ' ' << input;
    }
    EXPECT_EQ(run_surefoot({"info", "out"}, scratch.path()).exit_code, 0) << format;
  }
}

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

TEST(Simulation, FormatsThatItCannotWriteAreNamed) {
  const ScratchFolder scratch;
  const ProcessResult result = run_surefoot(
      {"simulate", "parking", "--scans", "1", "--format", "las", "-o", "out"}, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("pcap"), std::string::npos) << result;
  EXPECT_FALSE(fs::exists(scratch.path() / "out"));
}

TEST(Simulation, NonsenseIsRefusedByTheNameOfItsOption) {
  const ScratchFolder scratch;
  const std::vector<std::vector<std::string>> nonsense = {{"--duration", "nan"},
                                                          {"--duration", "inf"},
                                                          {"--duration", "1e30"},
                                                          {"--duration", "-1"},
                                                          {"--duration", "0"},
                                                          {"--speed", "nan"},
                                                          {"--speed", "0.2"},
                                                          {"--speed", "5.1"},
                                                          {"--gait-scale", "nan"},
                                                          {"--gait-scale", "-1"},
                                                          {"--gait-scale", "inf"},
                                                          {"--mount", "nan", "0", "0"},
                                                          {"--mount", "0", "0"},
                                                          {"--mount", "1e30", "0", "0"},
                                                          {"--tilt", "0", "inf", "0"},
                                                          {"--tilt", "0", "x", "0"},
                                                          {"--scans", "0"},
                                                          {"--scans", "-3"},
                                                          {"--scans", "1000000000"},
                                                          {"--seed", "-1"},
                                                          {"--lidar", "hdl64"},
                                                          {"--robot", "cat"},
                                                          {"--format", "pcd,xyz"}};
  for (const std::vector<std::string>& option : nonsense) {
    std::vector<std::string> arguments = {"simulate", "corridor", "-o", "out"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const ProcessResult result = run_surefoot(arguments, scratch.path());
    EXPECT_EQ(result.exit_code, 2) << option[0] << " " << option[1] << "\n" << result;
    EXPECT_NE(result.errors.find(option[0]), std::string::npos) << result;
    EXPECT_FALSE(fs::exists(scratch.path() / "out")) << option[0] << " " << option[1];
  }
}

TEST(Simulation, WhatContradictsItselfIsRefusedByTheNameOfItsOption) {
  const ScratchFolder scratch;
  write_content(scratch.path() / "floor.obj",
                "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3\nf 1 3 4\n");
  const std::vector<std::vector<std::string>> nonsense = {
      {"--mount", "playground", "0,0,-5"},  // under the ground
      {"--speed", "playground", "3", "--robot", "still"},
      {"--layout", "floor.obj", "5"},
      {"--body", "playground", "--robot", "handheld"}};
  for (const std::vector<std::string>& one : nonsense) {
    std::vector<std::string> arguments = {"simulate", one[1], "--scans", "1", "-o", "out", one[0]};
    arguments.insert(arguments.end(), one.begin() + 2, one.end());
    const ProcessResult result = run_surefoot(arguments, scratch.path());
    EXPECT_EQ(result.exit_code, 2) << one[0] << "\n" << result;
    EXPECT_NE(result.errors.find(one[0] + ":"), std::string::npos) << result;
    EXPECT_FALSE(fs::exists(scratch.path() / "out")) << one[0];
  }
  const ProcessResult floor =
      run_surefoot({"simulate", "floor.obj", "--scans", "1", "-o", "out"}, scratch.path());
  EXPECT_EQ(floor.exit_code, 0) << floor;
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
  // Measured: 0.04 to 0.06, and 0.12 where the last scan is never forgotten. How late the motion is
  // seen hangs on the last digits, which machines do not share.
  EXPECT_LT(ape_of_run("hilltop", scratch), 0.2);
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

TEST(Simulation, EveryRobotSensorMountAndSpeedMakesARecording) {
  const ScratchFolder scratch;
  const std::vector<std::vector<std::string>> choices = {
      {"--robot", "trot", "--speed", "0.3"},
      {"--robot", "run", "--speed", "3", "--gait-scale", "2"},
      {"--robot", "walk", "--lidar", "vlp32", "--body"},
      {"--robot", "stairs", "--lidar", "hesai-xt16", "--dual"},
      {"--robot", "wheel", "--gait-scale", "0", "--lidar", "os1-64"},
      {"--robot", "handheld", "--tilt", "0", "15", "0", "--mount", "0.2", "0.1", "0.3"},
      {"--robot", "still", "--format", "pcap,pcd", "--dual", "--true-points"}};
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const std::string folder(1, static_cast<char>('a' + i));
    std::vector<std::string> arguments = {"simulate", "corridor", "--scans", "12", "-o", folder};
    arguments.insert(arguments.end(), choices[i].begin(), choices[i].end());
    const ProcessResult made = run_surefoot(arguments, scratch.path());
    ASSERT_EQ(made.exit_code, 0) << made;
    const ProcessResult told = run_surefoot({"info", folder}, scratch.path());
    EXPECT_EQ(told.exit_code, 0) << told;
    EXPECT_NE(told.output.find("12"), std::string::npos) << told;
  }
}

#ifdef SUREFOOT_HAS_PICTURES
TEST(Simulation, APictureReplacesNothingButAPicture) {
  const ScratchFolder scratch;
  const auto draw = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"simulate", "corridor"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_surefoot(arguments, scratch.path());
  };
  EXPECT_EQ(draw({"--picture", "scene.png"}).exit_code, 0);
  EXPECT_EQ(draw({"--picture", "scene.png"}).exit_code, 0) << "its own";
  write_content(scratch.path() / "mine.png", "mine");
  for (const char* flag : {"--picture", "--animation"}) {
    const ProcessResult refused = draw({flag, "mine.png"});
    EXPECT_EQ(refused.exit_code, 2) << refused;
    EXPECT_NE(refused.errors.find("is no earlier picture of this kind"), std::string::npos)
        << refused;
    const ProcessResult lie = draw({flag, "scene.jpg"});
    EXPECT_EQ(lie.exit_code, 2) << lie;
    EXPECT_NE(lie.errors.find("scene.jpg: ends with '.jpg', expected .png"), std::string::npos)
        << lie;
  }
  EXPECT_EQ(file_content(scratch.path() / "mine.png"), "mine");
  write_pcd_recording(scratch.path() / "in", hall_scans(3));
  ASSERT_EQ(run_surefoot({"run", "in", "-o", "run", "-q"}, scratch.path()).exit_code, 0);
  const std::string picture = file_content(scratch.path() / "run/picture.png");
  EXPECT_EQ(draw({"--picture", "run/picture.png"}).exit_code, 2) << "a run's";
  const ProcessResult figure = run_surefoot(
      {"eval", "run/trajectory.tum", "run", "--figure", "run/picture.png"}, scratch.path());
  EXPECT_NE(figure.errors.find("is no earlier picture of this kind"), std::string::npos) << figure;
  EXPECT_TRUE(file_content(scratch.path() / "run/picture.png") == picture);
  EXPECT_EQ(draw({"--picture", "mine.png", "--overwrite"}).exit_code, 0);
}
#endif

}  // namespace
}  // namespace surefoot::test
