// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/deskew_samples.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "geometry/returns.hpp"
#include "geometry/se3.hpp"
#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/files/ply_writer.hpp"
#include "io/recording.hpp"

namespace surefoot::runs {

using report::DeskewSample;

namespace {

constexpr std::size_t kSamples = 4;
constexpr std::size_t kApart = 10;     // scans between two samples
constexpr std::size_t kPoints = 8000;  // of a sample
constexpr double kArm = 10.0;          // [m] a point that far is moved by a turn so much
constexpr float kLargest = 1e4F;       // [m] farther points are no part of a picture
constexpr std::array kColumns = {"x",          "y",          "z",    "measured_x",
                                 "measured_y", "measured_z", "time", "scan"};

/// How far a point 10 m away is moved by deskewing, at most [m].
double motion_within(const ScanTrajectory& trajectory) {
  const Pose motion = trajectory.boundary(0).inverse() * trajectory.boundary(trajectory.segments());
  return motion.translation.norm() + kArm * turn_angle(motion);
}

bool drawable(const Eigen::Vector3f& point) {
  return is_return(point) && point.cwiseAbs().maxCoeff() < kLargest;
}

DeskewSample sample_of(std::size_t line, const Scan& scan, const Estimate& estimate) {
  DeskewSample sample;
  sample.scan = line;
  const std::size_t stride = scan.points.size() / kPoints + 1;
  for (std::size_t i = 0; i < scan.points.size(); i += stride) {
    if (!drawable(scan.points[i])) continue;
    const Eigen::Vector3d point = scan.points[i].cast<double>();
    const std::int64_t instant = scan.stamp_ns + scan.times_ns[i];
    sample.measured.emplace_back((estimate.T_world_lidar * point).cast<float>());
    sample.deskewed.emplace_back((estimate.pose_at(instant) * point).cast<float>());
    sample.times.push_back(static_cast<float>(estimate.trajectory.tau(instant)));
  }
  return sample;
}

}  // namespace

void DeskewSamples::add(std::size_t line, const Scan& scan, const Estimate& estimate) {
  if (!estimate.trusted() || scan.times_ns.size() != scan.points.size()) return;
  const double motion = motion_within(estimate.trajectory);
  const bool near = !kept_.empty() && line - kept_.back().sample.scan < kApart;
  auto given_up = near ? std::prev(kept_.end()) : kept_.end();
  if (!near && kept_.size() == kSamples) {
    given_up = std::min_element(kept_.begin(), kept_.end(),
                                [](const Kept& a, const Kept& b) { return a.motion < b.motion; });
  }
  if (given_up != kept_.end()) {
    if (motion <= given_up->motion) return;
    kept_.erase(given_up);
  }
  kept_.push_back({motion, sample_of(line, scan, estimate)});
}

std::vector<DeskewSample> DeskewSamples::samples() const {
  std::vector<DeskewSample> samples;
  for (const Kept& kept : kept_) samples.push_back(kept.sample);
  return samples;
}

void write_deskew_samples(const std::filesystem::path& file,
                          const std::vector<DeskewSample>& samples) {
  std::vector<Eigen::Vector3f> points;
  std::array<std::vector<float>, kColumns.size()> columns;
  for (const DeskewSample& sample : samples) {
    points.insert(points.end(), sample.deskewed.begin(), sample.deskewed.end());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Eigen::Vector3f& point : sample.measured) {
        columns[3 + axis].push_back(point[static_cast<Eigen::Index>(axis)]);
      }
    }
    columns[6].insert(columns[6].end(), sample.times.begin(), sample.times.end());
    columns[7].insert(columns[7].end(), sample.times.size(), static_cast<float>(sample.scan));
  }
  std::vector<io::PlyColumn> named;
  for (std::size_t i = 3; i < kColumns.size(); ++i) named.push_back({kColumns[i], columns[i]});
  io::write_ply(file, points, named);
}

std::vector<DeskewSample> read_deskew_samples(const std::filesystem::path& file) {
  try {
    std::vector<std::byte> bytes;
    io::read_whole_file(file, bytes);
    const io::PointTable table = io::parse_ply(bytes);
    std::array<std::vector<float>, kColumns.size()> columns;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const io::Column* column = table.find(kColumns[i]);
      if (column == nullptr) throw io::ReadError(std::string("its points have no ") + kColumns[i]);
      columns[i].resize(table.size);
      io::for_each_value(*column, table.size,
                         [&](std::size_t k, auto value) { columns[i][k] = float(value); });
    }
    std::vector<DeskewSample> samples;
    for (std::size_t k = 0; k < table.size; ++k) {
      const auto scan = static_cast<std::size_t>(std::max(columns[7][k], 0.0F));
      if (samples.empty() || samples.back().scan != scan) samples.push_back({scan, {}, {}, {}});
      samples.back().deskewed.emplace_back(columns[0][k], columns[1][k], columns[2][k]);
      samples.back().measured.emplace_back(columns[3][k], columns[4][k], columns[5][k]);
      samples.back().times.push_back(columns[6][k]);
    }
    return samples;
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

}  // namespace surefoot::runs
