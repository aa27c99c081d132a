// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot eval: every table, and what it does with trajectories that cannot be compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/trajectory_files.hpp"
#include "process.hpp"

namespace surefoot::test {
namespace {

constexpr int kPoses = 60;

/// A curve of 60 poses at 10 Hz that winds in all three axes.
Trajectory winding_walk() {
  Trajectory walk;
  for (int i = 0; i < kPoses; ++i) {
    const double t = 0.1 * i;
    const Eigen::Vector3d place(t, std::sin(t), 0.3 * std::cos(0.7 * t));
    const Eigen::AngleAxisd turn(0.3 * t, Eigen::Vector3d(0.1, -0.2, 1.0).normalized());
    walk.push_back({i * 100'000'000LL, {Eigen::Quaterniond(turn), place}});
  }
  return walk;
}

/// Every other pose of the walk 0.1 m to the left, the others 0.1 m to the right, as z is up.
Trajectory zigzag(Trajectory walk) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    walk[i].pose.translation.y() += i % 2 == 0 ? 0.1 : -0.1;
  }
  return walk;
}

class Eval : public testing::Test {
 protected:
  Eval() {
    io::write_tum(scratch_.path() / "truth.tum", winding_walk());
    io::write_tum(scratch_.path() / "zigzag.tum", zigzag(winding_walk()));
  }
  [[nodiscard]] ProcessResult eval(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "eval");
    return run_surefoot(arguments, scratch_.path());
  }
  [[nodiscard]] nlohmann::json eval_json(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const ProcessResult result = eval(arguments);
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_TRUE(result.errors.empty()) << result;
    const nlohmann::json json = nlohmann::json::parse(result.output, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << result;
    return json;
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
    const ProcessResult result = eval(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_TRUE(result.output.empty()) << result;
    EXPECT_NE(result.errors.find(named), std::string::npos) << "not named: " << named << "\n"
                                                            << result;
  }
  ScratchFolder scratch_;
};

TEST_F(Eval, TheReferenceItselfHasNoError) {
  const nlohmann::json json = eval_json({"truth.tum", "truth.tum"});
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["estimate"], "truth");
  EXPECT_EQ(json[0]["pairs"], kPoses);
  EXPECT_EQ(json[0]["coverage"], 1.0);
  EXPECT_GE(json[0]["errors"].size(), 8U);
  for (const auto& [name, error] : json[0]["errors"].items()) {
    EXPECT_LT(error["max"].get<double>(), 1e-9) << name;
  }
  EXPECT_LT(json[0]["end_drift"]["total_m"].get<double>(), 1e-9);
}

TEST_F(Eval, ErrorsAreThoseThatWerePutIn) {
  const nlohmann::json json = eval_json({"truth.tum", "zigzag.tum", "--align", "none"});
  const nlohmann::json& error = json[0]["errors"]["ape_translation"];
  EXPECT_EQ(error["unit"], "m");
  EXPECT_NEAR(error["rmse"].get<double>(), 0.1, 1e-8);
  EXPECT_NEAR(error["std"].get<double>(), 0.0, 1e-8);
  EXPECT_NEAR(json[0]["errors"]["ape_vertical"]["max"].get<double>(), 0.0, 1e-8);
  EXPECT_NEAR(json[0]["errors"]["rpe_translation"]["rmse"].get<double>(), 0.2, 1e-8);
}

/// As EuRoC's and other programs' tables are: nanoseconds, commas.
TEST_F(Eval, AnEstimateMayBeATableOfAnotherForm) {
  std::string table = "#timestamp, p_x, p_y, p_z, q_w, q_x, q_y, q_z\n";
  std::string positions;
  for (const StampedPose& pose : zigzag(winding_walk())) {
    const Eigen::Vector3d& t = pose.pose.translation;
    const Eigen::Quaterniond& q = pose.pose.rotation;
    std::string stamp = std::to_string(1'600'000'000'000'000'000 + pose.stamp_ns);
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
      stamp += "," + std::to_string(value);
    }
    table += stamp + "\n";
    positions += std::to_string(1e-9 * static_cast<double>(pose.stamp_ns)) + " " +
                 std::to_string(t.x()) + " " + std::to_string(t.y()) + " " + std::to_string(t.z()) +
                 "\n";
  }
  write_content(scratch_.path() / "table.csv", table);
  write_content(scratch_.path() / "positions.txt", positions);
  Trajectory truth = winding_walk();
  for (StampedPose& pose : truth) pose.stamp_ns += 1'600'000'000'000'000'000;
  io::write_tum(scratch_.path() / "late.tum", truth);
  const nlohmann::json json = eval_json({"late.tum", "table.csv", "--align", "none"});
  EXPECT_EQ(json[0]["pairs"], kPoses);
  EXPECT_NEAR(json[0]["errors"]["ape_translation"]["rmse"].get<double>(), 0.1, 1e-5);
  expect_refused({"truth.tum", "positions.txt"}, "has no rotations, which the reference has");
  expect_refused({"late.tum", "table.csv", "--format", "tum"}, "expected 8 (t x y z");
}

TEST_F(Eval, EveryPosesErrorsAreATable) {
  const std::vector<std::string> arguments = {"truth.tum", "truth.tum",     "zigzag.tum", "--align",
                                              "none",      "--pose-errors", "poses.csv"};
  ASSERT_EQ(eval(arguments).exit_code, 0);
  const std::string table = file_content(scratch_.path() / "poses.csv");
  EXPECT_TRUE(table.starts_with("estimate,stamp,translation_m,horizontal_m,vertical_m,"));
  EXPECT_EQ(lines_of(scratch_.path() / "poses.csv"), 1U + 2U * kPoses);
  const std::string second = "\nzigzag,0.100000000,0.100000,0.100000,0.000000,0.000000,";
  EXPECT_NE(table.find(second), std::string::npos) << table.substr(table.find("\nzigzag"), 200);
  EXPECT_EQ(eval(arguments).exit_code, 0) << "its own";
  write_content(scratch_.path() / "poses.csv", "mine");
  expect_refused(arguments, "is no table of poses' errors");
  EXPECT_EQ(file_content(scratch_.path() / "poses.csv"), "mine");
  expect_refused({"truth.tum", "zigzag.tum", "--pose-errors", "poses.txt"}, "expected .csv");
  std::filesystem::create_symlink("zigzag.tum", scratch_.path() / "link.csv");
  expect_refused({"truth.tum", "truth.tum", "--pose-errors", "link.csv", "--overwrite"},
                 "link.csv: is there already and is no file; choose another name");
}

TEST_F(Eval, WhatIsReadIsNotWrittenOver) {
  const auto walk = scratch_.path() / "walk.csv";
  std::filesystem::copy_file(scratch_.path() / "zigzag.tum", walk);
  std::filesystem::create_symlink(walk, scratch_.path() / "link.tum");
  const std::string before = file_content(walk);
  for (const std::vector<std::string>& read : {std::vector<std::string>{"truth.tum", "walk.csv"},
                                               {"walk.csv", "truth.tum"},
                                               {"truth.tum", "link.tum"}}) {
    std::vector<std::string> arguments = read;
    arguments.insert(arguments.end(), {"--pose-errors", "./walk.csv", "--overwrite"});
    expect_refused(arguments, "walk.csv: is what is evaluated; choose another name");
  }
  EXPECT_EQ(file_content(walk), before);
}

TEST_F(Eval, WhatCountsForNothingIsSaid) {
  for (const std::string flag : {"--truth-topic", "--topic"}) {
    const ProcessResult result = eval({"truth.tum", "truth.tum", flag, "/gt"});
    EXPECT_NE(result.errors.find(flag + " counts for nothing here"), std::string::npos) << result;
  }
  expect_refused({"-", "truth.tum"}, "what comes through a pipe is /dev/stdin here");
}

TEST_F(Eval, TextHasABlockForEachEstimate) {
  const ProcessResult result = eval({"truth.tum", "truth.tum", "zigzag.tum"});
  EXPECT_EQ(result.exit_code, 0) << result;
  for (const char* name : {"truth", "zigzag"}) {
    const std::string line = std::string(name) + ": 60 of 60 poses paired, 100.0 % of the";
    EXPECT_NE(result.output.find(line), std::string::npos) << result;
  }
}

TEST_F(Eval, CsvHasALineForEachError) {
  const ProcessResult result = eval({"truth.tum", "truth.tum", "zigzag.tum", "--csv"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_TRUE(result.output.starts_with("estimate,error,unit,count,max,mean,median,")) << result;
  const auto lines = std::count(result.output.begin(), result.output.end(), '\n');
  const auto errors = eval_json({"truth.tum", "truth.tum"})[0]["errors"].size();
  EXPECT_EQ(static_cast<std::size_t>(lines), 1 + 2 * errors) << result;
  EXPECT_NE(result.output.find("\nzigzag,ape_translation,m,60,"), std::string::npos) << result;
}

TEST_F(Eval, LatexPrintsTheBestBold) {
  const ProcessResult result =
      eval({"truth.tum", "truth.tum", "zigzag.tum", "--latex", "--align", "none"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("\n\\begin{tabular}{lrrrr}\n\\toprule"), std::string::npos)
      << result;
  EXPECT_NE(result.output.find("\ntruth & \\textbf{0.000}"), std::string::npos) << result;
  EXPECT_NE(result.output.find("\nzigzag & \\underline{0.100}"), std::string::npos) << result;
}

#ifdef SUREFOOT_HAS_PICTURES
TEST_F(Eval, FiguresAreDrawn) {
  const ProcessResult result = eval({"truth.tum", "zigzag.tum", "truth.tum", "--figure", "a.svg",
                                     "--figure", "a.png", "--figure", "a.pdf", "--align", "none"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(file_content(scratch_.path() / "a.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(file_content(scratch_.path() / "a.png").substr(1, 3), "PNG");
  EXPECT_TRUE(file_content(scratch_.path() / "a.pdf").starts_with("%PDF"));
  expect_refused({"truth.tum", "truth.tum", "--align", "none", "--figure", "a.gif"},
                 ".png, .svg or .pdf");
}

/// An earlier figure may go; what is somebody else's may not, whatever it is called.
TEST_F(Eval, AFigureReplacesNothingButAPicture) {
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    const std::vector<std::string> arguments = {"truth.tum", "zigzag.tum", "--figure", name};
    EXPECT_EQ(eval(arguments).exit_code, 0);
    EXPECT_EQ(eval(arguments).exit_code, 0) << "again";
    const std::string other = file_content(scratch_.path() / name).substr(0, 300) + "mine";
    write_content(scratch_.path() / name, other);
    expect_refused(arguments, "is no earlier picture of this kind");
    EXPECT_EQ(file_content(scratch_.path() / name), other);
  }
  EXPECT_EQ(eval({"truth.tum", "zigzag.tum", "--figure", "a.svg", "--overwrite"}).exit_code, 0);
  std::filesystem::create_symlink("/dev/null", scratch_.path() / "null.png");
  expect_refused({"truth.tum", "zigzag.tum", "--figure", "null.png", "--overwrite"}, "is no file");
}
#endif

TEST_F(Eval, KittiFilesAreFoundOutAndPairedByRow) {
  io::write_kitti_poses(scratch_.path() / "truth.txt", winding_walk());
  io::write_kitti_poses(scratch_.path() / "zigzag.txt", zigzag(winding_walk()));
  const nlohmann::json json = eval_json({"truth.txt", "zigzag.txt", "--align", "none"});
  EXPECT_EQ(json[0]["pairs"], kPoses);
  EXPECT_NEAR(json[0]["errors"]["ape_translation"]["rmse"].get<double>(), 0.1, 1e-8);
  const ProcessResult idle = eval({"truth.txt", "zigzag.txt", "--offset", "5", "--max-diff", "2",
                                   "--pair", "interpolate", "--max-gap", "3"});
  for (const char* flag : {"--offset", "--max-diff", "--pair", "--max-gap"}) {
    EXPECT_NE(idle.errors.find(std::string(flag) + " counts for nothing here"), std::string::npos)
        << idle;
  }
}

TEST_F(Eval, WhatCountsForNothingBesideTheOthersIsTold) {
  const auto told = [&](std::vector<std::string> given, const std::string& flag) {
    given.insert(given.begin(), {"truth.tum", "zigzag.tum"});
    const ProcessResult result = eval(given);
    EXPECT_EQ(result.exit_code, 0) << result;
    return result.errors.find(flag + " counts for nothing here") != std::string::npos;
  };
  EXPECT_TRUE(told({"--max-gap", "3"}, "--max-gap"));
  EXPECT_FALSE(told({"--max-gap", "3", "--pair", "interpolate"}, "--max-gap"));
  EXPECT_TRUE(told({"--max-diff", "3", "--pair", "interpolate"}, "--max-diff"));
  EXPECT_FALSE(told({"--max-diff", "3"}, "--max-diff"));
  EXPECT_TRUE(told({"--delta-tolerance", "0.5"}, "--delta-tolerance"));
  EXPECT_FALSE(told({"--delta-tolerance", "0.5", "--all-pairs"}, "--delta-tolerance"));
  EXPECT_TRUE(told({"--align", "none", "--align-poses", "5"}, "--align-poses"));
  EXPECT_FALSE(told({"--align-poses", "5"}, "--align-poses"));
}

TEST_F(Eval, BadInputIsRefused) {
  write_content(scratch_.path() / "words.tum", "once upon a time\n");
  write_content(scratch_.path() / "empty.tum", "");
  write_content(scratch_.path() / "later.tum",
                io::format_tum({{1'000'000'000'000, Pose()}, {1'000'100'000'000, Pose()}}));
  expect_refused({"none.tum", "truth.tum"}, "none.tum");
  expect_refused({"words.tum", "truth.tum"}, "words.tum: line 1");
  expect_refused({"empty.tum", "truth.tum"}, "");
  expect_refused({"truth.tum", "none.tum"}, "none.tum");
  expect_refused({"truth.tum", "words.tum", "--json"}, "words.tum: line 1");
  expect_refused({"truth.tum", "later.tum"}, "later");
  expect_refused({"truth.tum", "."}, "is a folder without a trajectory.tum");
  expect_refused({"truth.tum"}, "estimates");
  expect_refused({"truth.tum", "truth.tum", "--json", "--csv"}, "--csv");
  expect_refused({"truth.tum", "truth.tum", "--align", "upwards"}, "upwards");
  expect_refused({"truth.tum", "truth.tum", "--delta", "-1"}, "-1");
}

/// What the table does not have is told.
TEST_F(Eval, AStretchLongerThanTheWayIsTold) {
  const ProcessResult result =
      eval({"truth.tum", "zigzag.tum", "--delta", "5000", "--delta-unit", "m"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.errors.find("zigzag: has no stretch of 5000 m"), std::string::npos) << result;
  EXPECT_EQ(result.output.find("rpe_"), std::string::npos) << result;
  EXPECT_TRUE(eval({"truth.tum", "zigzag.tum"}).errors.empty());
  const ProcessResult segments = eval({"truth.tum", "zigzag.tum", "--segments", "5,5000"});
  EXPECT_NE(segments.errors.find("zigzag: has no segment of 5000 m"), std::string::npos)
      << segments;
  EXPECT_EQ(segments.errors.find("segment of 5 m"), std::string::npos) << segments;
}

TEST_F(Eval, HelpHasTheDefaultsOfItsCommand) {
  const std::string eval_help = eval({"--help"}).output;
  const std::string compare_help = run_surefoot({"compare", "--help"}, scratch_.path()).output;
  for (const char* text : {"s or deg (default: frames)", "(default: --no-all-pairs)",
                           "(default: --pairs-from-estimate)", "(default: nearest)"}) {
    EXPECT_NE(eval_help.find(text), std::string::npos) << text << eval_help;
  }
  for (const char* text : {"s or deg (default: m)", "(default: --all-pairs)", "(default: se3)"}) {
    EXPECT_NE(compare_help.find(text), std::string::npos) << text << compare_help;
  }
}

TEST_F(Eval, StampsThatComeTwiceAreTold) {
  Trajectory twice = winding_walk();
  twice.insert(twice.begin() + 5, twice[4]);
  io::write_tum(scratch_.path() / "twice.tum", twice);
  const ProcessResult result = eval({"truth.tum", "twice.tum"});
  EXPECT_NE(result.errors.find("twice: 1 pose has the stamp of the one before"), std::string::npos)
      << result;
}

// One estimate that cannot be used does not take the others' figures away.
TEST_F(Eval, ABadEstimateAmongGoodOnesIsLeftOut) {
  write_content(scratch_.path() / "words.tum", "once upon a time\n");
  const ProcessResult result = eval({"truth.tum", "words.tum", "zigzag.tum", "--json"});
  EXPECT_EQ(result.exit_code, 1) << result;
  EXPECT_NE(result.errors.find("words.tum: line 1"), std::string::npos) << result;
  const nlohmann::json json = nlohmann::json::parse(result.output, nullptr, false);
  ASSERT_EQ(json.size(), 1U) << result;
  EXPECT_EQ(json[0]["estimate"], "zigzag");
}

// A killed run leaves what it had written.
TEST_F(Eval, ARunThatDidNotComeToItsEndIsSaid) {
  const std::filesystem::path run = scratch_.path() / "killed";
  std::filesystem::create_directory(run);
  io::write_tum(run / "trajectory.tum", zigzag(winding_walk()));
  write_content(run / "scans.csv", "scan\n");
  for (const char* estimate : {"killed", "killed/trajectory.tum"}) {
    const ProcessResult result = eval({"truth.tum", estimate});
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.errors.find("no run.yaml"), std::string::npos) << result;
  }
  write_content(run / "run.yaml", "surefoot: 0.1.0\nresult:\n  interrupted: true\n");
  EXPECT_NE(eval({"truth.tum", "killed"}).errors.find("interrupted"), std::string::npos);
  write_content(run / "run.yaml", "surefoot: 0.1.0\nresult:\n  interrupted: false\n");
  EXPECT_TRUE(eval({"truth.tum", "killed"}).errors.empty());
}

}  // namespace
}  // namespace surefoot::test
