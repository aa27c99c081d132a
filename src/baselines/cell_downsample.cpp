// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "baselines/cell_downsample.hpp"

#include <bit>
#include <utility>

namespace surefoot {

namespace {

struct Slot {
  VoxelIndex cell;
  std::uint32_t point = 0;
  int from_home = -1;  // slots behind the one that the hash names; -1: empty
};

/// Open addressing in which whoever is farther from home keeps the slot.
class RobinHoodTable {
 public:
  /// Twice as many slots as points at least, a power of two: it never has to grow.
  explicit RobinHoodTable(std::size_t points)
      : slots_(std::bit_ceil(std::max<std::size_t>(2 * points, 1))) {}

  /// Keeps the point if its cell is new.
  void add(const VoxelIndex& cell, std::uint32_t hash, std::uint32_t point) {
    std::size_t at = hash & mask();
    Slot moving{cell, point, 0};
    for (; moving.from_home <= slots_[at].from_home; step(at, moving)) {
      if (slots_[at].cell == cell) return;
    }
    for (; slots_[at].from_home >= 0; step(at, moving)) {
      if (moving.from_home > slots_[at].from_home) std::swap(moving, slots_[at]);
    }
    slots_[at] = moving;
  }

  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }

 private:
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
  void step(std::size_t& at, Slot& moving) const {
    at = (at + 1) & mask();
    ++moving.from_home;
  }

  std::vector<Slot> slots_;
};

}  // namespace

std::vector<Eigen::Vector3d> cell_downsample(const std::vector<Eigen::Vector3d>& points,
                                             double size, CellRounding rounding, CellHash hash) {
  RobinHoodTable table(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const VoxelIndex cell = cell_index(points[i], size, rounding);
    table.add(cell, hash(cell), static_cast<std::uint32_t>(i));
  }
  std::vector<Eigen::Vector3d> thinned;
  for (const Slot& slot : table.slots()) {
    if (slot.from_home >= 0) thinned.push_back(points[slot.point]);
  }
  return thinned;
}

}  // namespace surefoot
