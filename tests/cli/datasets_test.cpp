// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// --dataset: what public data sets ask for, on files made after their descriptions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/trajectory_files.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

/// A path that climbs and turns, ten poses a second.
Trajectory winding_path() {
  Trajectory path;
  for (int i = 0; i < 80; ++i) {
    const double t = 0.1 * i;
    Pose pose;
    pose.translation = {2.0 * std::cos(0.5 * t), 3.0 * std::sin(0.4 * t), 0.2 * t};
    pose.rotation = from_roll_pitch_yaw({0.3 * std::sin(t), 0.2 * std::cos(t), 0.7 * t});
    path.push_back({1'600'000'000'000'000'000 + std::int64_t{i} * 100'000'000, pose});
  }
  return path;
}

/// Positions of a point of the path's frame, with quaternions 0 0 0 0.
std::string positions(const Trajectory& path, const Eigen::Vector3d& point) {
  std::string text;
  for (const StampedPose& pose : path) {
    const Eigen::Vector3d at = pose.pose * point;
    char line[160];
    std::snprintf(line, sizeof(line), "%lld.%09lld %.9f %.9f %.9f 0 0 0 0\n",
                  static_cast<long long>(pose.stamp_ns / 1'000'000'000),
                  static_cast<long long>(pose.stamp_ns % 1'000'000'000), at.x(), at.y(), at.z());
    text += line;
  }
  return text;
}

double rmse(const nlohmann::json& json, const std::string& error) {
  return json[0]["errors"][error]["rmse"].get<double>();
}

nlohmann::json eval_json(std::vector<std::string> arguments, const ScratchFolder& scratch) {
  arguments.insert(arguments.begin(), {"eval", "--json"});
  const ProcessResult result = run_surefoot(arguments, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  return nlohmann::json::parse(result.output, nullptr, false);
}

TEST(Datasets, AreToldOfOneByOne) {
  const ScratchFolder scratch;
  const ProcessResult one = run_surefoot({"datasets", "leg-kilo"}, scratch.path());
  EXPECT_EQ(one.exit_code, 0) << one;
  for (const char* word : {"Go1", "/points_raw", "end of a sweep", "0.2000", "not tried"}) {
    EXPECT_NE(one.output.find(word), std::string::npos) << word << one;
  }
  EXPECT_GT(run_surefoot({"datasets"}, scratch.path()).output.size(), 5 * one.output.size());
  EXPECT_EQ(run_surefoot({"datasets", "nowhere"}, scratch.path()).exit_code, 2);
}

// The prism hangs half a metre from the LiDAR: without its place the error is as large.
TEST(Datasets, ViralsPrismIsComparedWhereItHangs) {
  const ScratchFolder scratch;
  const Trajectory path = winding_path();
  io::write_tum(scratch.path() / "run.tum", path);
  write_content(scratch.path() / "leica.txt", positions(path, {-0.243656, -0.012288, -0.328095}));
  const nlohmann::json right =
      eval_json({"leica.txt", "run.tum", "--dataset", "ntu-viral"}, scratch);
  EXPECT_LT(rmse(right, "ape_translation"), 1e-6) << right;
  EXPECT_FALSE(right.dump().find("ape_tilt") != std::string::npos) << right;
  const nlohmann::json wrong = eval_json({"leica.txt", "run.tum", "--dataset", "m2dgr"}, scratch);
  EXPECT_GT(rmse(wrong, "ape_translation"), 0.05) << wrong;
}

TEST(Datasets, ATableOfAnotherKindIsTakenByItsColumns) {
  const ScratchFolder scratch;
  const Trajectory path = winding_path();
  io::write_tum(scratch.path() / "run.tum", path);
  std::string csv = "#sec,nsec,x,y,z,qx,qy,qz,qw\n";
  for (const StampedPose& pose : path) {
    char line[200];
    const auto& q = pose.pose.rotation;
    const auto& t = pose.pose.translation;
    std::snprintf(line, sizeof(line), "%lld,%lld,%.9f,%.9f,%.9f,%.12f,%.12f,%.12f,%.12f\n",
                  static_cast<long long>(pose.stamp_ns / 1'000'000'000),
                  static_cast<long long>(pose.stamp_ns % 1'000'000'000), t.x(), t.y(), t.z(), q.x(),
                  q.y(), q.z(), q.w());
    csv += line;
  }
  write_content(scratch.path() / "registered_poses.csv", csv);
  EXPECT_LT(rmse(eval_json({"registered_poses.csv", "run.tum"}, scratch), "ape_translation"), 1e-6);
}

TEST(Datasets, FoldersOfMulRanAndNewerCollegeAreFound) {
  const ScratchFolder scratch;
  const std::vector<Scan> scans = hall_scans(3);
  std::filesystem::create_directories(scratch.path() / "DCC01" / "Ouster");
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::string name = std::to_string(1'561'000'444'390'857'630 + 100'000'000 * i) + ".bin";
    write_content(scratch.path() / "DCC01" / "Ouster" / name, kitti_bin(scans[i]));
  }
  const ProcessResult mulran =
      run_surefoot({"info", "DCC01", "--dataset", "mulran"}, scratch.path());
  EXPECT_EQ(mulran.exit_code, 0) << mulran;
  EXPECT_NE(mulran.output.find("1561000444.390857630"), std::string::npos) << mulran;

  write_pcd_recording(scratch.path() / "college" / "raw_format" / "ouster_scan", scans);
  const std::filesystem::path folder = scratch.path() / "college" / "raw_format" / "ouster_scan";
  std::filesystem::remove(folder / "times.txt");
  for (std::size_t i = 0; i < scans.size(); ++i) {
    std::filesystem::rename(
        folder / scan_name(i),
        folder / ("cloud_1583836591_" + std::to_string(100'000'000 * (i + 1)) + ".pcd"));
  }
  const ProcessResult college = run_surefoot({"info", "college"}, scratch.path());
  EXPECT_EQ(college.exit_code, 0) << college;
  EXPECT_NE(college.output.find("1583836591.100000000 .. 1583836591.300000000"), std::string::npos)
      << college;
}

TEST(Datasets, BasePosesNeedNoExtrinsicWhereItIsKnown) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(4));
  const ProcessResult known = run_surefoot({"run", "in", "-o", "out", "--dataset", "leg-kilo",
                                            "--pose-of", "base", "--no-report", "--no-picture"},
                                           scratch.path());
  EXPECT_EQ(known.exit_code, 0) << known;
  const ProcessResult unknown = run_surefoot(
      {"run", "in", "-o", "out2", "--dataset", "m2dgr", "--pose-of", "base"}, scratch.path());
  EXPECT_EQ(unknown.exit_code, 2) << unknown;
}

}  // namespace
}  // namespace surefoot::test
