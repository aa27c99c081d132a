// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_builder.hpp"

#include <algorithm>
#include <utility>

#include "surefoot/seconds.hpp"

namespace surefoot::mapping {

namespace {

// Points whose cubes were emptied and are taken again: fewer are not worth the time to drop them.
constexpr std::size_t kFewReplaced = 20'000;

}  // namespace

bool MapBuilder::forgotten(const Frame& frame, std::size_t point) const {
  if (frame.emptied.empty()) return false;
  const auto found =
      frame.emptied.find(voxel_key(voxel_index(points_[point].cast<double>(), inverse_side_)));
  return found != frame.emptied.end() && first_seen_[point] < found->second;
}

template <typename Use>
void MapBuilder::for_points(const Use& use) const {
  for (std::size_t s = 0; s < scans_.size(); ++s) {
    const std::size_t end = s + 1 < scans_.size() ? scans_[s + 1].first_point : points_.size();
    for (std::size_t i = scans_[s].first_point; i < end; ++i) use(i, scans_[s]);
  }
}

void MapBuilder::add(const DeskewedScan& scan, const Pose& T_world_lidar, const When& when) {
  const Eigen::Matrix3d R = T_world_lidar.rotation.toRotationMatrix();
  if (scan.intensities.empty()) {
    has_intensities_ = false;
    intensities_.clear();
  }
  Frame& frame = frames_[when.frame];
  scans_.push_back({points_.size(), when});
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = R * scan.points[i].cast<double>() + T_world_lidar.translation;
    const auto next = static_cast<std::uint32_t>(points_.size());
    std::uint32_t& taken_by = frame.taken.at(voxel_index(point, inverse_voxel_));
    if (taken_by != CubeTable::kNone) {
      if (!forgotten(frame, taken_by)) continue;
      ++replaced_;
    }
    taken_by = next;
    points_.emplace_back(point.cast<float>());
    first_seen_.push_back(static_cast<float>(seconds(when.after_ns)));
    if (has_intensities_) intensities_.push_back(scan.intensities[i]);
  }
  if (scans_.back().first_point == points_.size()) scans_.pop_back();
  if (replaced_ > std::max(kFewReplaced, points_.size() / 2)) drop_forgotten();
}

/// Who stands where people walk sees the same cubes again and again.
void MapBuilder::drop_forgotten() {
  std::vector<std::uint32_t> place(points_.size(), CubeTable::kNone);
  std::uint32_t kept = 0;
  for_points([&](std::size_t i, const Scan& scan) {
    if (!forgotten(frames_.at(scan.when.frame), i)) place[i] = kept++;
  });
  MapBuilder left = without_forgotten();
  points_ = std::move(left.points_);
  intensities_ = std::move(left.intensities_);
  first_seen_ = std::move(left.first_seen_);
  scans_ = std::move(left.scans_);
  for (auto& [number, frame] : frames_) {
    frame.taken.for_all([&](std::uint32_t& point) {
      if (point != CubeTable::kNone) point = place[point];
    });
  }
  replaced_ = 0;
}

void MapBuilder::forget(const Cubes& cubes, const When& when) {
  if (cubes.centres.empty()) return;
  inverse_side_ = 1.0 / cubes.side;
  Frame& frame = frames_[when.frame];
  for (const Eigen::Vector3d& centre : cubes.centres) {
    frame.emptied[voxel_key(voxel_index(centre, inverse_side_))] =
        static_cast<float>(seconds(when.after_ns));
  }
}

MapBuilder MapBuilder::corrected(
    const std::function<std::optional<Correction>(std::int64_t after_ns)>& correction) const {
  MapBuilder moved(voxel_);
  moved.has_intensities_ = has_intensities_;
  const Scan* asked = nullptr;
  std::optional<Correction> by;
  Frame* frame = nullptr;
  for_points([&](std::size_t i, const Scan& scan) {
    if (&scan != asked) {
      asked = &scan;
      by = correction(scan.when.after_ns);
      if (by) {
        frame = &moved.frames_[by->frame];
        moved.scans_.push_back({moved.points_.size(), {scan.when.after_ns, by->frame}});
      }
    }
    if (!by) return;
    const Eigen::Vector3d point = by->pose * points_[i].cast<double>();
    std::uint32_t& taken_by = frame->taken.at(voxel_index(point, inverse_voxel_));
    if (taken_by != CubeTable::kNone) return;
    taken_by = static_cast<std::uint32_t>(moved.points_.size());
    moved.points_.emplace_back(point.cast<float>());
    moved.first_seen_.push_back(first_seen_[i]);
    if (has_intensities_) moved.intensities_.push_back(intensities_[i]);
  });
  return moved;
}

MapBuilder MapBuilder::without_forgotten() const {
  MapBuilder left(voxel_);
  left.has_intensities_ = has_intensities_;
  const Scan* last = nullptr;
  for_points([&](std::size_t i, const Scan& scan) {
    if (forgotten(frames_.at(scan.when.frame), i)) return;
    if (&scan != last) left.scans_.push_back({left.points_.size(), scan.when});
    last = &scan;
    left.points_.push_back(points_[i]);
    left.first_seen_.push_back(first_seen_[i]);
    if (has_intensities_) left.intensities_.push_back(intensities_[i]);
  });
  return left;
}

std::vector<std::int64_t> MapBuilder::first_seen_ns() const {
  std::vector<std::int64_t> times;
  times.reserve(points_.size());
  for_points([&](std::size_t, const Scan& scan) { times.push_back(scan.when.after_ns); });
  return times;
}

}  // namespace surefoot::mapping
