// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/cell_downsample.hpp"

#include <bit>
#include <utility>

namespace surefoot {

namespace {

struct Slot {
  VoxelIndex cell;
  std::uint32_t hash = 0;
  std::uint32_t point = 0;
  int from_home = -1;  // slots behind the one that the hash names; -1: empty
};

/// Open addressing in which whoever is farther from home keeps the slot.
class RobinHoodTable {
 public:
  /// With room for so many cells: the slots are a power of two, at most half of them are taken.
  explicit RobinHoodTable(std::size_t cells)
      : slots_(std::bit_ceil(std::max<std::size_t>(2 * cells, 1))) {}

  /// Keeps the point if its cell is new.
  void add(const VoxelIndex& cell, std::uint32_t hash, std::uint32_t point) {
    if (holds(cell, hash)) return;
    if (size_ >= slots_.size() / 2) grow();
    place({cell, hash, point, 0});
    ++size_;
  }

  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }

 private:
  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }

  [[nodiscard]] bool holds(const VoxelIndex& cell, std::uint32_t hash) const {
    std::size_t at = hash & mask();
    for (int from_home = 0; from_home <= slots_[at].from_home; ++from_home) {
      if (slots_[at].cell == cell) return true;
      at = (at + 1) & mask();
    }
    return false;
  }

  void place(Slot moving) {
    std::size_t at = moving.hash & mask();
    while (slots_[at].from_home >= 0) {
      if (moving.from_home > slots_[at].from_home) std::swap(moving, slots_[at]);
      at = (at + 1) & mask();
      ++moving.from_home;
    }
    slots_[at] = moving;
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (Slot& slot : old) {
      if (slot.from_home < 0) continue;
      slot.from_home = 0;
      place(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace

std::vector<std::uint32_t> first_of_cells(const std::vector<Eigen::Vector3d>& points, double size,
                                          CellRounding rounding, CellHash hash,
                                          std::size_t expected_cells) {
  RobinHoodTable table(expected_cells);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const VoxelIndex cell = cell_index(points[i], size, rounding);
    table.add(cell, hash(cell), static_cast<std::uint32_t>(i));
  }
  std::vector<std::uint32_t> first;
  for (const Slot& slot : table.slots()) {
    if (slot.from_home >= 0) first.push_back(slot.point);
  }
  return first;
}

std::vector<Eigen::Vector3d> cell_downsample(const std::vector<Eigen::Vector3d>& points,
                                             double size, CellRounding rounding, CellHash hash) {
  std::vector<Eigen::Vector3d> thinned;
  for (const std::uint32_t i : first_of_cells(points, size, rounding, hash, points.size())) {
    thinned.push_back(points[i]);
  }
  return thinned;
}

}  // namespace surefoot
