// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "run_output.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "config_file.hpp"
#include "dataset/decimal_time.hpp"
#include "dataset/ply_writer.hpp"
#include "dataset/trajectory_files.hpp"
#include "machine.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "report/run_picture.hpp"
#endif

namespace surefoot::app {

namespace fs = std::filesystem;

namespace {

std::string csv_header() {
  std::string header =
      "scan,name,stamp,status,message,x,y,z,points,registered_points,converged,"
      "horizontal_iterations,horizontal_matches,horizontal_residual_m,"
      "vertical_iterations,vertical_matches,vertical_residual_m,vertical_observability,"
      "degenerate,least_information,sigma_x_m,sigma_y_m,sigma_z_m,sigma_roll_rad,sigma_pitch_rad,"
      "sigma_yaw_rad";
  for (const char* step : kStepNames) header += fmt::format(",ms_{}", step);
  return header + ",ms_total\n";
}

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '"');
  }
  return '"' + text + '"';
}

std::string degenerate_names(const Estimate& estimate) {
  std::string names;
  for (const DegenerateDirection& weak : estimate.degenerate) {
    names += (names.empty() ? "" : " ") + weak.name;
  }
  return names;
}

std::string csv_line(std::size_t scan, const std::string& name, const Estimate& e,
                     const StepTimes& times) {
  const Eigen::Vector3d& t = e.T_map_lidar.translation;
  std::string line = fmt::format(
      "{},{},{},{},{},{:.6f},{:.6f},{:.6f},{},{},{},{},{},{:.6f},{},{},{:.6f},{:.6f},{},{:.6f}",
      scan, quoted(name), dataset::format_seconds(e.stamp_ns), to_string(e.status),
      quoted(e.message), t.x(), t.y(), t.z(), e.points, e.registered_points, e.converged ? 1 : 0,
      e.horizontal.iterations, e.horizontal.matches, e.horizontal.residual, e.vertical.iterations,
      e.vertical.matches, e.vertical.residual, e.vertical.observability, degenerate_names(e),
      e.degenerate.empty() ? 1.0 : e.degenerate.front().information);
  for (int i = 0; i < 6; ++i) line += fmt::format(",{:.3e}", std::sqrt(e.covariance(i, i)));
  for (const double milliseconds : times.milliseconds()) {
    line += fmt::format(",{:.4f}", milliseconds);
  }
  return line + fmt::format(",{:.4f}\n", times.total());
}

void write_run_yaml(const fs::path& path, const RunOptions& options, const Config& config,
                    const RunSummary& summary) {
  YAML::Emitter out;
  out << YAML::BeginMap;
  out << YAML::Key << "surefoot" << YAML::Value << SUREFOOT_VERSION;
  out << YAML::Key << "method" << YAML::Value << method_of(options);
  out << YAML::Key << "input" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "path" << YAML::Value << fs::absolute(options.input).string();
  out << YAML::Key << "content" << YAML::Value << summary.input_description;
  out << YAML::Key << "start" << YAML::Value << options.start;
  out << YAML::Key << "stride" << YAML::Value << options.stride;
  out << YAML::Key << "notes" << YAML::Value << summary.notes << YAML::EndMap;
  out << YAML::Key << "result" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "scans" << YAML::Value << summary.scans;
  out << YAML::Key << "untrusted_scans" << YAML::Value << summary.untrusted;
  out << YAML::Key << "interrupted" << YAML::Value << summary.interrupted;
  out << YAML::Key << "level" << YAML::Value << summary.level;
  out << YAML::Key << "pose_of" << YAML::Value << options.pose_of << YAML::EndMap;
  out << YAML::Key << "machine" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "processor" << YAML::Value << processor_name();
  out << YAML::Key << "cores" << YAML::Value << processor_cores();
  out << YAML::Key << "threads" << YAML::Value << options.threads;
  out << YAML::Key << "compiler" << YAML::Value << __VERSION__ << YAML::EndMap;
  out << YAML::Key << "parameters" << YAML::Value;
  emit_parameters(out, config);
  out << YAML::EndMap;
  std::ofstream file(path);
  file << out.c_str() << '\n';
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

fs::path make_output_folder(const fs::path& asked, const fs::path& input) {
  if (!asked.empty()) {
    fs::create_directories(asked);
    return asked;
  }
  const fs::path whole = fs::absolute(input).lexically_normal();
  const fs::path name = whole.has_filename() ? whole.stem() : whole.parent_path().filename();
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const std::string stem = fmt::format("{}-{:%Y%m%d-%H%M%S}", name.string(), fmt::localtime(now));
  fs::path folder = fs::path("results") / stem;
  for (int i = 2; !fs::create_directories(folder); ++i) {
    folder = fs::path("results") / fmt::format("{}-{}", stem, i);
  }
  std::error_code no_link;  // some file systems have no links; the results do not need one
  fs::remove("results/latest", no_link);
  fs::create_directory_symlink(folder.filename(), "results/latest", no_link);
  return folder;
}

RunOutput::RunOutput(const RunOptions& options)
    : folder_(make_output_folder(options.output, options.input)),
      tum_(open("trajectory.tum")),
      kitti_(open("trajectory_kitti.txt")),
      csv_(open("scans.csv")) {
  tum_ << "# stamp [s] at mid-scan, x y z [m], qx qy qz qw: T_map_" << options.pose_of
       << ", measured poses only\n";
  csv_ << csv_header() << std::flush;
  if (options.pose_rate > 0.0) {
    pose_period_ns_ = std::max<std::int64_t>(std::llround(1e9 / options.pose_rate), 1);
    dense_ = open("trajectory_dense.tum");
    dense_ << "# stamp [s], x y z [m], qx qy qz qw: T_map_" << options.pose_of
           << " within the measured scans\n";
  }
}

std::ofstream RunOutput::open(const char* name) {
  std::ofstream file(folder_ / name);
  if (!file) throw std::runtime_error((folder_ / name).string() + ": cannot be written");
  return file;
}

void RunOutput::add(const std::string& name, const Estimate& estimate, const Pose& T_lidar_written,
                    const StepTimes& times) {
  const StampedPose pose{estimate.stamp_ns, estimate.T_map_lidar * T_lidar_written};
  if (estimate.trusted()) tum_ << dataset::format_tum({pose}) << std::flush;
  if (estimate.trusted() && dense_.is_open()) add_dense(estimate, T_lidar_written);
  if (estimate.status != Status::rejected) {
    trajectory_.push_back(pose);
    untrusted_.push_back(!estimate.trusted());
  }
  kitti_ << dataset::format_kitti_poses({pose}) << std::flush;
  csv_ << csv_line(lines_++, name, estimate, times) << std::flush;
  if (!tum_ || !kitti_ || !csv_ || !dense_) {
    throw std::runtime_error(folder_.string() + ": cannot be written any more (disk full?)");
  }
}

/// Poses at multiples of the period, each once: of two scans that overlap, the first one's.
void RunOutput::add_dense(const Estimate& estimate, const Pose& T_lidar_written) {
  const std::int64_t from = std::max(estimate.trajectory.start_ns(), dense_until_ns_);
  const std::int64_t to = estimate.trajectory.end_ns();
  for (std::int64_t t = (from / pose_period_ns_ + 1) * pose_period_ns_; t <= to;
       t += pose_period_ns_) {
    dense_ << dataset::format_tum({{t, estimate.pose_at(t) * T_lidar_written}});
  }
  dense_ << std::flush;
  dense_until_ns_ = std::max(dense_until_ns_, to);
}

void RunOutput::finish(const RunOptions& options, const Config& config, const RunSummary& summary,
                       const MapBuilder& map) {
  write_run_yaml(folder_ / "run.yaml", options, config, summary);
  if (!options.no_map) {
    const std::vector<dataset::PlyColumn> columns = {{"intensity", map.intensities()},
                                                     {"first_seen", map.first_seen()}};
    dataset::write_ply(folder_ / "map.ply", map.points(), columns);
  }
#ifdef SUREFOOT_HAS_PICTURES
  if (!options.no_picture) {
    const fs::path input = fs::absolute(options.input).lexically_normal();
    const fs::path name = input.has_filename() ? input.filename() : input.parent_path().filename();
    const std::string title = fmt::format("{}, method {}", name.string(), method_of(options));
    report::draw_run_picture({title, trajectory_, map.points(), {}, untrusted_},
                             folder_ / "picture.png");
  }
#endif
}

}  // namespace surefoot::app
