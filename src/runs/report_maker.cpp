// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/report_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "evaluation/ape.hpp"
#include "evaluation/evaluate.hpp"
#include "evaluation/evaluation_json.hpp"
#include "evaluation/option_names.hpp"
#include "io/file_writer.hpp"
#include "io/trajectory_files.hpp"
#include "report/page.hpp"
#include "report/report_json.hpp"
#include "runs/run_folder.hpp"
#include "runs/run_truth.hpp"
#include "runs/walk_times.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;
using evaluation::AssociatedTrajectories;
using evaluation::Relation;

namespace {

report::ErrorSeries error_series(const AssociatedTrajectories& pairs) {
  report::ErrorSeries series;
  const std::vector<double> translations = absolute_errors(pairs, Relation::translation);
  const std::vector<evaluation::SplitError> split = absolute_split_errors(pairs);
  for (std::size_t i = 0; i < split.size(); ++i) {
    const Pose& estimate = pairs.estimate[i].pose;
    const Pose& reference = pairs.reference[i].pose;
    series.stamps_ns.push_back(pairs.estimate[i].stamp_ns);
    series.translation_m.push_back(static_cast<float>(translations[i]));
    series.horizontal_m.push_back(static_cast<float>(split[i].horizontal));
    series.vertical_m.push_back(
        static_cast<float>(estimate.translation.z() - reference.translation.z()));
    series.tilt_deg.push_back(static_cast<float>(split[i].tilt));
    series.yaw_deg.push_back(static_cast<float>(split[i].yaw));
  }
  return series;
}

/// Whole kilometres near the truth's begin: less these its coordinates, and those of runs in its
/// world, are drawn to the millimetre, which a page's numbers cannot tell at 5000 km (UTM).
Eigen::Vector3d origin_near(const Trajectory& truth) {
  constexpr double kStep = 1000.0;  // [m]
  if (truth.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d steps = truth.front().pose.translation / kStep;
  return kStep * Eigen::Vector3d(steps.array().round());
}

/// From the run's frame to the truth's, less what it is drawn from.
void move_run(const Pose& T_world_map, report::ReportRun& run) {
  for (std::vector<std::optional<Pose>>* poses : {&run.poses, &run.corrected}) {
    for (std::optional<Pose>& pose : *poses) {
      if (pose) pose = T_world_map * *pose;
    }
  }
  const Eigen::Matrix3f R = T_world_map.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_world_map.translation.cast<float>();
  const auto move = [&](std::vector<Eigen::Vector3f>& points) {
    for (Eigen::Vector3f& point : points) point = R * point + t;
  };
  move(run.map.points);
  for (report::DeskewSample& sample : run.deskewing) {
    move(sample.measured);
    move(sample.deskewed);
  }
}

/// The figures are those of `surefoot eval --pair interpolate`, by poses where the positions leave
/// a turn open; what is drawn is laid on the truth, less `origin`.
void evaluate_run(const Trajectory& truth, const Trajectory& measured,
                  const Eigen::Vector3d& origin, report::ReportRun& run) {
  evaluation::EvaluationOptions options;
  options.association = pairing_with(truth, measured);
  AssociatedTrajectories pairs = evaluation::associate(truth, measured, options.association);
  if (leaves_turn_open(pairs, options.alignment)) {
    options.alignment = evaluation::AlignmentMethod::poses;
  }
  // Named as `surefoot eval` names it: by the file.
  const auto figures = evaluation::evaluate("trajectory", truth, measured, options);
  Pose T_world_map = laid_on_truth(pairs);
  pairs.estimate = evaluation::aligned(pairs.estimate, {T_world_map});
  run.evaluation = {std::string(name_of(evaluation::kAlignmentNames, options.alignment)),
                    evaluation::json_of(figures).dump(), error_series(pairs)};
  T_world_map.translation -= origin;
  move_run(T_world_map, run);
  if (origin.isZero()) return;
  run.facts.emplace_back("Coordinates", fmt::format("of the truth, less x {}, y {}, z {} m",
                                                    origin.x(), origin.y(), origin.z()));
}

std::string name_of(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

}  // namespace

std::size_t ReportMaker::recording_of(const fs::path& input) {
  const auto found = std::ranges::find(recordings_, input, &Recording::input);
  const auto index = static_cast<std::size_t>(found - recordings_.begin());
  if (found == recordings_.end()) {
    recordings_.push_back({input, {}, {}});
    report_.recordings.push_back({input.empty() ? "recording not known" : name_of(input), {}});
  }
  return index;
}

void ReportMaker::add_run(const fs::path& folder, const std::string& name, const fs::path& truth) {
  RunFolder read = read_run_folder(folder);
  report::ReportRun run;
  run.recording = recording_of(read.input);
  run.facts = std::move(read.facts);
  run.facts.emplace_back("Results", fs::absolute(folder).lexically_normal().string());
  run.notes = std::move(read.notes);
  run.parameters = std::move(read.parameters);
  run.scans = std::move(read.scans);
  run.poses = std::move(read.poses);
  // Views and charts take times that ascend.
  run.scans.stamps_ns = walk_times(run.scans.stamps_ns, run.poses);
  run.map = std::move(read.map);
  run.deskewing = std::move(read.deskewing);
  run.loops = std::move(read.loops);
  run.corrected = std::move(read.corrected);
  run.name = !name.empty() ? name : read.method.empty() ? name_of(folder) : read.method;
  const bool taken =
      std::any_of(report_.runs.begin(), report_.runs.end(), [&](const report::ReportRun& other) {
        return other.recording == run.recording && other.name == run.name;
      });
  if (taken) run.name += fmt::format(" ({})", name_of(folder));

  fs::path truth_file = truth.empty() ? truth_ : truth;
  const bool named = !truth_file.empty();  // what somebody names must do
  if (!named && read.poses_of_lidar) truth_file = truth_beside(read.input);
  if (!truth_file.empty()) {
    run.facts.emplace_back("Truth", truth_file.string());
    Trajectory poses;
    if (named) poses = read_truth_poses(truth_file);
    try {
      if (!named) poses = read_truth_poses(truth_file);
      Recording& recording = recordings_[run.recording];
      const Eigen::Vector3d origin = recording.origin.value_or(origin_near(poses));
      evaluate_run(poses, read.measured, origin, run);
      recording.origin = origin;  // of none that was not compared, which is where it was
      if (recording.truth.empty()) recording.truth = poses;
    } catch (const std::exception& error) {
      run.notes.push_back(fmt::format("not compared with the truth: {}", error.what()));
      problems_.push_back(fmt::format("{}: {}", folder.string(), run.notes.back()));
    }
  }
  report_.runs.push_back(std::move(run));
}

/// While any of the recording's runs lasted: they may be of different parts of it.
Trajectory ReportMaker::shown_truth(std::size_t recording) const {
  std::int64_t first_ns = std::numeric_limits<std::int64_t>::max();
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
  for (const report::ReportRun& run : report_.runs) {
    if (run.recording != recording || run.scans.size() == 0) continue;
    first_ns = std::min(first_ns, run.scans.stamps_ns.front());
    last_ns = std::max(last_ns, run.scans.stamps_ns.back());
  }
  Trajectory shown = truth_between(recordings_[recording].truth, first_ns, last_ns);
  for (StampedPose& pose : shown) {
    pose.pose.translation -= recordings_[recording].origin.value_or(Eigen::Vector3d::Zero());
  }
  return shown;
}

report::Report ReportMaker::take(const std::string& title) {
  report_.version = SUREFOOT_VERSION;
  report_.title = title;
  for (std::size_t i = 0; i < recordings_.size(); ++i) {
    report_.recordings[i].truth = shown_truth(i);
    report_.recordings[i].origin = recordings_[i].origin.value_or(Eigen::Vector3d::Zero());
  }
  if (title.empty() && report_.recordings.size() == 1) {
    report_.title = report_.recordings.front().name;
  } else if (title.empty()) {
    report_.title =
        fmt::format("{} recordings, {} runs", report_.recordings.size(), report_.runs.size());
  }
  return std::move(report_);
}

bool has_report_page() { return !report::page_template().empty(); }

void write_report(const report::Report& report, const fs::path& file, std::size_t map_points) {
  if (!has_report_page()) {
    throw std::runtime_error(
        "this program was built without the report's page; with Node.js 18 or later, npm and the "
        "network, cmake -D SUREFOOT_WEB=ON builds it or says what is missing");
  }
  io::write_whole_file(file, report::make_page(report::page_template(), report.title,
                                               report::to_json(report, map_points)));
}

}  // namespace surefoot::runs
