// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "run_folder.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "config_file.hpp"
#include "dataset/file_reader.hpp"
#include "dataset/ply_reader.hpp"
#include "dataset/recording.hpp"
#include "dataset/trajectory_files.hpp"
#include "scan_table_reader.hpp"
#include "surefoot/config.hpp"

namespace surefoot::app {

namespace fs = std::filesystem;
using dataset::ReadError;

namespace {

std::string text_at(const YAML::Node& node, const char* key) {
  return node.IsMap() && node[key] && node[key].IsScalar() ? node[key].Scalar() : std::string();
}

/// run.yaml's "parameters" beside what the table of parameters knows of them.
std::vector<report::ReportParameter> parameters_of(const YAML::Node& groups) {
  std::vector<report::ReportParameter> result;
  for (const ParameterInfo& info : parameters()) {
    const std::size_t dot = info.name.find('.');
    const YAML::Node group = groups.IsMap() ? groups[info.name.substr(0, dot)] : YAML::Node();
    if (!group || !group.IsMap()) continue;
    const std::string value = text_at(group, info.name.substr(dot + 1).c_str());
    if (value.empty()) continue;
    result.push_back({info.name, value, info.default_value, info.unit, info.help});
  }
  return result;
}

void read_description(const YAML::Node& yaml, RunFolder& run) {
  const YAML::Node none(YAML::NodeType::Map);
  const auto part = [&](const char* key) { return yaml[key] ? yaml[key] : none; };
  const YAML::Node input = part("input"), result = part("result"), machine = part("machine");
  run.method = text_at(yaml, "method");
  run.input = text_at(input, "path");
  run.poses_of_lidar = text_at(result, "pose_of") != "base";
  const auto add = [&](const char* label, const std::string& text) {
    if (!text.empty()) run.facts.emplace_back(label, text);
  };
  add("Method", run.method);
  add("Recording", run.input.string());
  add("Content", text_at(input, "content"));
  add("First scan", text_at(input, "start"));
  add("Every n-th scan", text_at(input, "stride"));
  add("Levelling", text_at(result, "level"));
  add("Poses of", text_at(result, "pose_of"));
  add("Processor", text_at(machine, "processor"));
  add("Cores", text_at(machine, "cores"));
  add("Threads", text_at(machine, "threads"));
  add("Compiler", text_at(machine, "compiler"));
  add("Surefoot", text_at(yaml, "surefoot"));
  if (text_at(result, "interrupted") == "true") run.notes.emplace_back("the run was interrupted");
  if (const YAML::Node notes = input["notes"]; notes && notes.IsSequence()) {
    for (const YAML::Node& note : notes) {
      if (note.IsScalar()) run.notes.push_back(note.Scalar());
    }
  }
  run.parameters = parameters_of(part("parameters"));
}

void read_run_yaml(const fs::path& file, RunFolder& run) {
  if (!fs::exists(file)) {
    run.notes.emplace_back("no run.yaml: the run did not come to its end");
    return;
  }
  try {
    const YAML::Node yaml = YAML::LoadFile(file.string());
    if (!yaml.IsMap()) throw ReadError(file.string() + ": expected a run's run.yaml");
    read_description(yaml, run);
  } catch (const YAML::Exception& error) {
    throw ReadError(file.string() + ": not YAML: " + error.what());
  }
}

std::vector<float> numbers_of(const dataset::PointTable& table, const char* name) {
  const dataset::Column* column = table.find(name);
  if (column == nullptr) return {};
  std::vector<float> values(table.size);
  dataset::for_each_value(*column, table.size,
                          [&](std::size_t i, auto value) { values[i] = float(value); });
  return values;
}

report::MapCloud read_map(const fs::path& file) {
  try {
    std::vector<std::byte> bytes;
    dataset::read_whole_file(file, bytes);
    const dataset::PointTable table = dataset::parse_ply(bytes);
    report::MapCloud map;
    map.points.resize(table.size);
    for (int axis = 0; axis < 3; ++axis) {
      const char* name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
      const dataset::Column* column = table.find(name);
      if (column == nullptr) throw ReadError(fmt::format("its points have no {}", name));
      dataset::for_each_value(*column, table.size, [&](std::size_t i, auto value) {
        map.points[i][axis] = float(value);
      });
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
  const std::vector<Pose> rows = dataset::read_kitti_poses(file);
  if (rows.size() < scans.size()) {
    throw ReadError(fmt::format("{}: {} poses for the {} scans of scans.csv", file.string(),
                                rows.size(), scans.size()));
  }
  std::vector<std::optional<Pose>> poses;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const bool rejected = scans.statuses[i] == "rejected";
    poses.push_back(rejected ? std::nullopt : std::optional(rows[i]));
  }
  return poses;
}

}  // namespace

RunFolder read_run_folder(const fs::path& folder) {
  if (!fs::is_directory(folder) || !fs::exists(folder / "scans.csv")) {
    throw ReadError(folder.string() +
                    ": expected a folder that surefoot run has written, with a scans.csv");
  }
  RunFolder run;
  read_run_yaml(folder / "run.yaml", run);
  run.scans = read_scan_table(folder / "scans.csv");
  run.poses = read_poses(folder / "trajectory_kitti.txt", run.scans);
  run.measured = dataset::read_tum(folder / "trajectory.tum");
  if (fs::exists(folder / "map.ply")) {
    run.map = read_map(folder / "map.ply");
  } else {
    run.notes.emplace_back("no map.ply: paths are shown without a map");
  }
  return run;
}

}  // namespace surefoot::app
