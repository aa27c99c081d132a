// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_sampling.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "methods/shared/cell_downsample.hpp"

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr std::size_t kPointsPerExpectedCell = 4;

/// A shell about the sensor, and the cells that it is thinned with [m].
struct Shell {
  double inner, outer, cell;
};
constexpr std::array<Shell, 5> kShells = {
    {{0.5, 2.0, 0.1}, {2.0, 4.0, 0.2}, {4.0, 8.0, 0.4}, {8.0, 16.0, 0.8}, {16.0, 200.0, 1.6}}};

/// The hash of the original's tables: decides in which order the thinned points come.
struct CtIcpHash {
  std::size_t operator()(const VoxelIndex& cell) const {
    const auto unsigned_of = [](int index) { return static_cast<std::size_t>(index); };
    return unsigned_of(cell.x()) * 73856093U + unsigned_of(cell.y()) * 19349669U +
           unsigned_of(cell.z()) * 83492791U;
  }
};
std::uint32_t short_hash(const VoxelIndex& cell) {
  return static_cast<std::uint32_t>(CtIcpHash{}(cell));
}

std::vector<CtIcpPoint> one_of_each_cell(const std::vector<CtIcpPoint>& points, double size,
                                         CellRounding rounding) {
  std::vector<Eigen::Vector3d> coordinates;
  coordinates.reserve(points.size());
  for (const CtIcpPoint& point : points) coordinates.push_back(point.point);
  std::vector<CtIcpPoint> first;
  for (const std::uint32_t i : first_of_cells(coordinates, size, rounding, short_hash,
                                              points.size() / kPointsPerExpectedCell)) {
    first.push_back(points[i]);
  }
  return first;
}

}  // namespace

CellRounding cell_rounding(const CtIcpParameters& config) {
  return config.floor_voxels ? CellRounding::down : CellRounding::to_zero;
}

std::vector<CtIcpPoint> CtIcpSampler::thin(const PreparedScan& scan, bool rigid, double size) {
  rigid = rigid || scan.taus.empty();
  std::vector<CtIcpPoint> points;
  points.reserve(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    points.push_back(
        {scan.points[i].cast<double>(), rigid ? 1.0 : static_cast<double>(scan.taus[i])});
  }
  std::shuffle(points.begin(), points.end(), random_);
  points = one_of_each_cell(points, size, cell_rounding(config_));
  std::shuffle(points.begin(), points.end(), random_);
  return points;
}

std::vector<CtIcpPoint> CtIcpSampler::keypoints(const std::vector<CtIcpPoint>& points, double size,
                                                bool limited) {
  std::vector<CtIcpPoint> picked;
  switch (config_.sampling) {
    case CtIcpSampling::none:
      picked = points;
      break;
    case CtIcpSampling::grid:
      picked = one_of_each_cell(points, size, cell_rounding(config_));
      break;
    case CtIcpSampling::adaptive:
      for (const std::size_t i : adaptive_sample(points, cell_rounding(config_))) {
        picked.push_back(points[i]);
      }
      break;
  }
  const int most = config_.max_num_keypoints;
  if (limited && most > 0 && picked.size() > static_cast<std::size_t>(most)) {
    std::shuffle(picked.begin(), picked.end(), random_);
    picked.resize(static_cast<std::size_t>(most));
  }
  return picked;
}

std::vector<std::size_t> adaptive_sample(const std::vector<CtIcpPoint>& points,
                                         CellRounding rounding) {
  // The order in which the library's tables walk over their cells decides, as in the original,
  // which points are registered if their number is limited.
  std::array<std::unordered_map<VoxelIndex, std::size_t, CtIcpHash>, kShells.size()> first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double range = points[i].point.norm();
    if (range < kShells.front().inner || range >= kShells.back().outer) continue;
    std::size_t shell = 0;
    while (range > kShells[shell].outer) ++shell;
    first[shell].try_emplace(cell_index(points[i].point, kShells[shell].cell, rounding), i);
  }
  std::vector<std::size_t> picked;
  for (const auto& cells : first) {
    for (const auto& [cell, index] : cells) picked.push_back(index);
  }
  return picked;
}

}  // namespace surefoot
