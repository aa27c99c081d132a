// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Strays of a scan: who has no company.
#include "core/isolated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

/// A scan of a round room of 4 m by 16 rings of `columns` beams, every tenth of them with a range
/// of its own if there are strays.
struct RoundRoom {
  explicit RoundRoom(int columns, bool strays = true) {
    Random random(3);
    for (int column = 0; column < columns; ++column) {
      for (int ring = 0; ring < 16; ++ring) {
        const double azimuth = 2.0 * std::numbers::pi * column / columns;
        const double elevation = (2.0 * ring - 15.0) * std::numbers::pi / 180.0;
        const bool stray = strays && random.below(10) == 0;
        const double range = stray ? random.uniform(5.0, 60.0) : 4.0;
        if (stray) strays_at.insert(static_cast<std::uint32_t>(points.size()));
        points.emplace_back(
            (range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation)))
                .cast<float>());
      }
    }
  }
  std::vector<Eigen::Vector3f> points;
  std::set<std::uint32_t> strays_at;
};

TEST(Isolated, StraysGoAndAWallStays) {
  for (const int columns : {300, 1800}) {
    const RoundRoom room(columns);
    const std::vector<std::uint32_t> kept = points_with_company(room.points);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    const auto strays = std::count_if(kept.begin(), kept.end(),
                                      [&](std::uint32_t i) { return room.strays_at.contains(i); });
    // Some stand beside others by chance, the more the coarser the cells.
    EXPECT_LT(static_cast<double>(strays), 0.4 * static_cast<double>(room.strays_at.size()))
        << columns;
    // And a cell's corner may hold one point of a wall alone.
    EXPECT_GE(static_cast<double>(kept.size()) - static_cast<double>(strays),
              0.99 * static_cast<double>(room.points.size() - room.strays_at.size()))
        << columns;
  }
}

TEST(Isolated, AThinScanOfAWallIsNoStrays) {
  for (const int columns : {4, 20, 90, 360}) {
    const RoundRoom room(columns, false);
    EXPECT_GE(100 * points_with_company(room.points).size(), 99 * room.points.size()) << columns;
  }
}

TEST(Isolated, NothingIsToldWhereMostWouldBeStrays) {
  Random random(5);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(random.vector(40.0).cast<float>());
  EXPECT_EQ(points_with_company(points).size(), points.size());
  EXPECT_TRUE(points_with_company({}).empty());
  EXPECT_EQ(points_with_company({Eigen::Vector3f::Zero()}).size(), 1U);
}

TEST(Isolated, NeitherOrderNorThreadsMatter) {
  const RoundRoom room(900);
  const std::vector<std::uint32_t> kept = points_with_company(room.points);
  EXPECT_EQ(points_with_company(room.points, Workers(3)), kept);
  std::vector<Eigen::Vector3f> reversed(room.points.rbegin(), room.points.rend());
  std::vector<std::uint32_t> again = points_with_company(reversed);
  for (std::uint32_t& i : again) i = static_cast<std::uint32_t>(room.points.size()) - 1 - i;
  std::reverse(again.begin(), again.end());
  EXPECT_EQ(again, kept);
}

}  // namespace
}  // namespace surefoot
