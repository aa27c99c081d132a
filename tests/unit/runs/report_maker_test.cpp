// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/report_maker.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "runs/scans_csv.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

class ReportMakerTest : public test::Scratch {
 protected:
  /// A run of scans along a bend, whose map is a point above each pose, and its truth.
  ReportMakerTest() {
    Trajectory measured;
    std::vector<Eigen::Vector3f> points;
    std::string scans = scans_csv_header();
    for (int i = 0; i < 40; ++i) {
      Estimate estimate;
      estimate.status = Status::ok;
      estimate.stamp_ns = i * std::int64_t{100'000'000};
      Pose pose;
      pose.rotation = so3_exp({0.0, 0.0, 0.05 * i});
      pose.translation = {0.3 * i, 0.01 * i * i, 0.02 * i};
      estimate.T_world_lidar = pose;
      measured.push_back({estimate.stamp_ns, pose});
      points.emplace_back(pose.translation.cast<float>() + Eigen::Vector3f::UnitZ());
      scans += scans_csv_line({static_cast<std::size_t>(i), "a", estimate, {}});
      truth_.push_back({estimate.stamp_ns, T_utm_map_ * pose});
    }
    write("run/scans.csv", scans);
    io::write_tum(run_ / kTrajectoryFile, measured);
    io::write_tum(folder_ / "utm.tum", truth_);
    io::write_kitti_poses(run_ / kKittiTrajectoryFile, measured);
    io::write_ply(run_ / kMapFile, points, std::vector<io::PlyColumn>{});
  }

  std::filesystem::path run_ = folder_ / "run";
  Pose T_utm_map_{so3_exp({0.0, 0.0, 1.0}), {512'345.678, 5'412'345.432, 123.456}};
  Trajectory truth_;
};

float step_at(double value) {
  const auto shown = static_cast<float>(value);
  return std::nextafter(shown, std::numeric_limits<float>::infinity()) - shown;
}

/// At 5400 km floats are half a metre apart.
TEST_F(ReportMakerTest, OfCoordinatesInUtmIsShownFromAnOriginNearby) {
  ReportMaker maker;
  maker.add_run(run_, {}, folder_ / "utm.tum");
  const report::Report report = maker.take({});
  const report::ReportRun& run = report.runs.at(0);
  const Eigen::Vector3d origin(512'000.0, 5'412'000.0, 0.0);
  EXPECT_EQ(report.recordings.at(0).origin, origin);
  const Trajectory& shown = report.recordings.at(0).truth;
  ASSERT_EQ(shown.size(), truth_.size());
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const Eigen::Vector3d expected = truth_[i].pose.translation - origin;
    EXPECT_LT((shown[i].pose.translation - expected).norm(), 1e-5);
    EXPECT_LT((run.poses[i]->translation - expected).norm(), 1e-4);
    EXPECT_LT(step_at(run.poses[i]->translation.cwiseAbs().maxCoeff()), 1e-3F);
    EXPECT_LT((run.map.points[i].cast<double>() - expected - Eigen::Vector3d::UnitZ()).norm(),
              1e-3);
  }
  const report::Fact said{"Coordinates", "of the truth, less x 512000, y 5412000, z 0 m"};
  EXPECT_NE(std::find(run.facts.begin(), run.facts.end(), said), run.facts.end());
}

/// Copies the run's first scans into a folder of its own.
void copy_part(const std::filesystem::path& run, const std::filesystem::path& part, int scans) {
  std::filesystem::create_directories(part);
  for (const auto& [file, head] : {std::pair{kScansFile, 1}, {kKittiTrajectoryFile, 0}}) {
    std::ifstream whole(run / file);
    std::ofstream kept(part / file);
    std::string line;
    for (int i = 0; i < scans + head && std::getline(whole, line); ++i) kept << line << '\n';
  }
  Trajectory measured = io::read_tum(run / kTrajectoryFile);
  measured.resize(static_cast<std::size_t>(scans));
  io::write_tum(part / kTrajectoryFile, measured);
}

TEST_F(ReportMakerTest, ShowsTheTruthOverAllRunsOfARecording) {
  copy_part(run_, folder_ / "first", 10);
  ReportMaker maker;
  maker.add_run(folder_ / "first", {}, folder_ / "utm.tum");
  maker.add_run(run_, {}, folder_ / "utm.tum");
  const report::Report report = maker.take({});
  ASSERT_EQ(report.runs.at(0).scans.size(), 10U);
  EXPECT_EQ(report.recordings.at(0).truth.size(), truth_.size());
}

/// A broken gt.tum beside a recording takes no page from its run; one that is named does.
TEST_F(ReportMakerTest, ATruthThatCannotBeReadIsSaidWhereNobodyNamedIt) {
  write("in/gt.tum", "no truth");
  write("run/run.yaml", "input: {path: " + (folder_ / "in").string() + "}\n");
  ReportMaker maker;
  maker.add_run(run_);
  ASSERT_EQ(maker.problems().size(), 1U);
  EXPECT_NE(maker.problems().front().find("gt.tum"), std::string::npos) << maker.problems().front();
  const report::Report report = maker.take({});
  EXPECT_EQ(report.runs.at(0).scans.size(), 40U);
  EXPECT_FALSE(report.runs.at(0).notes.empty());
  ReportMaker named(folder_ / "in/gt.tum");
  EXPECT_THROW(named.add_run(run_), io::ReadError);
}

TEST_F(ReportMakerTest, OfAClockThatWasSetBackHasTimesThatAscend) {
  std::string scans = scans_csv_header();
  for (std::size_t i = 0; i < 40; ++i) {
    Estimate estimate;
    estimate.status = Status::ok;
    estimate.stamp_ns = (static_cast<std::int64_t>(i) - (i < 20 ? 0 : 3000)) * 100'000'000;
    scans += scans_csv_line({i, "a", estimate, {}});
  }
  write("run/scans.csv", scans);
  ReportMaker maker;
  maker.add_run(run_);
  const report::Report report = maker.take({});
  const std::vector<std::int64_t>& stamps = report.runs.at(0).scans.stamps_ns;
  EXPECT_TRUE(std::ranges::is_sorted(stamps));
  EXPECT_LT(stamps.back() - stamps.front(), 6'000'000'000);
}

TEST_F(ReportMakerTest, OfCoordinatesNearTheOriginIsShownAsTheyAre) {
  for (StampedPose& pose : truth_) pose.pose = T_utm_map_.inverse() * pose.pose;
  io::write_tum(folder_ / "near.tum", truth_);
  ReportMaker maker;
  maker.add_run(run_, {}, folder_ / "near.tum");
  const report::Report report = maker.take({});
  EXPECT_NEAR(report.recordings.at(0).truth.at(10).pose.translation.x(), 3.0, 1e-6);
  for (const report::Fact& fact : report.runs.at(0).facts) EXPECT_NE(fact.first, "Coordinates");
}

double largest_turn_deg(const report::RunEvaluation& evaluation) {
  return nlohmann::json::parse(evaluation.json)["errors"]["ape_rotation_angle"]["max"];
}

TEST_F(ReportMakerTest, WherePositionsLeaveATurnOpenFiguresAreAlignedByPoses) {
  ReportMaker bend;
  bend.add_run(run_, {}, folder_ / "utm.tum");
  EXPECT_EQ(bend.take({}).runs.at(0).evaluation->align, "se3");

  Trajectory measured = io::read_tum(run_ / kTrajectoryFile);
  for (std::size_t i = 0; i < measured.size(); ++i) {  // a robot that stands, and millimetres
    const double s = static_cast<double>(i);
    truth_[i].pose = {so3_exp({0.0, 0.0, 1.0}), {5.0, 3.0 + 1e-9 * s, 0.4}};
    measured[i].pose = Pose();
    measured[i].pose.translation =
        1e-3 * Eigen::Vector3d(std::cos(4 * s), std::sin(6 * s), std::cos(s));
  }
  io::write_tum(run_ / kTrajectoryFile, measured);
  io::write_tum(folder_ / "stay.tum", truth_);
  for (StampedPose& pose : truth_) pose.pose.translation.y() = 3.0;
  io::write_tum(folder_ / "point.tum", truth_);
  for (const char* truth : {"stay.tum", "point.tum"}) {
    ReportMaker stay;
    stay.add_run(run_, {}, folder_ / truth);
    const report::Report report = stay.take({});
    const std::optional<report::RunEvaluation>& evaluation = report.runs.at(0).evaluation;
    ASSERT_TRUE(evaluation) << truth;
    EXPECT_EQ(evaluation->align, "poses") << truth;
    EXPECT_LT(largest_turn_deg(*evaluation), 0.1) << truth;
  }
}

}  // namespace
}  // namespace surefoot::runs
