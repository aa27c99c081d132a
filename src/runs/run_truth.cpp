// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "io/bags/bag_files.hpp"
#include "io/decimal_time.hpp"
#include "io/recording.hpp"
#include "runs/trajectory_inputs.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kTruthPoses = 8000;  // drawn at most; truth comes at hundreds of hertz

}  // namespace

fs::path truth_beside(const fs::path& input) {
  std::error_code ignored;
  if (!fs::exists(input, ignored)) return {};  // the name of what is running
  const fs::path folder = fs::is_directory(input, ignored) ? input : input.parent_path();
  if (fs::path file = folder / kTruthFile; fs::is_regular_file(file, ignored)) return file;
  if (!io::is_rosbag2_folder(folder)) return {};
  const fs::path bag = fs::absolute(folder / "").lexically_normal().parent_path();
  fs::path file = bag.parent_path() / kTruthFile;
  return fs::is_regular_file(file, ignored) ? file : fs::path{};
}

fs::path truth_file(const RunOptions& options) {
  if (!options.truth.empty()) return options.truth;
  return options.pose_of == "lidar" ? truth_beside(options.input) : fs::path{};
}

Trajectory read_truth_poses(const fs::path& file) {
  ReferenceTrajectory read = read_reference({file, {}, {}});
  const bool has_stamps = read.truth.has_stamps && read.format != TrajectoryFormat::kitti;
  if (has_stamps && read.truth.has_rotations) return std::move(read.truth.poses);
  throw io::ReadError(file.string() + ": has no " + (has_stamps ? "rotations" : "stamps") +
                      "; expected a truth with both, or surefoot eval, which can do without");
}

evaluation::AssociationOptions pairing_with(const Trajectory& truth, const Trajectory& measured) {
  using evaluation::AssociationMethod;
  evaluation::AssociationOptions pairing;
  const auto pairs = [&](AssociationMethod method) -> std::size_t {
    pairing.method = method;
    try {
      return evaluation::associate(truth, measured, pairing).estimate.size();
    } catch (const std::runtime_error&) {
      return 0;
    }
  };
  // At either end one more may have a neighbour than lies between two poses.
  const std::size_t near = pairs(AssociationMethod::nearest);
  const std::size_t between = pairs(AssociationMethod::interpolate);
  if (2 * between < near) pairing.method = AssociationMethod::nearest;
  return pairing;
}

std::string other_times(const fs::path& file, const Trajectory& truth, std::int64_t first_ns,
                        std::int64_t last_ns) {
  if (truth.empty()) return file.string() + ": holds no poses";
  const auto [begin, end] = std::minmax_element(
      truth.begin(), truth.end(),
      [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
  if (begin->stamp_ns <= last_ns && end->stamp_ns >= first_ns) return {};
  return fmt::format(
      "{}: tells of {} to {} s, and the scans are of {} to {} s: they have no time in common, so "
      "nothing is compared",
      file.string(), io::format_seconds(begin->stamp_ns), io::format_seconds(end->stamp_ns),
      io::format_seconds(first_ns), io::format_seconds(last_ns));
}

Pose laid_on_truth(const evaluation::AssociatedTrajectories& pairs) {
  return find_alignment(pairs, evaluation::AlignmentMethod::poses).pose;
}

Trajectory truth_between(const Trajectory& truth, std::int64_t first_ns, std::int64_t last_ns) {
  Trajectory part;
  for (const StampedPose& pose : truth) {
    if (pose.stamp_ns >= first_ns && pose.stamp_ns <= last_ns) part.push_back(pose);
  }
  const std::size_t stride = part.size() / kTruthPoses + 1;
  Trajectory thinned;
  for (std::size_t i = 0; i < part.size(); i += stride) thinned.push_back(part[i]);
  return thinned;
}

Trajectory truth_in_map(const Trajectory& truth, const Trajectory& measured,
                        const report::DrawnLoops& loops) {
  if (truth.empty() || measured.empty()) return {};
  try {
    const Trajectory& way = loops.taken.empty() ? measured : loops.corrected;
    const Pose T_map_world =
        laid_on_truth(evaluation::associate(truth, way, pairing_with(truth, way))).inverse();
    Trajectory seen = truth_between(truth, measured.front().stamp_ns, measured.back().stamp_ns);
    for (StampedPose& pose : seen) pose.pose = T_map_world * pose.pose;
    return seen;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace surefoot::runs
