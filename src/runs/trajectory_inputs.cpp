// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/trajectory_inputs.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "io/ascii_values.hpp"
#include "io/bags/bag_files.hpp"
#include "io/column_names.hpp"
#include "io/stamps.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "runs/run_truth.hpp"
#include "text/printable.hpp"

namespace surefoot::runs {
namespace {

namespace fs = std::filesystem;

/// A recording's truth would be a perfect estimate of itself.
void refuse_recording(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored) || fs::exists(path / kTrajectoryFile, ignored) ||
      !fs::exists(path / kTruthFile, ignored)) {
    return;
  }
  throw io::ReadError(path.string() + ": is a recording, with its " + kTruthFile +
                      "; expected an estimate: a trajectory, or the folder of a run");
}

void refuse_other_folder(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored) || io::is_bag_input(path, {})) return;
  throw io::ReadError(path.string() + ": is a folder without a " + kTrajectoryFile +
                      "; expected a trajectory, or the folder of a run");
}

/// What an estimate is called: its file without extension, or the run's folder.
std::string name_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path.stem().string();
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// Calls `take` with every line that is no comment, or of names, until it has enough.
template <typename Take>
void for_rows(const fs::path& file, Take&& take) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return;  // its reader says what it is
  std::ifstream stream(file);
  bool first = true;
  for (std::string line; std::getline(stream, line);) {
    if (std::exchange(first, false)) line.erase(0, io::byte_order_mark(line));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos || line[begin] == '#') continue;
    const bool names = std::isalpha(static_cast<unsigned char>(line[begin])) != 0;
    if (!names && !take(line.substr(begin))) return;
  }
}

/// Empty where there is none.
std::string first_row(const fs::path& file) {
  std::string first;
  for_rows(file, [&](std::string row) {
    first = std::move(row);
    return false;
  });
  return first;
}

/// Whether what its rows begin with are whole numbers that are no seconds, as TUM's stamps are.
bool has_whole_times(const fs::path& file) {
  io::WholeTimes times;
  for_rows(file, [&](const std::string& row) {
    times.add(row.substr(0, row.find_first_of(" \t\r,;")));
    return times.all_whole();
  });
  return times.scale().has_value();
}

std::size_t columns_of(const fs::path& file) {
  std::string row = first_row(file);
  std::replace(row.begin(), row.end(), ',', ' ');
  std::istringstream words(row);
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

/// Whether a line names the columns: without the mark of a comment, or w first of the rotation.
bool has_names(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    if (line[begin] != '#') return std::isalpha(static_cast<unsigned char>(line[begin])) != 0;
    if (io::names_w_first(line)) return true;
  }
  return false;
}

bool has_commas(const fs::path& file) { return first_row(file).find(',') != std::string::npos; }

/// By the number of values in the first row: TUM has 8, KITTI 12.
TrajectoryFormat format_of(const fs::path& file) {
  return columns_of(file) == 12 ? TrajectoryFormat::kitti : TrajectoryFormat::tum;
}

/// Whether it is a bag, or a table that is neither TUM's nor KITTI's.
bool is_table(const fs::path& file, bool find_format) {
  std::error_code ignored;
  if (!find_format || !fs::exists(file, ignored)) return false;
  if (io::is_bag_file(file) || fs::is_directory(file, ignored)) return true;
  const std::size_t columns = columns_of(file);
  const bool is_named = columns > 0 && has_names(file);  // else it is a text about something
  return columns == 4 || columns == 9 || columns == 13 || is_named || has_commas(file) ||
         has_whole_times(file);
}

Trajectory read_trajectory(const fs::path& file, TrajectoryFormat format) {
  if (format == TrajectoryFormat::tum) return io::read_tum(file);
  Trajectory trajectory;
  for (const Pose& pose : io::read_kitti_poses(file)) {
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()), pose});
  }
  return trajectory;
}

}  // namespace

fs::path trajectory_file(const fs::path& path) {
  for (const char* name : {kTrajectoryFile, kTruthFile}) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored) && fs::exists(path / name, ignored)) return path / name;
  }
  return path;
}

ReferenceTrajectory read_reference(const ReferenceRequest& request) {
  const io::Dataset* set = request.dataset.empty() ? nullptr : &io::dataset_named(request.dataset);
  const bool of_records = set != nullptr && set->truth == io::TruthOf::oxts;  // a folder of them
  const bool find_format = request.format == TrajectoryFormat::automatic;
  ReferenceTrajectory reference;
  reference.file = of_records ? request.path : trajectory_file(request.path);
  reference.is_foreign = set != nullptr || is_table(reference.file, find_format);
  if (reference.is_foreign) {
    reference.truth = io::read_truth(reference.file, set, request.topic);
    reference.format = reference.truth.has_stamps ? TrajectoryFormat::tum : TrajectoryFormat::kitti;
  } else {
    reference.is_format_given = !find_format;
    reference.format = find_format ? format_of(reference.file) : request.format;
    reference.truth.poses = read_trajectory(reference.file, reference.format);
  }
  return reference;
}

namespace {

/// An estimate that has stamps cannot be paired with a reference that has none.
void refuse_stamped(const fs::path& file, const ReferenceTrajectory& reference) {
  if (reference.format != TrajectoryFormat::kitti || columns_of(file) != 8) return;
  std::error_code ignored;
  const fs::path rows = file.parent_path() / kKittiTrajectoryFile;
  throw io::ReadError(
      file.string() + ": has stamps, and the reference " + reference.file.string() + " has none" +
      (reference.is_foreign ? "" : "; --dataset kitti takes them from its sequence's times.txt") +
      (fs::exists(rows, ignored) ? ", or take " + rows.string() + ", pose by pose" : ""));
}

/// An estimate that is neither TUM's nor KITTI's.
Trajectory read_table(const fs::path& file, const ReferenceTrajectory& reference,
                      const std::string& topic) {
  io::Truth read = io::read_truth(file, nullptr, topic);
  const bool pairs_by_stamps = reference.format == TrajectoryFormat::tum;
  if (pairs_by_stamps && !read.has_stamps) {
    throw io::ReadError(file.string() + ": has no stamps to pair it by; " + read.what);
  }
  if (reference.truth.has_rotations && !read.has_rotations) {
    throw io::ReadError(file.string() + ": has no rotations, which the reference has; " +
                        read.what);
  }
  return std::move(read.poses);
}

}  // namespace

Trajectory read_estimate(const fs::path& path, const ReferenceTrajectory& reference,
                         const std::string& topic) {
  refuse_recording(path);
  const fs::path file = trajectory_file(path);
  refuse_other_folder(file);
  refuse_stamped(file, reference);
  Trajectory estimate = is_table(file, !reference.is_format_given)
                            ? read_table(file, reference, topic)
                            : read_trajectory(file, reference.format);
  if (reference.is_foreign) {
    for (StampedPose& pose : estimate) pose.pose = pose.pose * reference.truth.T_lidar_truth;
  }
  return estimate;
}

std::size_t segments_of(const fs::path& path) {
  const fs::path trajectory = trajectory_file(path);
  if (io::is_bag_file(trajectory)) return 1;
  std::ifstream stream(trajectory);
  std::set<std::string> numbers = {"0"};  // who comes home goes on in an earlier one
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(kSegmentBegins)) continue;
    numbers.insert(line.substr(kSegmentBegins.size(), line.find(':') - kSegmentBegins.size()));
  }
  return numbers.size();
}

std::vector<std::size_t> segment_begins(const fs::path& path) {
  const fs::path trajectory = trajectory_file(path);
  std::vector<std::size_t> begins;
  if (io::is_bag_file(trajectory)) return begins;
  std::ifstream stream(trajectory);
  std::size_t poses = 0;
  bool begun = false;
  for (std::string line; std::getline(stream, line);) {
    begun = begun || line.starts_with(kSegmentBegins);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (std::exchange(begun, false) && poses > 0) begins.push_back(poses);
    ++poses;
  }
  return begins;
}

std::vector<std::string> estimate_names(const std::vector<fs::path>& paths) {
  std::map<std::string, int> uses;
  for (const fs::path& path : paths) ++uses[name_of(path)];
  std::vector<std::string> names;
  for (const fs::path& path : paths) {
    const std::string name = name_of(path);
    names.push_back(text::printable(uses[name] == 1 ? name : path.string()));
  }
  return names;
}

}  // namespace surefoot::runs
