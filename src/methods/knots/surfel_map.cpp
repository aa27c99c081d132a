// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel_map.hpp"

#include <algorithm>
#include <array>

#include "core/prefetch.hpp"

namespace surefoot {

namespace {

// A grid that divides voxels does so no farther from the sensor than so many of its own: beyond, a
// LiDAR's points lie as far apart as they are wide.
constexpr double kReach = 100.0;

// What has too few points for a surfel, and was not hit for so many scans, is no surface.
constexpr std::uint32_t kForgotten = 30;

}  // namespace

SurfelMap::SurfelMap(const Config::Knots& config, double radius)
    : config_(config), radius_(radius) {
  double size = config.finest_voxel;
  for (int level = 0; level < config.levels; ++level, size *= 2.0) {
    grids_.push_back({size, 1.0 / size, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0});
  }
}

/// A question that is not answered yet.
struct SurfelMap::Search {
  const Question* question;
  VoxelIndex index;  // in the grid that is asked
  std::uint64_t key;
  std::uint32_t surfel;
};

/// In rounds, each of which asks memory for what the next one reads: the misses of all searches are
/// waited for together, not one after the other.
void SurfelMap::find_all(std::span<const Question> questions, int finest) const {
  std::array<Search, kAtOnce> searches;
  std::size_t n = 0;
  for (const Question& question : questions) {
    const VoxelIndex index = voxel_index(question.place, grids_[finest].inverse_size);
    if (known(index, question.ray, finest, *question.last)) continue;
    *question.last = {-1, finest, index, nullptr};
    searches[n++] = {&question, index, 0, VoxelTable::kNone};
  }
  for (int level = finest; n > 0 && level < static_cast<int>(grids_.size()); ++level) {
    const Grid& grid = grids_[level];
    for (std::size_t i = 0; i < n; ++i) {
      searches[i].key = voxel_key(searches[i].index);
      grid.table.prefetch(searches[i].key);
    }
    for (std::size_t i = 0; i < n; ++i) {
      searches[i].surfel = grid.table.find_entry(searches[i].key).second;
      if (searches[i].surfel != VoxelTable::kNone) {
        prefetch(grid.surfels[searches[i].surfel], kCacheLine);
      }
    }
    std::size_t open = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (answer(searches[i], level)) continue;
      searches[open] = searches[i];
      searches[open].index = coarser(searches[open].index);
      ++open;
    }
    n = open;
  }
}

/// Of a voxel's surfel and its back's the one that a ray can have hit, or null.
const Surfel* SurfelMap::hit_side(const Grid& grid, std::uint64_t key, const Surfel& front,
                                  const Eigen::Vector3d& ray) {
  if (!front.from_behind(ray)) return &front;
  const std::uint32_t back = grid.table.find_entry(key | kBack).second;
  if (back == VoxelTable::kNone || grid.surfels[back].from_behind(ray)) return nullptr;
  return &grid.surfels[back];
}

/// What a voxel tells of a question; returns whether no coarser one is to be asked.
bool SurfelMap::answer(const Search& search, int level) const {
  if (search.surfel == VoxelTable::kNone) return false;
  const Grid& grid = grids_[level];
  Place& last = *search.question->last;
  const Surfel& front = grid.surfels[search.surfel];
  const Surfel* surfel = hit_side(grid, search.key, front, search.question->ray);
  if (surfel != &front) last.asked = -1;  // the answer depends on the ray, too
  if (surfel == nullptr || surfel->directions == 0) return false;
  if (surfel->cloud() && last.level >= 0) return false;
  last.level = level;
  last.surfel = surfel;
  return !surfel->cloud();
}

const Surfel* SurfelMap::find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray,
                              int finest) const {
  VoxelIndex index = voxel_index(place, grids_[finest].inverse_size);
  const Surfel* cloud = nullptr;
  for (std::size_t level = finest; level < grids_.size(); ++level, index = coarser(index)) {
    const Grid& grid = grids_[level];
    const std::uint64_t key = voxel_key(index);
    const std::uint32_t front = grid.table.find_entry(key).second;
    if (front == VoxelTable::kNone) continue;
    const Surfel* surfel = hit_side(grid, key, grid.surfels[front], ray);
    if (surfel == nullptr || surfel->directions == 0) continue;
    if (!surfel->cloud()) return surfel;
    if (cloud == nullptr) cloud = surfel;
  }
  return cloud;
}

int SurfelMap::level_of(double size) const {
  const auto large = [size](const Grid& grid) { return grid.size >= size; };
  const auto found = std::find_if(grids_.begin(), grids_.end() - 1, large);
  return static_cast<int>(found - grids_.begin());
}

/// [m] from the sensor, what a grid holds.
double SurfelMap::reach_of(const Grid& grid) const {
  const bool dividing = divides() && &grid == &grids_.front();
  return dividing ? std::min(radius_, kReach * grid.size) : radius_;
}

void SurfelMap::empty(Grid& grid, std::uint32_t side) {
  Voxel& voxel = grid.voxels[side];
  voxel.moments = {};
  voxel.fitted_at = 0;
  if (voxel.surfel != VoxelTable::kNone) {
    grid.unused_surfels.push_back(voxel.surfel);
    grid.table.set_second(voxel.key, VoxelTable::kNone);
    voxel.surfel = VoxelTable::kNone;
  }
  grid.sights[side] = {};
}

void SurfelMap::drop(Grid& grid, std::uint32_t side) {
  empty(grid, side);
  grid.table.erase(grid.voxels[side].key);
  grid.voxels[side].in_use = false;
  grid.unused.push_back(side);
}

void SurfelMap::remove_far(const Eigen::Vector3d& sensor) {
  for (Grid& grid : grids_) {
    const double reach = reach_of(grid);
    const std::size_t sides = grid.voxels.size();
    const std::size_t part = (sides + kRound - 1) / kRound;
    for (std::size_t i = 0; i < part; ++i, ++grid.next) {
      if (grid.next >= sides) grid.next = 0;
      const Voxel& voxel = grid.voxels[grid.next];
      if (!voxel.in_use) continue;
      const bool far = (middle_of(voxel.index, grid.size) - sensor).norm() > reach;
      const bool forgotten =
          voxel.surfel == VoxelTable::kNone && scan_ - grid.sights[grid.next].last_hit > kForgotten;
      const bool gone = far || forgotten || voxel.moments.count() == 0;
      if (gone) drop(grid, static_cast<std::uint32_t>(grid.next));
    }
  }
}

void SurfelMap::clear() {
  for (Grid& grid : grids_) {
    grid.table.clear();
    grid.surfels.clear();
    grid.unused_surfels.clear();
    grid.voxels.clear();
    grid.sights.clear();
    grid.stale.clear();
    grid.poles.clear();
    grid.passed.clear();
    grid.unused.clear();
    grid.next = 0;
  }
}

std::vector<Eigen::Vector3d> SurfelMap::points() const {
  std::vector<Eigen::Vector3d> means;
  const Grid& grid = grids_[finest_whole()];
  means.reserve(grid.voxels.size());
  for (std::size_t at = 0; at < grid.voxels.size(); ++at) {
    const Voxel& voxel = grid.voxels[at];
    if (voxel.moments.count() == 0) continue;
    means.emplace_back(middle_of(voxel.index, grid.size) + voxel.moments.mean());
  }
  return means;
}

}  // namespace surefoot
