// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "methods/knots/surfel.hpp"
#include "methods/knots/view.hpp"
#include "surefoot/config.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot {

/// The map around the sensor at several scales: grids of voxels, each twice as coarse as the one
/// before, each voxel with its points' moments and the surfel fitted to them.
///
/// A wall or a flight of stairs has two sides, a hand apart. A voxel whose plane is later hit from
/// behind keeps those points apart, as its back, and a point is only ever compared with the side
/// that its ray can have hit.
///
/// What moved away does not stay: a voxel is emptied that beams went through time and again since
/// one last hit it.
///
/// Where points are dense (a staircase, a corridor) the finest grid answers; far away, or between
/// the LiDAR's rings, a coarser one. So one set of parameters serves every scale of scene.
///
/// Most of the finest grid's voxels would hold a point or two and never answer: it only divides
/// those of the next one that are near and full enough, and empties what that one empties.
class SurfelMap {
 public:
  explicit SurfelMap(const Config::Knots& config, double radius);

  /// Where a surfel was found, so that it can be known again without a search.
  struct Place {
    int level = -1;                         ///< -1: no surfel
    int asked = -1;                         ///< the finest level that was asked for
    VoxelIndex voxel = VoxelIndex::Zero();  ///< of the finest level asked
    const Surfel* surfel = nullptr;
  };

  /// A place to be looked up [m, map frame], seen along a ray of any length from the sensor.
  struct Question {
    Eigen::Vector3d place, ray;
    Place* last;  ///< what the last answer for this point left, and then this one
  };
  static constexpr std::size_t kAtOnce = 32;
  /// For each of up to kAtOnce questions the plane or pole of the finest grid, from `finest` on,
  /// whose voxel about the place has one that the ray can have hit; if none has, the finest cloud
  /// there, or null. The map must not change between two answers for a point.
  void find_all(std::span<const Question> questions, int finest) const;
  /// Likewise, for one of which nothing is remembered: for those who ask about many places once
  /// each.
  [[nodiscard]] const Surfel* find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray,
                                   int finest) const;

  /// f(voxel, its surfel, its back's or null) for every voxel of a grid that has one.
  template <typename Function>
  void for_each_front(int level, const Function& f) const {
    const Grid& grid = grids_[level];
    for (std::size_t at = 0; at < grid.voxels.size(); ++at) {
      const Voxel& voxel = grid.voxels[at];
      if (voxel.surfel == VoxelTable::kNone || (voxel.key & kBack) != 0) continue;
      const std::uint32_t back = grid.table.find_entry(voxel.key | kBack).second;
      f(voxel.index, grid.surfels[voxel.surfel],
        back == VoxelTable::kNone ? nullptr : &grid.surfels[back]);
    }
  }

  /// Adds what a scan saw, fits the voxels that changed and empties those that its beams went
  /// through. Returns those that were emptied on both sides, of the finest grid that asks the
  /// beams.
  Cubes insert(const View& view, const Workers& workers = Workers(1));
  /// Drops the voxels that lie farther than the radius, or than what their grid holds, from the
  /// sensor: a part of them is asked at every call, all of them within kRound calls.
  void remove_far(const Eigen::Vector3d& sensor);
  static constexpr std::size_t kRound = 32;
  void clear();

  [[nodiscard]] bool empty() const { return grids_.back().in_use() == 0; }
  [[nodiscard]] int levels() const { return static_cast<int>(grids_.size()); }
  /// [m] of a grid's voxels.
  [[nodiscard]] double size_of(int level) const { return grids_[level].size; }
  /// The finest grid whose voxels are at least so large [m], or the coarsest.
  [[nodiscard]] int level_of(double size) const;
  /// The means of the voxels [m] of the finest grid that no other is divided into.
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;

 private:
  /// One side of a voxel.
  struct alignas(64) Voxel {
    std::uint64_t key = 0;
    VoxelIndex index = VoxelIndex::Zero();
    int fitted_at = 0;                         // count when the surfel was fitted
    std::uint32_t surfel = VoxelTable::kNone;  // none: too few points
    bool stale = false;
    bool in_use = false;
    SurfelMoments moments;
  };
  static_assert(sizeof(Voxel) <= 128, "more than two cache lines");
  /// When it was seen, and what else is asked of every voxel at every scan.
  struct Sight {
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();  // of its points [m]
    std::uint32_t last_hit = 0;                        // number of the scan
    std::uint16_t hits = 0;                            // scans; none: it is empty
    std::uint16_t passed = 0;  // scans whose beams went through since the last hit
    bool full = false;         // takes no more points
  };
  /// A voxel's side is one index into two arrays: what is added to, and what is gone through at
  /// every scan. What is searched is a third: every other voxel has too few points for a surfel.
  struct Grid {
    double size;
    double inverse_size;
    VoxelTable table;  // of sides and of their surfels
    Pages<Voxel> voxels;
    std::vector<Sight> sights;
    Pages<Surfel> surfels;
    std::vector<std::uint32_t> unused_surfels;
    std::vector<std::uint32_t> stale;   // to fit anew
    std::vector<std::uint32_t> poles;   // fitted by this scan, that may be pieces of walls
    std::vector<std::uint32_t> passed;  // those that beams went through since one last hit them
    std::vector<std::uint32_t> unused;  // sides that were dropped
    std::size_t next = 0;               // the side where the removal of what is far goes on

    [[nodiscard]] std::size_t in_use() const { return voxels.size() - unused.size(); }
  };

  // voxel_key() leaves the first bit free: it tells a voxel's back.
  static constexpr std::uint64_t kBack = std::uint64_t{1} << 63;

  [[nodiscard]] static Eigen::Vector3d middle_of(const VoxelIndex& index, double size) {
    return (index.cast<double>().array() + 0.5) * size;
  }

  /// What a scan adds to the map: points, and the beams that measured them.
  struct Sweep;

  /// Whether `last` has the answer already.
  [[nodiscard]] static bool known(const VoxelIndex& index, const Eigen::Vector3d& ray, int finest,
                                  const Place& last) {
    return last.asked == finest && last.voxel == index &&
           (last.surfel == nullptr || !last.surfel->from_behind(ray));
  }
  struct Search;
  [[nodiscard]] static const Surfel* hit_side(const Grid& grid, std::uint64_t key,
                                              const Surfel& front, const Eigen::Vector3d& ray);
  [[nodiscard]] bool answer(const Search& search, int level) const;
  static std::uint32_t make_side(Grid& grid, std::uint64_t key, const VoxelIndex& index);
  [[nodiscard]] static VoxelTable::Entry side_of(Grid& grid, std::uint64_t key,
                                                 const VoxelIndex& index);
  static Surfel& surfel_of(Grid& grid, Voxel& voxel);
  /// Whether the finest grid divides the voxels of the next one, and follows it.
  [[nodiscard]] bool divides() const { return config_.divided_at > 0 && grids_.size() > 1; }
  /// The finest grid that does not.
  [[nodiscard]] std::size_t finest_whole() const { return divides() ? 1 : 0; }
  [[nodiscard]] double reach_of(const Grid& grid) const;
  [[nodiscard]] std::vector<std::uint32_t> taken_by(std::size_t level, const Sweep& sweep) const;
  void leave_undivided(std::size_t level, const Sweep& sweep,
                       std::vector<std::uint32_t>& taken) const;
  void add(std::size_t level, const Sweep& sweep, const std::vector<std::uint32_t>& taken);
  void fit(Grid& grid) const;
  [[nodiscard]] bool lies_on_wall(std::size_t level, const Voxel& voxel, const Surfel& pole) const;
  void refuse_pieces_of_walls();
  void note_hit(Sight& sight) const;
  [[nodiscard]] std::vector<std::uint32_t> may_be_passed(const Grid& grid,
                                                         const Beams& beams) const;
  [[nodiscard]] std::vector<VoxelIndex> empty_passed(Grid& grid, const Beams& beams) const;
  static void empty(Grid& grid, std::uint32_t side);
  static void drop(Grid& grid, std::uint32_t side);
  void empty_divided(const std::vector<VoxelIndex>& voxels);

  Config::Knots config_;
  double radius_;
  std::vector<Grid> grids_;
  std::uint32_t scan_ = 0;  // number of the last one
};

}  // namespace surefoot
