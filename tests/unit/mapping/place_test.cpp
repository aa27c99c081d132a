// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Descriptors of places and the search among them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mapping/place_index.hpp"
#include "mapping/place_search.hpp"
#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

using test::Random;

/// Ground and a few dozen posts and walls, drawn anew by the seed.
Submap place(unsigned seed) {
  Random random(seed);
  Submap submap;
  for (double x = -20.0; x < 20.0; x += 0.5) {
    for (double y = -20.0; y < 20.0; y += 0.5) submap.points.emplace_back(x, y, -0.4);
  }
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d foot = random.vector(1.0).cwiseProduct(Eigen::Vector3d(25.0, 25.0, 0.0));
    const double top = 0.5 + 3.0 * std::abs(random.vector(1.0).x());
    for (double z = -0.4; z < top; z += 0.2) {
      submap.points.emplace_back(foot.x(), foot.y(), z);
    }
  }
  submap.eyes.assign(submap.points.size(), Eigen::Vector3f::Zero());
  submap.ground = submap.slope_ground = -0.4;
  return submap;
}

Submap turned(Submap submap, double yaw, const Eigen::Vector2d& shift = {0.0, 0.0}) {
  const Eigen::Matrix3f R =
      Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix().cast<float>();
  const Eigen::Vector3f t(static_cast<float>(shift.x()), static_cast<float>(shift.y()), 0.0F);
  for (Eigen::Vector3f& point : submap.points) point = R * point + t;
  return submap;
}

TEST(PlaceDescriptorTest, TurningAPlaceShiftsItsColumnsAndKeepsItsKey) {
  const Submap one = place(1);
  const PlaceDescriptor first = describe_place(one);
  for (const int sectors : {1, 7, 30, 59}) {
    const double yaw = sectors * 2.0 * std::numbers::pi / PlaceDescriptor::kSectors;
    // Seen in a frame that is turned by yaw, the same points are turned back.
    const PlaceDescriptor second = describe_place(turned(one, -yaw));
    const DescriptorDistance found = distance_between(first, second);
    EXPECT_LT(found.distance, 0.02);
    EXPECT_NEAR(std::remainder(found.yaw() - yaw, 2.0 * std::numbers::pi), 0.0, 1e-6);
    EXPECT_LT(key_distance(first, second), 0.1);
  }
}

TEST(PlaceDescriptorTest, AnotherPlaceIsFartherOffThanTheSameSeenFromAside) {
  const PlaceDescriptor first = describe_place(place(1));
  double same = 1.0;
  for (const OffsetDescriptor& seen :
       describe_with_offsets(turned(place(1), std::numbers::pi, {0.5, 2.0}))) {
    same = std::min(same, distance_between(first, seen.descriptor).distance);
  }
  for (unsigned seed = 2; seed < 8; ++seed) {
    EXPECT_GT(distance_between(first, describe_place(place(seed))).distance, same + 0.05);
  }
}

TEST(PlaceDescriptorTest, EmptyPlacesAreLikeNothing) {
  const PlaceDescriptor empty = describe_place(Submap{});
  EXPECT_EQ(distance_between(empty, empty).distance, 1.0);
  EXPECT_EQ(distance_between(describe_place(place(1)), empty).distance, 1.0);
}

/// Column by column, as the paper has it.
TEST(PlaceDescriptorTest, ADistanceIsThatOfColumnsTurnedAgainstEachOther) {
  const PlaceDescriptor first = describe_place(place(1));
  const PlaceDescriptor second = describe_place(turned(place(2), 1.0));
  DescriptorDistance expected;
  for (int shift = 0; shift < PlaceDescriptor::kSectors; ++shift) {
    double likeness = 0.0;
    int compared = 0;
    for (int column = 0; column < PlaceDescriptor::kSectors; ++column) {
      const Eigen::VectorXf one = first.bins.col(column);
      const Eigen::VectorXf other =
          second.bins.col((column - shift + PlaceDescriptor::kSectors) % PlaceDescriptor::kSectors);
      if (one.isZero() && other.isZero()) continue;
      ++compared;
      if (!one.isZero() && !other.isZero()) {
        likeness += static_cast<double>(one.normalized().dot(other.normalized()));
      }
    }
    const double distance = 1.0 - likeness / compared;
    if (distance < expected.distance) expected = {distance, shift};
  }
  const DescriptorDistance found = distance_between(first, second);
  EXPECT_NEAR(found.distance, expected.distance, 1e-5);
  EXPECT_EQ(found.shift, expected.shift);
}

/// A point in the middle of each bin is in that bin.
TEST(PlaceDescriptorTest, PointsLieInTheirRingsAndSectors) {
  for (int ring = 0; ring < PlaceDescriptor::kRings; ++ring) {
    // From 1.5 m to 45 m, evenly in the logarithm; the innermost begins at the middle.
    const double range = 1.5 * std::pow(30.0, (ring - 0.5) / (PlaceDescriptor::kRings - 1));
    for (int sector = 0; sector < PlaceDescriptor::kSectors; ++sector) {
      const double angle = (sector + 0.5) * 2.0 * std::numbers::pi / PlaceDescriptor::kSectors;
      Submap submap;
      submap.points = {{static_cast<float>(-range * std::cos(angle)),
                        static_cast<float>(-range * std::sin(angle)), 1.0F}};
      const PlaceDescriptor found = describe_place(submap);
      EXPECT_EQ(found.bins(ring, sector), 1.0F) << ring << ' ' << sector;
      EXPECT_EQ(found.bins.sum(), 1.0F);
    }
  }
}

TEST(PlaceIndexTest, FindsThePlaceWhateverTheHeadingAndSaysWhereItLies) {
  PlaceIndex index;
  for (unsigned seed = 0; seed < 30; ++seed) index.add(describe_place(place(seed)));
  const Pose T_place_query = {Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ())),
                              {2.0, -1.0, 0.0}};
  const Pose T_query_place = T_place_query.inverse();
  const Submap seen = turned(place(12), -2.5, T_query_place.translation.head<2>());
  const auto matches = index.search(
      describe_with_offsets(seen), [](std::size_t) { return true; }, 3);
  ASSERT_EQ(matches.size(), 3U);
  EXPECT_EQ(matches.front().place, 12U);
  const Pose error = matches.front().T_place_query.inverse() * T_place_query;
  EXPECT_LT(error.translation.norm(), 2.0);
  EXPECT_LT(so3_log(error.rotation).norm(), 0.12);
}

TEST(PlaceIndexTest, AsksOnlyWhereItMay) {
  PlaceIndex index;
  for (unsigned seed = 0; seed < 5; ++seed) index.add(describe_place(place(seed)));
  const auto matches = index.search(
      describe_with_offsets(place(3)), [](std::size_t i) { return i != 3; }, 9);
  EXPECT_EQ(matches.size(), 4U);
  for (const auto& match : matches) EXPECT_NE(match.place, 3U);
}

/// The world is tilted as the odometry began; the place is the same on its ground.
TEST(PlaceSearchTest, APlaceInATiltedWorldIsTheSameOnItsGround) {
  Piece level;
  level.points = place(6).points;
  level.seen_from.assign(level.points.size(), 0);
  level.eyes = {Eigen::Vector3f::Zero()};
  const Eigen::Quaterniond tilt = from_roll_pitch_yaw({0.2, -0.15, 0.0});
  Piece tilted = level;
  for (Eigen::Vector3f& point : tilted.points) point = tilt.cast<float>() * point;
  const Submap one = make_submap(level);
  const Submap other = make_submap(tilted);
  EXPECT_LT(one.to_slope.angularDistance(Eigen::Quaterniond::Identity()), 0.01);
  EXPECT_NEAR(other.slope_ground, -0.4, 0.05);
  const DescriptorDistance found = distance_between(describe_place(one), describe_place(other));
  EXPECT_LT(found.distance, 0.4);
  PlaceIndex index;
  index.add(describe_place(one));
  const auto matches = index.search(
      describe_with_offsets(other), [](std::size_t) { return true; }, 1);
  ASSERT_EQ(matches.size(), 1U);
  const Pose rough = rough_pose(matches.front(), one, other);
  EXPECT_LT(rough.rotation.angularDistance(tilt.conjugate()), 0.12);
  EXPECT_LT(rough.translation.norm(), 2.1);
}

/// Stairs and heaps are no plane that a place could stand on.
TEST(PlaceSearchTest, WhereNoGroundLiesInAPlaneItStaysAsItIs) {
  Random random(8);
  Piece piece;
  for (int i = 0; i < 4000; ++i) {
    piece.points.push_back(
        random.vector(1.0).cwiseProduct(Eigen::Vector3d(8.0, 8.0, 3.0)).cast<float>());
  }
  piece.seen_from.assign(piece.points.size(), 0);
  piece.eyes = {Eigen::Vector3f::Zero()};
  const Submap submap = make_submap(piece);
  EXPECT_LT(submap.to_slope.angularDistance(Eigen::Quaterniond::Identity()), 0.35);
}

}  // namespace
}  // namespace surefoot::mapping
