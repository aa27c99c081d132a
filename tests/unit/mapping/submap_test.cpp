// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a submap knows of the ground that it stands on and of what is above it.
#include "mapping/submap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace surefoot::mapping {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr float kGround = -0.4F;  // [m]

Submap submap_of(const Points& points) {
  Piece piece;
  piece.eyes = {Eigen::Vector3f::Zero()};
  piece.points = points;
  piece.seen_from.assign(points.size(), 0);
  return make_submap(piece);
}

/// In the middle of every square metre of some, at a height.
void lay(Points& points, std::pair<int, int> x, std::pair<int, int> y, float z) {
  for (int i = x.first; i < x.second; ++i) {
    for (int k = y.first; k < y.second; ++k) {
      points.emplace_back(static_cast<float>(i) + 0.5F, static_cast<float>(k) + 0.5F, z);
    }
  }
}

/// Ground all around, and something so high above it over so many of the twelve metres about the
/// middle.
bool is_covered(float height, int metres) {
  Points points;
  lay(points, {-10, 10}, {-6, 6}, kGround);
  lay(points, {-6, -6 + metres}, {-6, 6}, kGround + height);
  return submap_of(points).covered;
}

TEST(Submap, IsCoveredByWhatIsAsHighAsACeiling) {
  EXPECT_TRUE(is_covered(2.0F, 12));
  EXPECT_TRUE(is_covered(7.9F, 12));
  EXPECT_FALSE(is_covered(1.8F, 12)) << "a table's height, or a car's";
  EXPECT_FALSE(is_covered(8.1F, 12)) << "crowns of trees";
}

TEST(Submap, IsCoveredWhereACeilingIsOverTwoFifthsOfTheGround) {
  EXPECT_TRUE(is_covered(3.0F, 5));
  EXPECT_FALSE(is_covered(3.0F, 4)) << "a balcony";
}

TEST(Submap, IsNotCoveredByWhatHangsFarAwayOrOverNoGround) {
  Points far;
  lay(far, {-10, 10}, {-6, 6}, kGround);
  lay(far, {-10, -6}, {-6, 6}, kGround + 3.0F);
  lay(far, {6, 10}, {-6, 6}, kGround + 3.0F);
  EXPECT_FALSE(submap_of(far).covered);
  Points beside;
  lay(beside, {0, 6}, {-6, 6}, kGround);
  lay(beside, {-6, 0}, {-6, 6}, kGround + 3.0F);
  EXPECT_FALSE(submap_of(beside).covered);
}

TEST(Submap, IsNotCoveredWhereHardlyAnyGroundIsSeen) {
  for (const int metres : {4, 5}) {
    Points points;
    lay(points, {0, metres}, {0, 1}, kGround);
    lay(points, {0, metres}, {0, 1}, kGround + 3.0F);
    EXPECT_EQ(submap_of(points).covered, metres == 5) << "of twelve squares, at least";
  }
}

/// Ground that rises along x by this angle, over so many metres along y.
double levelled_by(double slope, int metres, float rough = 0.0F) {
  Points points;
  lay(points, {-8, 8}, {0, metres}, 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].z() = static_cast<float>(std::tan(slope)) * points[i].x();
    points[i].z() += rough * static_cast<float>(i * 7 % 11);
  }
  return submap_of(points).to_slope.angularDistance(Eigen::Quaterniond::Identity());
}

TEST(Submap, IsLevelledOnASlopeThatCanBeWalked) {
  EXPECT_NEAR(levelled_by(0.3, 8), 0.3, 1e-3);
  EXPECT_NEAR(levelled_by(0.55, 8), 0.55, 1e-3);
  EXPECT_EQ(levelled_by(0.65, 8), 0.0) << "what is so steep is no ground";
}

TEST(Submap, IsNotLevelledByWhatIsNarrowOrNoPlane) {
  EXPECT_NEAR(levelled_by(0.3, 2), 0.3, 1e-3);
  EXPECT_EQ(levelled_by(0.3, 1), 0.0) << "sixteen squares";
  EXPECT_EQ(levelled_by(0.3, 8, 0.5F), 0.0) << "heaps";
}

TEST(Submap, IsLevelledThoughSomeOfTheGroundLiesDeeper) {
  Points points;
  lay(points, {-8, 8}, {-8, 8}, 0.0F);
  for (Eigen::Vector3f& point : points) {
    point.z() = 0.3F * point.x() - (point.x() > 4.0F && point.y() > 0.0F ? 3.0F : 0.0F);
  }
  const Eigen::Quaterniond to_slope = submap_of(points).to_slope;
  EXPECT_NEAR(to_slope.angularDistance(Eigen::Quaterniond::Identity()), std::atan(0.3), 0.01);
}

TEST(Submap, StandsOnTheGroundAboutItsMiddle) {
  Points points;
  lay(points, {-7, 7}, {-7, 7}, kGround);
  lay(points, {7, 20}, {-7, 7}, -5.0F);
  lay(points, {-3, 3}, {-3, 3}, 2.0F);
  EXPECT_NEAR(submap_of(points).ground, kGround, 1e-6);
}

/// Crowns, roofs and walls rise otherwise than the ground below them.
TEST(Submap, IsLevelledByTheLowestPointsAlone) {
  Points points;
  lay(points, {-8, 8}, {-8, 8}, 0.0F);
  const std::size_t ground = points.size();
  for (std::size_t i = 0; i < ground; ++i) {
    points[i].z() = kGround + 0.2F * points[i].x();
    const Eigen::Vector3f at = points[i];
    for (float above = 1.0F; above < 3.0F; above += 0.5F) {
      points.emplace_back(at.x(), at.y(), at.z() + above + 0.3F * (at.x() + 8.0F));
    }
  }
  const Submap submap = submap_of(points);
  const Eigen::Vector3d normal = submap.to_slope.conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(normal.x() / normal.z(), -0.2, 1e-3);
  EXPECT_NEAR(normal.y(), 0.0, 1e-3);
}

}  // namespace
}  // namespace surefoot::mapping
