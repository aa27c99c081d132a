// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_folder.hpp"

#include <fmt/format.h>
#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/recording.hpp"
#include "io/trajectory_files.hpp"
#include "runs/deskew_samples.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/run_yaml.hpp"
#include "runs/scans_csv.hpp"
#include "surefoot/config.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;
using io::ReadError;

namespace {

/// The run's parameters beside what the table of parameters knows of them.
std::vector<report::ReportParameter> parameters_of(const RunDescription& description) {
  std::vector<report::ReportParameter> result;
  for (const ParameterInfo& info : parameters()) {
    for (const auto& [name, value] : description.parameters) {
      if (name != info.name) continue;
      result.push_back({name, value, info.default_value, info.unit, info.help});
    }
  }
  return result;
}

std::string line_of(const OptionTexts& options) {
  std::string line;
  for (const auto& [name, value] : options) {
    line += fmt::format("{}--{}={}", line.empty() ? "" : " ", name, value);
  }
  return line;
}

void add_description(const RunDescription& description, RunFolder& run) {
  run.method = description.method;
  run.input = description.input;
  run.poses_of_lidar = description.pose_of != "base";
  const auto add = [&](const char* label, const std::string& text) {
    if (!text.empty()) run.facts.emplace_back(label, text);
  };
  add("Method", description.method);
  add("Recording", description.input);
  add("Content", description.content);
  add("Options", line_of(description.options));
  add("Levelling", description.level);
  add("Poses of", description.pose_of);
  add("Processor", description.processor);
  add("Cores", description.cores);
  add("Threads", description.threads);
  add("Compiler", description.compiler);
  add("Surefoot", description.version);
  if (description.interrupted == "true") run.notes.emplace_back("the run was interrupted");
  run.notes.insert(run.notes.end(), description.segments.begin(), description.segments.end());
  run.notes.insert(run.notes.end(), description.notes.begin(), description.notes.end());
  run.parameters = parameters_of(description);
}

std::vector<float> numbers_of(const io::PointTable& table, const char* name) {
  const io::Column* column = table.find(name);
  if (column == nullptr) return {};
  std::vector<float> values(table.size);
  io::for_each_value(*column, table.size,
                     [&](std::size_t i, auto value) { values[i] = float(value); });
  return values;
}

report::MapCloud read_map(const fs::path& file) {
  try {
    std::vector<std::byte> bytes;
    io::read_whole_file(file, bytes);
    const io::PointTable table = io::parse_ply(bytes);
    report::MapCloud map;
    map.points.resize(table.size);
    for (int axis = 0; axis < 3; ++axis) {
      const char* name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
      const io::Column* column = table.find(name);
      if (column == nullptr) throw ReadError(fmt::format("its points have no {}", name));
      io::for_each_value(*column, table.size,
                         [&](std::size_t i, auto value) { map.points[i][axis] = float(value); });
    }
    map.intensities = numbers_of(table, "intensity");
    map.first_seen = numbers_of(table, "first_seen");
    return map;
  } catch (const ReadError& error) {
    throw ReadError(file.string() + ": " + error.what());
  }
}

/// The rows of trajectory_kitti.txt, one for every line of scans.csv. A run that was killed may
/// have left one row more.
std::vector<std::optional<Pose>> read_poses(const fs::path& file, const report::ScanTable& scans) {
  const std::vector<Pose> rows = io::read_kitti_poses(file);
  if (rows.size() < scans.size()) {
    throw ReadError(fmt::format("{}: {} poses for the {} scans of scans.csv", file.string(),
                                rows.size(), scans.size()));
  }
  if (rows.size() > scans.size() + 1) {
    throw ReadError(fmt::format(
        "{}: ends after {} scans, of which {} has {}: it is cut short, or of another run",
        (file.parent_path() / kScansFile).string(), scans.size(), file.filename().string(),
        rows.size()));
  }
  std::vector<std::optional<Pose>> poses;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const bool rejected = scans.statuses[i] == "rejected";
    poses.push_back(rejected ? std::nullopt : std::optional(rows[i]));
  }
  return poses;
}

/// What loops.csv and the trajectory after all loops tell, where loops were closed.
void read_loops(const fs::path& folder, RunFolder& run) {
  if (!fs::exists(folder / kLoopsFile) || !fs::exists(folder / kOptimizedTrajectoryFile)) return;
  run.loops = read_loops_csv(folder / kLoopsFile, run.scans);
  // Where a map was gone on with, the corrected poses are in that map's frame.
  if (fs::exists(folder / kMapLoopsFile) || run.scans.size() == 0) return;
  run.corrected.resize(run.scans.size());
  const ScansByStamp scans(run.scans);
  std::size_t scan = 0;  // poses are in the order of the scans
  for (const StampedPose& pose : io::read_tum(folder / kOptimizedTrajectoryFile)) {
    scan = scans.nearest(pose.stamp_ns, scan);
    run.corrected[scan++] = pose.pose;
  }
}

}  // namespace

std::string unfinished_text(const fs::path& estimate) {
  std::error_code ignored;
  const fs::path folder = fs::is_directory(estimate, ignored) ? estimate : estimate.parent_path();
  if (!fs::exists(folder / kScansFile, ignored)) return {};
  if (!fs::exists(folder / kDescriptionFile, ignored)) {
    return "no run.yaml: the run did not come to its end, the trajectory is only what it had "
           "written";
  }
  try {
    if (read_run_yaml(folder / kDescriptionFile).interrupted != "true") return {};
  } catch (const ReadError&) {
    return {};  // who evaluates a trajectory does not ask for its description
  }
  return "the run was interrupted";
}

RunFolder read_run_folder(const fs::path& folder) {
  if (!fs::exists(folder)) throw ReadError(folder.string() + ": no such folder");
  if (!fs::is_directory(folder) || !fs::exists(folder / kScansFile)) {
    throw ReadError(folder.string() +
                    ": expected a folder that surefoot run has written, with a scans.csv");
  }
  RunFolder run;
  if (fs::exists(folder / kDescriptionFile)) {
    add_description(read_run_yaml(folder / kDescriptionFile), run);
  } else {
    run.notes.emplace_back("no run.yaml: the run did not come to its end");
  }
  run.scans = read_scans_csv(folder / kScansFile);
  run.poses = read_poses(folder / kKittiTrajectoryFile, run.scans);
  run.measured = io::read_tum(folder / kTrajectoryFile);
  read_loops(folder, run);
  if (fs::exists(folder / kMapFile)) {
    run.map = read_map(folder / kMapFile);
  } else {
    run.notes.emplace_back("no map.ply: paths are shown without a map");
  }
  if (fs::exists(folder / kDeskewingFile)) {
    run.deskewing = read_deskew_samples(folder / kDeskewingFile);
    std::erase_if(run.deskewing,
                  [&](const auto& sample) { return sample.scan >= run.scans.size(); });
  }
  return run;
}

}  // namespace surefoot::runs
