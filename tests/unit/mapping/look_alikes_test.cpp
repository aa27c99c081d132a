// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/look_alikes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace surefoot::mapping {
namespace {

/// A room's points, seen from its middle.
class Room {
 public:
  Room(float length, float width) {
    for (float x = -0.5F * length; x < 0.5F * length; x += kSpacing) {
      for (float y = -0.5F * width; y < 0.5F * width; y += kSpacing) see(x, y, 0.0F);
    }
    for (const float side : {-0.5F, 0.5F}) {
      wall({-0.5F * length, side * width}, {0.5F * length, side * width});
      wall({side * length, -0.5F * width}, {side * length, 0.5F * width});
    }
  }
  void wall(const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const float length = (to - from).norm();
    for (float s = 0.0F; s < length; s += kSpacing) {
      const Eigen::Vector2f at = from + s / length * (to - from);
      for (float z = 0.0F; z < 3.0F; z += kSpacing) see(at.x(), at.y(), z);
    }
  }
  [[nodiscard]] const Submap& submap() const { return submap_; }

 private:
  static constexpr float kSpacing = 0.15F;
  void see(float x, float y, float z) {
    submap_.points.emplace_back(x, y, z);
    submap_.eyes.emplace_back(0.0F, 0.0F, 0.5F);
  }
  Submap submap_;
};

/// A long hall with shelves across it at both sides.
VerifiableSubmap hall(const std::vector<float>& shelves) {
  Room room(44.0F, 10.0F);
  for (const float x : shelves) {
    room.wall({x, -5.0F}, {x, -1.5F});
    room.wall({x, 1.5F}, {x, 5.0F});
  }
  return VerifiableSubmap(room.submap());
}

LoopCheck with_itself(const VerifiableSubmap& place) {
  return check_places(place, place, {Pose{}}, LoopLimits{});
}

TEST(LookAlikes, ASquareRoomFitsTurnedUntilSomethingStandsInIt) {
  Room room(14.0F, 14.0F);
  const VerifiableSubmap square(room.submap());
  ASSERT_EQ(with_itself(square).verdict, LoopVerdict::taken);
  EXPECT_TRUE(fits_turned(with_itself(square), square, square, LoopLimits{}));
  room.wall({-7.0F, 3.0F}, {2.0F, 3.0F});
  room.wall({4.0F, -7.0F}, {4.0F, -5.0F});
  const VerifiableSubmap divided(room.submap());
  ASSERT_EQ(with_itself(divided).verdict, LoopVerdict::taken);
  EXPECT_FALSE(fits_turned(with_itself(divided), divided, divided, LoopLimits{}));
}

TEST(LookAlikes, EqualBaysFitSlidByOne) {
  const VerifiableSubmap equal =
      hall({-20.0F, -16.0F, -12.0F, -8.0F, -4.0F, 0.0F, 4.0F, 8.0F, 12.0F, 16.0F, 20.0F});
  const VerifiableSubmap unequal =
      hall({-20.5F, -17.5F, -12.0F, -9.5F, -3.5F, 0.0F, 5.5F, 7.5F, 14.5F, 16.0F, 21.0F});
  const LoopCheck of_equal = with_itself(equal);
  const LoopCheck of_unequal = with_itself(unequal);
  ASSERT_GT(of_equal.overlap, 0.9);
  ASSERT_GT(of_unequal.overlap, 0.9);
  EXPECT_GT(overlap_slid(of_equal, equal, equal), 0.75);
  EXPECT_LT(overlap_slid(of_unequal, unequal, unequal), 0.65);
}

}  // namespace
}  // namespace surefoot::mapping
