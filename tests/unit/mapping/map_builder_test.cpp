// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_builder.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace surefoot::mapping {
namespace {

TEST(MapBuilder, CorrectsPointsByWhenTheyWereSeenAndDropsThoseOfNoPlace) {
  MapBuilder map(0.1);
  DeskewedScan scan;
  for (int i = 0; i < 3; ++i) {
    scan.points = {{static_cast<float>(i), 0.0F, 0.0F}};
    map.add(scan, Pose{}, i);
  }
  Pose up;
  up.translation.z() = 5.0;
  const MapBuilder moved =
      map.corrected([&](double time) { return time == 1.0 ? std::nullopt : std::optional(up); });
  ASSERT_EQ(moved.points().size(), 2U);
  EXPECT_EQ(moved.points()[0], Eigen::Vector3f(0.0F, 0.0F, 5.0F));
  EXPECT_EQ(moved.points()[1], Eigen::Vector3f(2.0F, 0.0F, 5.0F));
  EXPECT_EQ(moved.first_seen(), (std::vector<float>{0.0F, 2.0F}));
}

}  // namespace
}  // namespace surefoot::mapping
