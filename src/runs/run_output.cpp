// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "runs/run_truth.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;

namespace {

fs::path map_file_of(const fs::path& given) {
  return given.empty() ? fs::path{} : saved_map_file(given);
}

/// An hour of ten scans a second, more than a picture can show.
constexpr std::size_t kPicturePoses = 1 << 15;

/// Of a scan's duration, between it and the one before: more is a scan that is missing.
constexpr std::int64_t kLongestSeam = 4;

/// That is no less than `least`.
std::int64_t first_multiple(std::int64_t period, std::int64_t least) {
  const std::int64_t over = least % period;
  return over > 0 ? least - over + period : least - over;
}

}  // namespace

std::vector<std::string> segment_lines(const std::map<int, SegmentSpan>& segments) {
  std::vector<std::string> lines;
  if (segments.size() < 2) return lines;
  for (const auto& [number, span] : segments) {
    lines.push_back(fmt::format("segment {}: {} pose{} from {} to {} s", number, span.poses,
                                span.poses == 1 ? "" : "s", io::format_seconds(span.first_ns),
                                io::format_seconds(span.last_ns)));
  }
  return lines;
}

RunOutput::RunOutput(const RunOptions& options)
    : folder_(options.output, options.input, options.overwrite, map_file_of(options.continued),
              map_file_of(options.localize)),
      path_(kPicturePoses) {}

void RunOutput::begin(const RunOptions& options) {
  folder_.clear();
  csv_ = open(kScansFile);
  csv_ << scans_csv_header() << std::flush;  // first: by it the folder is known for a run's
  tum_ = open(kTrajectoryFile);
  kitti_ = open(kKittiTrajectoryFile);
  tum_ << "# stamp [s] at mid-scan, x y z [m], qx qy qz qw: T_world_" << options.pose_of
       << ", measured poses only"
       << (options.reference ? "; a reference: of all scans at once" : "") << '\n';
  if (options.pose_rate > 0.0) {
    pose_period_ns_ = std::max<std::int64_t>(std::llround(1e9 / options.pose_rate), 1);
    dense_ = open(kDenseTrajectoryFile);
    dense_ << "# stamp [s], x y z [m], qx qy qz qw: T_world_" << options.pose_of
           << " within the measured scans and at their seams\n";
  }
}

std::ofstream RunOutput::open(const char* name) {
  const fs::path path = folder_.path() / name;
  std::ofstream file(path);
  if (!file) {
    throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno));
  }
  return file;
}

void RunOutput::add(const std::string& name, const Estimate& estimate, const Pose& T_lidar_written,
                    const StepTimes& times) {
  const StampedPose pose{estimate.stamp_ns, estimate.T_world_lidar * T_lidar_written};
  const int segment = path_.poses().empty() ? 0 : path_.segments().back();
  if (estimate.segment != segment) {
    tum_ << segment_mark(estimate.segment);
    if (dense_.is_open()) dense_ << segment_mark(estimate.segment);
  }
  if (estimate.trusted()) {
    tum_ << io::format_tum({pose}) << std::flush;
    SegmentSpan& span =
        segments_.try_emplace(estimate.segment, SegmentSpan{0, pose.stamp_ns, pose.stamp_ns})
            .first->second;
    ++span.poses;
    span.first_ns = std::min(span.first_ns, pose.stamp_ns);
    span.last_ns = std::max(span.last_ns, pose.stamp_ns);
    if (dense_.is_open()) add_dense(estimate, T_lidar_written);
  }
  if (estimate.status != Status::rejected) {
    if (!path_.poses().empty() && estimate.segment == segment) {
      length_ += (pose.pose.translation - path_.poses().back().pose.translation).norm();
    }
    path_.add(pose, !estimate.trusted(), estimate.segment);
  }
  kitti_ << io::format_kitti_poses({pose}) << std::flush;
  csv_ << scans_csv_line({lines_++, name, estimate, times}) << std::flush;
  if (!tum_ || !kitti_ || !csv_ || !dense_) {
    throw std::runtime_error(folder_.path().string() +
                             ": cannot be written any more: " + std::strerror(errno));
  }
}

void RunOutput::add_sample(const Scan& scan, const Estimate& estimate) {
  samples_.add(lines_ - 1, scan, estimate);
}

/// Poses at multiples of the period, each once: of two scans that overlap, the first one's; between
/// two that follow each other as the second one's motion has it, carried back. Where the clock was
/// set back it begins again, as trajectory.tum does.
void RunOutput::add_dense(const Estimate& estimate, const Pose& T_lidar_written) {
  const std::int64_t start = estimate.trajectory.start_ns(), to = estimate.trajectory.end_ns();
  if (estimate.stamp_ns <= dense_mid_ns_) dense_until_ns_ = start - 1;
  dense_mid_ns_ = estimate.stamp_ns;
  const bool follows = start - dense_until_ns_ <= (to - start) / kLongestSeam;
  const std::int64_t from = follows ? dense_until_ns_ + 1 : start;
  for (std::int64_t t = first_multiple(pose_period_ns_, from); t <= to; t += pose_period_ns_) {
    dense_ << io::format_tum({{t, estimate.pose_at(t) * T_lidar_written}});
  }
  dense_ << std::flush;
  dense_until_ns_ = std::max(dense_until_ns_, to);
}

Trajectory RunOutput::measured() const {
  Trajectory poses;
  for (std::size_t i = 0; i < path_.poses().size(); ++i) {
    if (!path_.untrusted()[i]) poses.push_back(path_.poses()[i]);
  }
  return poses;
}

/// The recording's truth in the map frame, where it has one; a broken file is no reason to have no
/// picture.
Trajectory RunOutput::truth_of(const RunOptions& options, const report::DrawnLoops& loops) const {
  const fs::path file = truth_file(options);
  if (file.empty()) return {};
  try {
    return truth_in_map(read_truth_poses(file), measured(), loops);
  } catch (const io::ReadError&) {
    return {};
  }
}

/// A trajectory a segment, where there are several: the lines of trajectory.tum, taken apart.
void RunOutput::write_segments() const {
  if (segments_.size() < 2) return;
  std::ifstream all(folder_.path() / kTrajectoryFile);
  std::string number = "0";
  std::ofstream file;
  for (std::string line; std::getline(all, line);) {
    if (line.starts_with(kSegmentBegins)) {
      number = line.substr(kSegmentBegins.size(), line.find(':') - kSegmentBegins.size());
      file.close();
    }
    if (line.starts_with('#')) continue;
    const fs::path path = folder_.path() / fmt::format("{}{}.tum", kSegmentFiles, number);
    if (!file.is_open()) file.open(path, std::ios::app);
    if (!(file << line << '\n')) {
      throw io::WriteError(path.string() + ": cannot be written: " + std::strerror(errno));
    }
  }
}

void write_map(const fs::path& folder, const mapping::MapBuilder& map) {
  const std::vector<io::PlyColumn> columns = {{"intensity", map.intensities()},
                                              {"first_seen", map.first_seen()}};
  io::write_ply(folder / kMapFile, map.points(), columns);
}

void RunOutput::finish(const RunOptions& options, const RunDescription& description,
                       const mapping::MapBuilder& map, [[maybe_unused]] report::DrawnLoops loops) {
  if (!options.no_map) write_map(folder_.path(), map);
  write_segments();
  const std::vector<report::DeskewSample> sweeps = samples_.samples();
  if (!sweeps.empty()) write_deskew_samples(folder_.path() / kDeskewingFile, sweeps);
#ifdef SUREFOOT_HAS_PICTURES
  if (!options.no_picture) {
    const fs::path input = fs::absolute(options.input).lexically_normal();
    const fs::path name = input.has_filename() ? input.filename() : input.parent_path().filename();
    const std::string title = fmt::format("{}, method {}", name.string(), description.method);
    report::draw_run_picture({title, path_.poses(), map.points(), truth_of(options, loops),
                              path_.untrusted(), path_.segments(), std::move(loops)},
                             folder_.path() / kPictureFile);
  }
#endif
  write_run_yaml(folder_.path() / kDescriptionFile, description);
}

}  // namespace surefoot::runs
