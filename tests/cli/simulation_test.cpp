// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate, and what it makes.
#include <gtest/gtest.h>

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
