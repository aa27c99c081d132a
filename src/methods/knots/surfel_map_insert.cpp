// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A scan enters the map: its points, and what its beams say of what is there.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/prefetch.hpp"
#include "methods/knots/surfel_map.hpp"

namespace surefoot {

namespace {

// A surfel is fitted anew when its points grew by this factor, not at every point: to save time.
constexpr double kGrowth = 1.3;

// What no beam is known to have gone through is asked for at every so many-th scan only, so many
// sides, which lie together, as one.
constexpr std::size_t kTurn = 3, kBlock = 64;

// So many points ahead, memory is asked for what the map knows of them: they lie all over it.
constexpr std::size_t kAhead = 20;

// A pole on a wall is no farther from it than so many standard deviations of the wall's points, and
// so much askew to it at most (sine).
constexpr double kOnWall = 2.0, kAskew = 0.2;

// Scans that are counted: what fits Sight's 16 bits.
constexpr int kMost = 60'000;

}  // namespace

struct SurfelMap::Sweep {
  Sweep(const View& of, double inverse_finest_size) : view(of) {
    indices.reserve(view.points.size());
    for (const Eigen::Vector3d& point : view.points) {
      indices.push_back(voxel_index(point, inverse_finest_size));
    }
  }

  /// Of the voxel of a level's grid that a point lies in.
  [[nodiscard]] VoxelIndex index(std::uint32_t point, std::size_t level) const {
    const VoxelIndex& finest = indices[point];
    return {finest.x() >> level, finest.y() >> level, finest.z() >> level};
  }

  const View& view;
  std::vector<VoxelIndex> indices;  // in the finest grid
};

/// A voxel, or its back, of which there is none yet.
std::uint32_t SurfelMap::make_side(Grid& grid, std::uint64_t key, const VoxelIndex& index) {
  auto side = static_cast<std::uint32_t>(grid.voxels.size());
  if (grid.unused.empty()) {
    grid.voxels.add();
    grid.sights.emplace_back();
  } else {
    side = grid.unused.back();
    grid.unused.pop_back();
  }
  grid.table.find_or_insert(key, side);
  Voxel& fresh = grid.voxels[side];
  fresh.key = key;
  fresh.index = index;
  fresh.in_use = true;
  return side;
}

/// And which is its surfel, if it has one.
VoxelTable::Entry SurfelMap::side_of(Grid& grid, std::uint64_t key, const VoxelIndex& index) {
  const VoxelTable::Entry found = grid.table.find_entry(key);
  if (found.index != VoxelTable::kNone) return found;
  return {make_side(grid, key, index), VoxelTable::kNone};
}

/// Of a voxel that has enough points for one.
Surfel& SurfelMap::surfel_of(Grid& grid, Voxel& voxel) {
  if (voxel.surfel != VoxelTable::kNone) return grid.surfels[voxel.surfel];
  voxel.surfel = static_cast<std::uint32_t>(grid.surfels.size());
  if (grid.unused_surfels.empty()) {
    grid.surfels.add();
  } else {
    voxel.surfel = grid.unused_surfels.back();
    grid.unused_surfels.pop_back();
  }
  grid.table.set_second(voxel.key, voxel.surfel);
  return grid.surfels[voxel.surfel];
}

/// Those of a scan's points that enter a grid.
std::vector<std::uint32_t> SurfelMap::taken_by(std::size_t level, const Sweep& sweep) const {
  std::vector<std::uint32_t> taken(sweep.indices.size());
  std::iota(taken.begin(), taken.end(), 0U);
  if (level >= finest_whole()) return taken;
  const double reach = reach_of(grids_[level]);
  const std::vector<double>& ranges = sweep.view.sighting.ranges;
  std::erase_if(taken, [&](std::uint32_t i) { return ranges[i] > reach; });
  leave_undivided(level + 1, sweep, taken);
  return taken;
}

/// Drops the points in whose voxels of a level are too few.
void SurfelMap::leave_undivided(std::size_t level, const Sweep& sweep,
                                std::vector<std::uint32_t>& taken) const {
  const Grid& grid = grids_[level];
  const std::size_t n = taken.size();
  std::vector<std::uint64_t> keys(n);
  for (std::size_t i = 0; i < n; ++i) keys[i] = voxel_key(sweep.index(taken[i], level));
  std::vector<std::uint32_t> voxels(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i + kAhead < n) grid.table.prefetch(keys[i + kAhead]);
    voxels[i] = grid.table.find(keys[i]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (i + kAhead < n && voxels[i + kAhead] != VoxelTable::kNone) {
      prefetch(grid.voxels[voxels[i + kAhead]]);
    }
    if (voxels[i] == VoxelTable::kNone) continue;
    if (grid.voxels[voxels[i]].moments.count() >= config_.divided_at) taken[kept++] = taken[i];
  }
  taken.resize(kept);
}

/// A voxel takes all of a scan's points or none, so that their order is no matter.
void SurfelMap::add(std::size_t level, const Sweep& sweep,
                    const std::vector<std::uint32_t>& taken) {
  Grid& grid = grids_[level];
  const auto& [rays, ranges] = sweep.view.sighting;
  const std::size_t n = taken.size();
  std::vector<VoxelIndex> indices(n);
  std::vector<std::uint64_t> keys(n);
  for (std::size_t i = 0; i < n; ++i) {
    indices[i] = sweep.index(taken[i], level);
    keys[i] = voxel_key(indices[i]);
  }
  std::vector<VoxelTable::Entry> sides(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i + kAhead < n) grid.table.prefetch(keys[i + kAhead]);
    sides[i] = side_of(grid, keys[i], indices[i]);
  }
  std::vector<std::uint32_t> filled;
  for (std::size_t i = 0; i < n; ++i) {
    if (i + 2 * kAhead < n) {
      const VoxelTable::Entry& ahead = sides[i + 2 * kAhead];
      if (ahead.second != VoxelTable::kNone) prefetch(grid.surfels[ahead.second], kCacheLine);
      prefetch(grid.sights[ahead.index]);
    }
    if (i + kAhead < n && !grid.sights[sides[i + kAhead].index].full) {
      prefetch(grid.voxels[sides[i + kAhead].index]);
    }
    const std::uint32_t point = taken[i];
    auto [side, surfel] = sides[i];
    if (surfel != VoxelTable::kNone && grid.surfels[surfel].from_behind(rays[point])) {
      side = side_of(grid, keys[i] | kBack, indices[i]).index;
    }
    Sight& sight = grid.sights[side];
    note_hit(sight);
    if (sight.full) continue;
    Voxel& voxel = grid.voxels[side];
    const Eigen::Vector3d middle = middle_of(indices[i], grid.size);
    const Eigen::Vector3d place = sweep.view.points[point] - middle;
    voxel.moments.add(place.cast<float>(), rays[point].cast<float>(),
                      static_cast<float>(ranges[point]));
    const int count = voxel.moments.count();
    if (count == config_.points_per_voxel) filled.push_back(side);
    if (count < config_.min_points) {  // too few for a surfel
      sight.middle = (middle + voxel.moments.mean()).cast<float>();
    } else if (!voxel.stale && count >= kGrowth * voxel.fitted_at) {
      voxel.stale = true;
      grid.stale.push_back(side);
    }
  }
  // What was seen first is kept: no drift.
  for (const std::uint32_t side : filled) grid.sights[side].full = true;
}

void SurfelMap::fit(Grid& grid) const {
  for (std::size_t i = 0; i < grid.stale.size(); ++i) {
    if (i + kAhead < grid.stale.size()) prefetch(grid.voxels[grid.stale[i + kAhead]]);
    const std::uint32_t at = grid.stale[i];
    Voxel& voxel = grid.voxels[at];
    Surfel& surfel = surfel_of(grid, voxel);
    surfel = voxel.moments.fit(middle_of(voxel.index, grid.size), grid.size, config_);
    grid.sights[at].middle = surfel.mean.cast<float>();
    voxel.stale = false;
    voxel.fitted_at = voxel.moments.count();
    if (surfel.pole()) grid.poles.push_back(at);
  }
  grid.stale.clear();
}

/// Whether what looks like a pole is a piece of a wall: what the voxel's sides cut off one, or what
/// a single firing shows of it. Where it lies along the wall it tells of the voxel or of the
/// sensor.
bool SurfelMap::lies_on_wall(std::size_t level, const Voxel& voxel, const Surfel& pole) const {
  constexpr std::array<std::array<int, 2>, 5> kBeside = {
      {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto is_wall = [&](const Surfel& wall) {
    if (wall.directions != 1 || std::abs(wall.across(0).dot(pole.axis())) > kAskew) return false;
    const double away = wall.across(0).dot(pole.mean - wall.mean);
    const double thickness = std::min(wall.variance(0), config_.noise * config_.noise);
    return away * away <= kOnWall * kOnWall * thickness;  // [K40]
  };
  VoxelIndex index = voxel.index;
  for (; level < grids_.size(); ++level, index = coarser(index)) {
    const Grid& grid = grids_[level];
    for (const auto& [x, y] : kBeside) {
      const std::uint64_t key = voxel_key(index + VoxelIndex(x, y, 0));
      for (const std::uint64_t side : {key, key | kBack}) {
        const std::uint32_t at = grid.table.find_entry(side).second;
        if (at != VoxelTable::kNone && is_wall(grid.surfels[at])) return true;
      }
    }
  }
  return false;
}

/// Once all grids know the scan.
void SurfelMap::refuse_pieces_of_walls() {
  for (std::size_t level = 0; level < grids_.size(); ++level) {
    Grid& grid = grids_[level];
    for (const std::uint32_t at : grid.poles) {
      const Voxel& voxel = grid.voxels[at];
      if (voxel.surfel == VoxelTable::kNone) continue;  // emptied since
      Surfel& surfel = grid.surfels[voxel.surfel];
      if (!lies_on_wall(level, voxel, surfel)) continue;
      surfel = voxel.moments.fit(middle_of(voxel.index, grid.size), grid.size, config_,
                                 SurfelMoments::Poles::none);
    }
    grid.poles.clear();
  }
}

void SurfelMap::note_hit(Sight& sight) const {
  if (sight.last_hit == scan_) return;
  sight.last_hit = scan_;
  sight.passed = 0;
  sight.hits = static_cast<std::uint16_t>(std::min(sight.hits + 1, kMost));
}

/// The sides that a scan's beams may have gone through, of those that it did not hit.
std::vector<std::uint32_t> SurfelMap::may_be_passed(const Grid& grid, const Beams& beams) const {
  std::vector<std::uint32_t> sides;
  const auto ask = [&](std::uint32_t side) {
    if (beams.may_pass(grid.sights[side].middle)) sides.push_back(side);
  };
  for (const std::uint32_t side : grid.passed) ask(side);
  const std::size_t all = grid.sights.size();
  for (std::size_t block = scan_ % kTurn; block * kBlock < all; block += kTurn) {
    const std::size_t end = std::min((block + 1) * kBlock, all);
    for (std::size_t side = block * kBlock; side < end; ++side) {
      const Sight& sight = grid.sights[side];
      if (sight.hits == 0 || sight.last_hit == scan_ || sight.passed > 0) continue;
      ask(static_cast<std::uint32_t>(side));
    }
  }
  return sides;
}

/// What beams went through time and again since one last hit it has moved away.
std::vector<VoxelIndex> SurfelMap::empty_passed(Grid& grid, const Beams& beams) const {
  std::vector<VoxelIndex> emptied;
  const auto untouched = [&](std::uint32_t side) { return grid.sights[side].passed == 0; };
  std::erase_if(grid.passed, untouched);
  const std::vector<std::uint32_t> sides = may_be_passed(grid, beams);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i + 2 * kAhead < sides.size()) prefetch(grid.voxels[sides[i + 2 * kAhead]]);
    if (i + kAhead < sides.size()) {
      const std::uint32_t surfel = grid.voxels[sides[i + kAhead]].surfel;
      if (surfel != VoxelTable::kNone) prefetch(grid.surfels[surfel], kCacheLine);
    }
    const std::uint32_t at = sides[i];
    Voxel& voxel = grid.voxels[at];
    const bool passed =
        voxel.surfel != VoxelTable::kNone
            ? beams.pass(grid.surfels[voxel.surfel])
            : beams.pass(voxel.moments.fit(middle_of(voxel.index, grid.size), grid.size, config_));
    if (!passed) continue;
    Sight& sight = grid.sights[at];
    if (sight.passed == 0) grid.passed.push_back(at);
    sight.passed = static_cast<std::uint16_t>(std::min(sight.passed + 1, kMost));
    // [K19]
    if (sight.passed < config_.gone_after + config_.gone_share * sight.hits) continue;
    const std::uint32_t other = grid.table.find(voxel.key ^ kBack);
    if (other == VoxelTable::kNone || grid.voxels[other].moments.count() == 0) {
      emptied.push_back(voxel.index);
    }
    empty(grid, at);
  }
  return emptied;
}

/// Of the finest grid what lies in voxels of the next one. By their indices: their middles are
/// corners of the finest grid's voxels, and rounded into any of them.
void SurfelMap::empty_divided(const std::vector<VoxelIndex>& voxels) {
  Grid& grid = grids_.front();
  for (const VoxelIndex& voxel : voxels) {
    for (int part = 0; part < 8; ++part) {
      const VoxelIndex index = 2 * voxel + VoxelIndex(part & 1, part >> 1 & 1, part >> 2);
      const std::uint64_t key = voxel_key(index);
      for (const std::uint64_t side : {key, key | kBack}) {
        const std::uint32_t at = grid.table.find(side);
        if (at != VoxelTable::kNone) empty(grid, at);
      }
    }
  }
}

Cubes SurfelMap::insert(const View& view, const Workers& workers) {
  ++scan_;
  const Sweep sweep(view, grids_.front().inverse_size);
  std::vector<std::vector<std::uint32_t>> taken(grids_.size());
  for (std::size_t level = 0; level < grids_.size(); ++level) taken[level] = taken_by(level, sweep);
  const std::size_t finest = finest_whole();
  std::vector<VoxelIndex> emptied;
  workers.for_each(grids_.size(), [&](std::size_t turn) {
    const std::size_t level = (finest + turn) % grids_.size();  // what takes longest first
    Grid& grid = grids_[level];
    add(level, sweep, taken[level]);
    fit(grid);
    if (config_.gone_after == 0 || level < finest) return;
    std::vector<VoxelIndex> here = empty_passed(grid, view.beams);
    if (level == finest) emptied = std::move(here);
  });
  if (divides()) empty_divided(emptied);
  refuse_pieces_of_walls();
  Cubes cubes{grids_[finest].size, {}};
  cubes.centres.reserve(emptied.size());
  for (const VoxelIndex& voxel : emptied) cubes.centres.push_back(middle_of(voxel, cubes.side));
  return cubes;
}

}  // namespace surefoot
