// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace surefoot::mapping {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // [ns]

DeskewedScan one_point() {
  DeskewedScan scan;
  scan.points = {{1.0F, 0.0F, 0.0F}};
  return scan;
}

TEST(MapBuilder, CorrectsPointsByWhenTheyWereSeenAndDropsThoseOfNoPlace) {
  MapBuilder map(0.1);
  DeskewedScan scan;
  for (int i = 0; i < 3; ++i) {
    scan.points = {{static_cast<float>(i), 0.0F, 0.0F}};
    map.add(scan, Pose{}, {i * kSecond, 0});
  }
  Pose up;
  up.translation.z() = 5.0;
  const MapBuilder moved = map.corrected([&](std::int64_t after_ns) {
    return after_ns == kSecond ? std::nullopt : std::optional(MapBuilder::Correction{up, 0});
  });
  ASSERT_EQ(moved.points().size(), 2U);
  EXPECT_EQ(moved.points()[0], Eigen::Vector3f(0.0F, 0.0F, 5.0F));
  EXPECT_EQ(moved.points()[1], Eigen::Vector3f(2.0F, 0.0F, 5.0F));
  EXPECT_EQ(moved.first_seen(), (std::vector<float>{0.0F, 2.0F}));
}

TEST(MapBuilder, FramesThatNothingJoinsLeaveEachOthersPointsAlone) {
  MapBuilder map(0.1);
  const DeskewedScan scan = one_point();
  map.add(scan, Pose{}, {0, 0});
  map.add(scan, Pose{}, {kSecond, 1});
  map.add(scan, Pose{}, {2 * kSecond, 0});  // home again
  EXPECT_EQ(map.first_seen(), (std::vector<float>{0.0F, 1.0F}));
  map.forget({1.0, {Eigen::Vector3d(1.5, 0.5, 0.5)}}, {3 * kSecond, 1});
  EXPECT_EQ(map.without_forgotten().first_seen(), (std::vector<float>{0.0F}));
}

TEST(MapBuilder, WhatWasForgottenAndIsSeenAgainIsThereAgain) {
  MapBuilder map(0.1);
  map.add(one_point(), Pose{}, {0, 0});
  map.forget({1.0, {Eigen::Vector3d(1.5, 0.5, 0.5)}}, {kSecond, 0});
  map.add(one_point(), Pose{}, {2 * kSecond, 0});
  EXPECT_EQ(map.without_forgotten().first_seen(), std::vector<float>{2.0F});
}

/// A crowd that comes and goes in a cube of 1 m, beside a wall that stays.
DeskewedScan crowd_and_wall() {
  DeskewedScan scan;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f point(0.05F + 0.1F * static_cast<float>(i % 10),
                                0.05F + 0.1F * static_cast<float>(i / 10 % 10),
                                0.05F + 0.1F * static_cast<float>(i / 100));
    scan.points.push_back(point);
    scan.points.emplace_back(point + Eigen::Vector3f(5.0F, 0.0F, 0.0F));
    scan.intensities.insert(scan.intensities.end(), {1.0F, 2.0F});
  }
  return scan;
}

TEST(MapBuilder, WhoStandsWherePeopleWalkTakesNoMoreMemoryForIt) {
  MapBuilder map(0.1);
  const DeskewedScan scan = crowd_and_wall();
  std::size_t most = 0;
  for (int i = 0; i < 100; ++i) {
    map.add(scan, Pose{}, {2 * i * kSecond, 0});
    map.forget({1.0, {Eigen::Vector3d(0.5, 0.5, 0.5)}}, {(2 * i + 1) * kSecond, 0});
    most = std::max(most, map.points().size());
  }
  EXPECT_LT(most, 50'000U) << "100,000 were replaced";
  map.add(scan, Pose{}, {200 * kSecond, 0});
  const MapBuilder left = map.without_forgotten();
  ASSERT_EQ(left.points().size(), 2000U);
  ASSERT_EQ(left.intensities().size(), 2000U);
  const std::vector<std::int64_t> seen = left.first_seen_ns();
  for (std::size_t i = 0; i < 2000; ++i) {
    const bool is_wall = left.points()[i].x() > 5.0F;
    EXPECT_EQ(left.intensities()[i], is_wall ? 2.0F : 1.0F) << i;
    EXPECT_EQ(seen[i], is_wall ? 0 : 200 * kSecond) << i;
  }
  map.forget({1.0, {Eigen::Vector3d(5.5, 0.5, 0.5)}}, {201 * kSecond, 0});
  map.add(scan, Pose{}, {202 * kSecond, 0});
  EXPECT_EQ(map.without_forgotten().points().size(), 2000U) << "the wall, too, can go and come";
}

TEST(MapBuilder, FramesComeTogetherWhereACorrectionJoinsThem) {
  MapBuilder map(0.1);
  const DeskewedScan scan = one_point();
  map.add(scan, Pose{}, {0, 0});
  map.add(scan, Pose{}, {kSecond, 1});
  const auto in_frames_of = [&](std::int64_t span_ns) {
    return map.corrected([&](std::int64_t after_ns) {
      return MapBuilder::Correction{Pose{}, static_cast<std::size_t>(after_ns / span_ns)};
    });
  };
  EXPECT_EQ(in_frames_of(2 * kSecond).points().size(), 1U);
  EXPECT_EQ(in_frames_of(kSecond).points().size(), 2U);
}

TEST(MapBuilder, ScansAreToldFromEachOtherToTheNanosecond) {
  MapBuilder map(0.1);
  const DeskewedScan scan = one_point();
  constexpr std::int64_t kHour = 3600 * kSecond;
  map.add(scan, Pose{}, {kHour, 0});
  map.add(scan, Pose{}, {kHour + 1, 1});
  EXPECT_EQ(map.first_seen_ns(), (std::vector<std::int64_t>{kHour, kHour + 1}));
}

TEST(MapBuilder, IntensitiesStayWithTheirPoints) {
  MapBuilder map(0.1);
  for (int i = 0; i < 3; ++i) {
    DeskewedScan scan;
    scan.points = {{static_cast<float>(i) + 1.5F, 0.5F, 0.5F}};
    scan.intensities = {10.0F * static_cast<float>(i)};
    map.add(scan, Pose{}, {i * kSecond, 0});
  }
  const MapBuilder moved = map.corrected([](std::int64_t after_ns) {
    return after_ns == kSecond ? std::nullopt : std::optional(MapBuilder::Correction{Pose{}, 0});
  });
  EXPECT_EQ(moved.intensities(), (std::vector<float>{0.0F, 20.0F}));
  map.forget({1.0, {Eigen::Vector3d(2.5, 0.5, 0.5)}}, {3 * kSecond, 0});
  EXPECT_EQ(map.without_forgotten().intensities(), (std::vector<float>{0.0F, 20.0F}));
}

}  // namespace
}  // namespace surefoot::mapping
