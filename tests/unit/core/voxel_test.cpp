// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Voxel indices and keys, the hash table.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

TEST(VoxelKey, IndexIsTheFloor) {
  EXPECT_EQ(voxel_index(0.0, 1.0), 0);
  EXPECT_EQ(voxel_index(-1e-9, 1.0), -1);
  EXPECT_EQ(voxel_index(-1.0, 1.0), -1);
  EXPECT_EQ(voxel_index(-1.0001, 1.0), -2);
  EXPECT_EQ(voxel_index(2.99, 2.0), 5);
}

TEST(VoxelKey, KeysDifferOverAMillionVoxelsEachWay) {
  std::set<std::uint64_t> keys;
  const int ends[] = {-1'048'576, -1'000'000, -1, 0, 1, 1'000'000, 1'048'575};
  for (const int x : ends) {
    for (const int y : ends) {
      for (const int z : ends) keys.insert(voxel_key({x, y, z}));
    }
  }
  EXPECT_EQ(keys.size(), 343U);
}

TEST(VoxelTable, BehavesLikeAMapWhileItGrows) {
  Random random(1);
  VoxelTable table;
  std::map<std::uint64_t, std::uint32_t> expected;
  for (std::uint32_t i = 0; i < 50'000; ++i) {
    const std::uint64_t key = random.below(30'000);  // many twice
    const auto [index, inserted] = table.find_or_insert(key, i);
    const auto [place, is_new] = expected.emplace(key, i);
    ASSERT_EQ(inserted, is_new);
    ASSERT_EQ(index, place->second);
  }
  for (std::uint64_t key = 0; key < 40'000; ++key) {
    const auto place = expected.find(key);
    ASSERT_EQ(table.find(key), place == expected.end() ? VoxelTable::kNone : place->second);
  }
  table.clear();
  EXPECT_EQ(table.find(expected.begin()->first), VoxelTable::kNone);
  EXPECT_TRUE(table.find_or_insert(7, 3).second);
}

TEST(VoxelTable, FindsWhatIsLeftAfterErasing) {
  Random random(2);
  VoxelTable table;
  std::map<std::uint64_t, std::uint32_t> expected;
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    const std::uint64_t key = random.below(700);  // so that a table of 1,024 or 2,048 is crowded
    if (random.below(2) == 0) {
      table.erase(key);
      expected.erase(key);
    } else {
      ASSERT_EQ(table.find_or_insert(key, i).second, expected.emplace(key, i).second);
    }
    if (i % 1000 != 0) continue;
    for (std::uint64_t asked = 0; asked < 700; ++asked) {
      const auto place = expected.find(asked);
      ASSERT_EQ(table.find(asked), place == expected.end() ? VoxelTable::kNone : place->second);
    }
  }
}

TEST(VoxelTable, SecondIndicesGoWithTheirKeys) {
  Random random(3);
  VoxelTable table;
  std::map<std::uint64_t, std::uint32_t> seconds;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const std::uint64_t key = random.below(3'000);  // it grows, and is crowded
    if (random.below(3) == 0) {
      table.erase(key);
      seconds.erase(key);
    } else if (table.find_or_insert(key, i).second) {
      ASSERT_EQ(table.find_entry(key).second, VoxelTable::kNone);
      if (random.below(2) != 0) table.set_second(key, seconds[key] = i + 7);
    }
  }
  for (std::uint64_t key = 0; key < 3'000; ++key) {
    const auto second = seconds.find(key);
    ASSERT_EQ(table.find_entry(key).second,
              second == seconds.end() ? VoxelTable::kNone : second->second);
  }
}

}  // namespace
}  // namespace surefoot
