// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/cube_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

TEST(CubeTable, BehavesLikeAMapOnBothSidesOfZero) {
  test::Random random(3);
  CubeTable table;
  std::map<std::array<int, 3>, std::uint32_t> expected;
  const auto coordinate = [&] { return static_cast<int>(random.below(30)) - 15; };
  for (std::uint32_t i = 0; i < 50'000; ++i) {
    const std::array<int, 3> cube{coordinate(), coordinate(), coordinate()};
    std::uint32_t& found = table.at({cube[0], cube[1], cube[2]});
    const auto [place, is_new] = expected.emplace(cube, i);
    ASSERT_EQ(found, is_new ? CubeTable::kNone : place->second);
    found = place->second = i;
  }
}

}  // namespace
}  // namespace surefoot::mapping
