// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/voxel_key.hpp"

namespace surefoot {

/// Open-addressing hash table from voxel keys to indices into some array, and into a second one if
/// need be. It never shrinks.
class VoxelTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  struct Entry {
    std::uint32_t index = kNone;
    std::uint32_t second = kNone;
  };

  VoxelTable() : slots_(kInitialSlots) {}

  /// To be asked for soon.
  void prefetch(std::uint64_t key) const {
#if defined(__GNUC__)
    __builtin_prefetch(&slots_[hash_key(key) & mask()]);
#endif
  }

  /// The index stored for a key, or kNone.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const { return find_entry(key).index; }

  /// Both indices stored for a key, or kNone.
  [[nodiscard]] Entry find_entry(std::uint64_t key) const { return slots_[slot_of(key)].entry; }

  /// For a key that is stored.
  void set_second(std::uint64_t key, std::uint32_t second) {
    slots_[slot_of(key)].entry.second = second;
  }

  /// The index stored for a key, after storing `index` if there was none (then second is true).
  std::pair<std::uint32_t, bool> find_or_insert(std::uint64_t key, std::uint32_t index) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[slot_of(key)];
    if (slot.entry.index != kNone) return {slot.entry.index, false};
    slot = {key, {index, kNone}};
    ++size_;
    return {index, true};
  }

  /// What comes after a key's slot moves up as far as it may, so that no search ends too early.
  void erase(std::uint64_t key) {
    std::size_t gap = slot_of(key);
    if (slots_[gap].entry.index == kNone) return;
    for (std::size_t i = (gap + 1) & mask(); slots_[i].entry.index != kNone; i = (i + 1) & mask()) {
      const std::size_t begin = hash_key(slots_[i].key) & mask();
      if (((i - begin) & mask()) < ((i - gap) & mask())) continue;  // it begins behind the gap
      slots_[gap] = slots_[i];
      gap = i;
    }
    slots_[gap] = {};
    --size_;
  }

  void clear() {
    slots_.assign(slots_.size(), Slot{});
    size_ = 0;
  }

 private:
  static constexpr std::size_t kInitialSlots = 1024;

  struct Slot {
    std::uint64_t key = 0;
    Entry entry;
  };

  [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }

  /// Where a key is, or would be.
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    std::size_t i = hash_key(key) & mask();
    while (slots_[i].entry.index != kNone && slots_[i].key != key) i = (i + 1) & mask();
    return i;
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.entry.index != kNone) slots_[slot_of(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace surefoot
