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

// Who sees a plane at a smaller angle than this (sine) may be on either side of it.
constexpr double kGrazing = 0.05;

bool from_behind(const Surfel& surfel, const Eigen::Vector3d& ray) {
  if (surfel.directions != 1) return false;
  const double along = surfel.across[0].dot(ray);
  return along > 0.0 && along * along > kGrazing * kGrazing * ray.squaredNorm();
}

/// The key of a voxel's back: voxel_key() leaves the first bit free.
std::uint64_t back_of(std::uint64_t key) { return key | std::uint64_t{1} << 63; }

Products products_of(const Eigen::Vector3d& v) {
  return (Products() << v.x() * v.x(), v.x() * v.y(), v.x() * v.z(), v.y() * v.y(), v.y() * v.z(),
          v.z() * v.z())
      .finished();
}

Eigen::Matrix3d matrix_of(const Products& p) {
  return (Eigen::Matrix3d() << p[0], p[1], p[2], p[1], p[3], p[4], p[2], p[4], p[5]).finished();
}

}  // namespace

SurfelMap::SurfelMap(const Config::Knots& config, double radius)
    : config_(config), radius_(radius) {
  double size = config.finest_voxel;
  for (int level = 0; level < config.levels; ++level, size *= 2.0) {
    grids_.push_back({size, 1.0 / size, {}, {}, {}, {}, {}});
  }
}

const Surfel* SurfelMap::find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray, int finest,
                              Place& last) const {
  const VoxelIndex index = voxel_index(place, grids_[finest].inverse_size);
  if (last.asked == finest && last.voxel == index) {
    if (last.level < 0) return nullptr;
    const Surfel& surfel = grids_[last.level].surfels[last.index];
    if (!from_behind(surfel, ray)) return &surfel;
  }
  last = {-1, finest, index, 0};
  for (int level = finest; level < static_cast<int>(grids_.size()); ++level) {
    const Grid& grid = grids_[level];
    const std::uint64_t key = voxel_key(voxel_index(place, grid.inverse_size));
    std::uint32_t found = grid.table.find(key);
    if (found == VoxelTable::kNone) continue;
    if (from_behind(grid.surfels[found], ray)) {
      last.asked = -1;  // the answer depends on the ray, too
      found = grid.table.find(back_of(key));
      if (found == VoxelTable::kNone || from_behind(grid.surfels[found], ray)) continue;
    }
    if (grid.surfels[found].directions == 0) continue;
    last.level = level;
    last.index = found;
    return &grid.surfels[found];
  }
  return nullptr;
}

int SurfelMap::level_of(double size) const {
  const auto large = [size](const Grid& grid) { return grid.size >= size; };
  const auto found = std::find_if(grids_.begin(), grids_.end() - 1, large);
  return static_cast<int>(found - grids_.begin());
}

/// The side of a voxel that a ray hits, made if there is none yet.
std::uint32_t SurfelMap::side_of(Grid& grid, const VoxelIndex& index, const Eigen::Vector3d& ray) {
  const auto side = [&grid, &index](std::uint64_t key) {
    const auto next = static_cast<std::uint32_t>(grid.moments.size());
    const auto [at, inserted] = grid.table.find_or_insert(key, next);
    if (inserted) {
      grid.surfels.emplace_back();
      Moments& fresh = grid.moments.emplace_back();
      fresh.key = key;
      fresh.index = index;
      grid.full.push_back(false);
    }
    return at;
  };
  const std::uint32_t front = side(voxel_key(index));
  return from_behind(grid.surfels[front], ray) ? side(back_of(voxel_key(index))) : front;
}

void SurfelMap::add(Grid& grid, const Eigen::Vector3d& point, const Eigen::Vector3d& ray) const {
  const VoxelIndex index = voxel_index(point, grid.inverse_size);
  const std::uint32_t at = side_of(grid, index, ray);
  if (grid.full[at]) return;
  Moments& voxel = grid.moments[at];
  const Eigen::Vector3d local = point - index.cast<double>() * grid.size;
  ++voxel.count;
  voxel.sum += local;
  voxel.products += products_of(local);
  voxel.ray_sum += ray;
  voxel.rays += products_of(ray);
  grid.full[at] = voxel.count >= config_.points_per_voxel;  // what was seen first is kept: no drift
  if (!voxel.stale && voxel.count >= kGrowth * voxel.fitted_at) {
    voxel.stale = true;
    grid.stale.push_back(at);
  }
}

void SurfelMap::insert(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& sensor,
                       const Workers& workers) {
  std::vector<Eigen::Vector3d> rays;
  rays.reserve(points.size());
  for (const Eigen::Vector3d& point : points) rays.push_back((point - sensor).normalized());
  workers.for_each(grids_.size(), [&](std::size_t level) {
    Grid& grid = grids_[level];
    for (std::size_t i = 0; i < points.size(); ++i) add(grid, points[i], rays[i]);
    for (const std::uint32_t at : grid.stale) {
      Moments& voxel = grid.moments[at];
      grid.surfels[at] = fit(voxel, grid.size);
      voxel.stale = false;
      voxel.fitted_at = voxel.count;
    }
    grid.stale.clear();
  });
}

Surfel SurfelMap::fit(const Moments& moments, double size) const {
  Surfel surfel;
  if (moments.count < config_.min_points) return surfel;
  const Eigen::Vector3d mean = moments.sum / moments.count;
  const Eigen::Matrix3d C = matrix_of(moments.products) / moments.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(C);
  const Eigen::Vector3d spread = eigen.eigenvalues().cwiseMax(0.0);
  const double broad = config_.breadth * config_.breadth * size * size;
  // A ring that passes through foliage, or whose ranges are noisy, spreads along its rays: its
  // points lie on the plane that the rays sweep, which goes with the sensor.
  const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  const double facing = normal.dot(matrix_of(moments.rays) * normal) / moments.count;
  const bool plane = spread[1] >= broad && spread[0] <= config_.flatness * spread[1] &&
                     facing >= config_.edge_on * config_.edge_on;
  const bool pole = !plane && moments.count >= 2 * config_.min_points && spread[2] >= broad &&
                    spread[1] <= config_.slenderness * spread[2] &&
                    std::abs(eigen.eigenvectors()(2, 2)) >= kStanding;
  surfel.directions = plane ? 1 : pole ? 2 : 0;
  surfel.mean = mean + moments.index.cast<double>() * size;
  for (int i = 0; i < 2; ++i) {
    surfel.across[i] = eigen.eigenvectors().col(i);
    surfel.variance[i] = spread[i];
  }
  if (surfel.across[0].dot(moments.ray_sum) > 0.0) surfel.across[0] *= -1.0;
  return surfel;
}

void SurfelMap::remove_far(const Eigen::Vector3d& sensor) {
  if (!cleaned_at_) cleaned_at_ = sensor;
  if ((sensor - *cleaned_at_).norm() < kCleaningShare * radius_) return;
  cleaned_at_ = sensor;
  for (Grid& grid : grids_) {
    std::uint32_t kept = 0;
    grid.table.clear();
    for (std::size_t at = 0; at < grid.moments.size(); ++at) {
      const Moments& voxel = grid.moments[at];
      const Eigen::Vector3d centre = (voxel.index.cast<double>().array() + 0.5) * grid.size;
      if ((centre - sensor).norm() > radius_) continue;
      grid.table.find_or_insert(voxel.key, kept);
      grid.moments[kept] = voxel;
      grid.surfels[kept] = grid.surfels[at];
      grid.full[kept] = grid.full[at];
      ++kept;
    }
    grid.moments.resize(kept);
    grid.surfels.resize(kept);
    grid.full.resize(kept);
  }
}

void SurfelMap::clear() {
  for (Grid& grid : grids_) {
    grid.table.clear();
    grid.surfels.clear();
    grid.moments.clear();
    grid.full.clear();
    grid.stale.clear();
  }
  cleaned_at_.reset();
}

std::vector<Eigen::Vector3d> SurfelMap::points() const {
  const Grid& grid = grids_.front();
  std::vector<Eigen::Vector3d> means;
  means.reserve(grid.moments.size());
  for (const Moments& voxel : grid.moments) {
    means.emplace_back(voxel.index.cast<double>() * grid.size + voxel.sum / voxel.count);
  }
  return means;
}

}  // namespace surefoot
