// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/surfel_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// The map is cleaned when the sensor went this share of the radius, not at every scan.
constexpr double kCleaningShare = 0.05;

// A surfel is fitted anew when its points grew by this share.
constexpr double kGrowth = 1.15;

// A pole stands: its axis is within 45 deg of the map's z axis. A lying line is one ring of the
// LiDAR on a wall or floor, whose place along that surface says nothing.
constexpr double kStanding = 0.7;

}  // namespace

SurfelMap::SurfelMap(const Config::Knots& config, double radius)
    : config_(config), radius_(radius) {
  double size = config.finest_voxel;
  for (int level = 0; level < config.levels; ++level, size *= 2.0) {
    grids_.push_back({size, 1.0 / size, {}, {}, {}});
  }
}

const Surfel* SurfelMap::find(const Eigen::Vector3d& place, int finest, Place& last) const {
  const VoxelIndex index = voxel_index(place, grids_[finest].inverse_size);
  if (last.asked == finest && last.voxel == index) {
    return last.level < 0 ? nullptr : &grids_[last.level].voxels[last.index].surfel;
  }
  last = {-1, finest, index, 0};
  for (int level = finest; level < static_cast<int>(grids_.size()); ++level) {
    const Grid& grid = grids_[level];
    const std::uint32_t found = grid.table.find(voxel_key(voxel_index(place, grid.inverse_size)));
    if (found == VoxelTable::kNone || grid.voxels[found].surfel.directions == 0) continue;
    last.level = level;
    last.index = found;
    return &grid.voxels[found].surfel;
  }
  return nullptr;
}

int SurfelMap::level_of(double size) const {
  const auto large = [size](const Grid& grid) { return grid.size >= size; };
  const auto found = std::find_if(grids_.begin(), grids_.end() - 1, large);
  return static_cast<int>(found - grids_.begin());
}

void SurfelMap::add(Grid& grid, const Eigen::Vector3d& point, const Eigen::Vector3d& ray) const {
  const VoxelIndex index = voxel_index(point, grid.inverse_size);
  const auto next = static_cast<std::uint32_t>(grid.voxels.size());
  const auto [at, inserted] = grid.table.find_or_insert(voxel_key(index), next);
  if (inserted) {
    grid.voxels.emplace_back();
    grid.voxels.back().index = index;
  }
  Voxel& voxel = grid.voxels[at];
  if (voxel.count >= config_.points_per_voxel) return;  // what was seen first is kept: no drift
  const Eigen::Vector3d local = point - index.cast<double>() * grid.size;
  ++voxel.count;
  voxel.sum += local;
  voxel.products += local * local.transpose();
  voxel.rays += ray * ray.transpose();
  if (!voxel.stale && voxel.count >= kGrowth * voxel.fitted_at) {
    voxel.stale = true;
    grid.stale.push_back(at);
  }
}

void SurfelMap::insert(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& sensor) {
  for (Grid& grid : grids_) {
    for (const Eigen::Vector3d& point : points) add(grid, point, (point - sensor).normalized());
    for (const std::uint32_t at : grid.stale) fit(grid.voxels[at], grid.size);
    grid.stale.clear();
  }
}

void SurfelMap::fit(Voxel& voxel, double size) const {
  voxel.stale = false;
  voxel.fitted_at = voxel.count;
  voxel.surfel.directions = 0;
  if (voxel.count < config_.min_points) return;
  const Eigen::Vector3d mean = voxel.sum / voxel.count;
  const Eigen::Matrix3d C = voxel.products / voxel.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(C);
  const Eigen::Vector3d spread = eigen.eigenvalues().cwiseMax(0.0);
  const double broad = config_.breadth * config_.breadth * size * size;
  // A ring that passes through foliage, or whose ranges are noisy, spreads along its rays: its
  // points lie on the plane that the rays sweep, which goes with the sensor.
  const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  const double facing = normal.dot(voxel.rays * normal) / voxel.count;
  const bool plane = spread[1] >= broad && spread[0] <= config_.flatness * spread[1] &&
                     facing >= config_.edge_on * config_.edge_on;
  const bool pole = !plane && voxel.count >= 2 * config_.min_points && spread[2] >= broad &&
                    spread[1] <= config_.slenderness * spread[2] &&
                    std::abs(eigen.eigenvectors()(2, 2)) >= kStanding;
  voxel.surfel.directions = plane ? 1 : pole ? 2 : 0;
  voxel.surfel.mean = mean + voxel.index.cast<double>() * size;
  for (int i = 0; i < 2; ++i) {
    voxel.surfel.across[i] = eigen.eigenvectors().col(i);
    voxel.surfel.variance[i] = spread[i];
  }
}

void SurfelMap::remove_far(const Eigen::Vector3d& sensor) {
  if (!cleaned_at_) cleaned_at_ = sensor;
  if ((sensor - *cleaned_at_).norm() < kCleaningShare * radius_) return;
  cleaned_at_ = sensor;
  for (Grid& grid : grids_) {
    const auto far = [&](const Voxel& voxel) {
      const Eigen::Vector3d centre = (voxel.index.cast<double>().array() + 0.5) * grid.size;
      return (centre - sensor).norm() > radius_;
    };
    grid.voxels.erase(std::remove_if(grid.voxels.begin(), grid.voxels.end(), far),
                      grid.voxels.end());
    grid.table.clear();
    for (std::uint32_t at = 0; at < grid.voxels.size(); ++at) {
      grid.table.find_or_insert(voxel_key(grid.voxels[at].index), at);
    }
  }
}

void SurfelMap::clear() {
  for (Grid& grid : grids_) {
    grid.voxels.clear();
    grid.table.clear();
    grid.stale.clear();
  }
  cleaned_at_.reset();
}

std::vector<Eigen::Vector3d> SurfelMap::points() const {
  const Grid& grid = grids_.front();
  std::vector<Eigen::Vector3d> means;
  means.reserve(grid.voxels.size());
  for (const Voxel& voxel : grid.voxels) {
    means.push_back(voxel.index.cast<double>() * grid.size + voxel.sum / voxel.count);
  }
  return means;
}

}  // namespace surefoot
