// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/gaussian_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace surefoot::mapping {
namespace {

/// A slab is not taken for one surface by who saw it from above and who saw it from below.
TEST(GaussianGrid, KnowsTheSideThatAPlaneWasSeenFrom) {
  std::vector<Eigen::Vector3f> points, above;
  for (float x = 0.05F; x < 1.0F; x += 0.1F) {
    for (float y = 0.05F; y < 1.0F; y += 0.1F) {
      points.emplace_back(x, y, 0.5F);
      above.emplace_back(0.5F, 0.5F, 1.5F);
    }
  }
  const GaussianGrid grid(points, above, 1.0);
  const Gaussian* floor = grid.inside({0.5, 0.5, 0.5});
  ASSERT_NE(floor, nullptr);
  EXPECT_TRUE(floor->level);
  EXPECT_NEAR(floor->distance2({0.1, 0.9, 0.8}), 0.09, 1e-6);
  EXPECT_FALSE(floor->other_side({0.6, 0.0, 0.8}));
  EXPECT_TRUE(floor->other_side({0.6, 0.0, -0.8}));
  EXPECT_TRUE(floor->other_side({0.999, 0.0, -0.045}));   // from a dog's height, ten metres away
  EXPECT_FALSE(floor->other_side({0.9999, 0.0, -0.01}));  // edge-on: not told

  std::vector<Eigen::Vector3f> both = above;
  for (std::size_t i = 0; i < both.size(); i += 2) both[i].z() = -0.5F;
  const GaussianGrid thin(points, both, 1.0);
  EXPECT_FALSE(thin.inside({0.5, 0.5, 0.5})->other_side({0.6, 0.0, -0.8}));
}

/// A plane whose normal is hardly known tells its sides only where it is seen steeply.
/// Of a difference from a cube's mean what counts: all across a pole, a tenth within a cloud.
TEST(GaussianGrid, CountsWhatAPlaneAPoleAndACloudHold) {
  std::vector<Eigen::Vector3f> plane, pole, cloud;
  for (int i = 0; i < 5; ++i) {
    const float x = 0.1F + 0.2F * static_cast<float>(i);
    pole.emplace_back(x, 0.5F, 0.5F);
    for (int j = 0; j < 5; ++j) {
      const float y = 0.1F + 0.2F * static_cast<float>(j);
      plane.emplace_back(x, y, 0.5F);
      for (int k = 0; k < 5; ++k) cloud.emplace_back(x, y, 0.1F + 0.2F * static_cast<float>(k));
    }
  }
  const auto off = [](const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& by) {
    const std::vector<Eigen::Vector3f> eyes(points.size(), Eigen::Vector3f(0.0F, 0.0F, 5.0F));
    const GaussianGrid grid(points, eyes, 1.0);
    const Gaussian* const found = grid.inside({0.5, 0.5, 0.5});
    return found == nullptr ? -1.0 : found->distance2(found->mean + by);
  };
  const Eigen::Vector3d along(0.3, 0.0, 0.0), aside(0.0, 0.3, 0.0), up(0.0, 0.0, 0.3);
  EXPECT_NEAR(off(plane, up), 0.09, 1e-6);
  EXPECT_NEAR(off(plane, along + aside), 0.0, 1e-6);
  EXPECT_NEAR(off(pole, along), 0.0, 1e-6);
  EXPECT_NEAR(off(pole, aside + up), 0.18, 1e-6);
  for (const Eigen::Vector3d& by : {along, aside, up}) EXPECT_NEAR(off(cloud, by), 0.009, 1e-6);
}

TEST(GaussianGrid, ARoughPlaneTellsItsSidesLessWell) {
  std::vector<Eigen::Vector3f> points, above;
  for (int i = 0; i < 6; ++i) {
    const float x = 0.2F + 0.3F * static_cast<float>(i % 3);
    points.emplace_back(x, i < 3 ? 0.2F : 0.8F, i % 2 == 0 ? 0.44F : 0.56F);
    above.emplace_back(0.5F, 0.5F, 2.5F);
  }
  const GaussianGrid grid(points, above, 1.0);
  const Gaussian* floor = grid.inside({0.5, 0.5, 0.5});
  ASSERT_NE(floor, nullptr);
  ASSERT_EQ(floor->counted, 1);
  const Eigen::Vector3d normal =
      floor->across[0].normalized() * (floor->across[0].z() < 0 ? -1 : 1);
  const Eigen::Vector3d along = normal.unitOrthogonal();
  EXPECT_FALSE(floor->other_side(0.995 * along - 0.1 * normal));
  EXPECT_TRUE(floor->other_side(0.4 * along - 0.916 * normal));
}

}  // namespace
}  // namespace surefoot::mapping
