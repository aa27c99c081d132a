// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot/mapper.hpp and surefoot/localizer.hpp: what a user of the library has of maps.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "geometry/se3.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "surefoot/localizer.hpp"
#include "surefoot/mapper.hpp"
#include "unit/mapping/scene_walk.hpp"

namespace surefoot {
namespace {

namespace fs = std::filesystem;
using test::SceneWalk;
using test::WalkOptions;

Estimate estimate_of(const mapping::PlacedScan& scan) {
  Estimate estimate;
  estimate.status = Status::ok;
  estimate.stamp_ns = scan.stamp_ns;
  estimate.T_world_lidar = scan.T_world_lidar;
  estimate.covariance = scan.covariance;
  return estimate;
}

Mapper mapped_walk(const SceneWalk& walk) {
  Mapper mapper;
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    mapper.add(estimate_of(walk.scans[i]), walk.points[i]);
  }
  Estimate lost;
  lost.status = Status::lost;
  mapper.add(lost, {});
  mapper.finish();
  return mapper;
}

SceneWalk later_day() {
  WalkOptions options;
  options.from = 25.0;
  options.length = 45.0;
  options.unknown_start = true;
  options.things = 99;
  return test::walk_through("campus", 46, options);
}

class PublicMapping : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    WalkOptions options;
    options.length = 70.0;
    fs::create_directories(folder());
    mapped_walk(test::walk_through("campus", 46, options)).save(file());
  }
  static void TearDownTestSuite() { fs::remove_all(folder()); }
  static fs::path folder() {
    const std::string name = "public_mapping." + std::to_string(getpid());
    return fs::path(testing::TempDir()) / name;
  }
  static fs::path file() { return folder() / "map.surefoot"; }
};

TEST_F(PublicMapping, AMapIsJoinedToASavedOneAndIsInItsFrame) {
  if (!mapping::has_solver()) GTEST_SKIP() << "built without Ceres";
  const SceneWalk walk = later_day();
  Mapper mapper = mapped_walk(walk);
  ASSERT_EQ(mapper.trajectory().size(), walk.scans.size());
  const JoinReport report = mapper.join(folder());
  ASSERT_TRUE(report.joined) << report.message;
  EXPECT_GE(report.loops, 2U);
  const Trajectory trajectory = mapper.trajectory();
  ASSERT_EQ(trajectory.size(), walk.scans.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    ASSERT_LT((trajectory[i].pose.translation - walk.truth[i].translation).norm(), 0.1) << i;
  }
  const Pose last =
      mapper.T_map_world(walk.scans.back().stamp_ns).value() * walk.scans.back().T_world_lidar;
  EXPECT_EQ(last.translation, trajectory.back().pose.translation);
  EXPECT_THROW((void)mapper.join(folder()), std::logic_error) << "it is joined already";
  mapper.save(folder() / "joint.surefoot");
  EXPECT_GT(fs::file_size(folder() / "joint.surefoot"), fs::file_size(file()));
}

/// It began elsewhere, in a frame of its own: where that lies in the map nothing says.
TEST_F(PublicMapping, WhatNothingHoldsToTheSavedMapHasNoPlaceInIt) {
  if (!mapping::has_solver()) GTEST_SKIP() << "built without Ceres";
  constexpr std::int64_t kPause = 100'000'000'000;
  WalkOptions options;
  options.length = 10.0;
  const SceneWalk elsewhere = test::walk_through("forest", 7, options);
  const SceneWalk walk = later_day();
  Mapper mapper;
  for (std::size_t i = 0; i < elsewhere.scans.size(); ++i) {
    mapper.add(estimate_of(elsewhere.scans[i]), elsewhere.points[i]);
  }
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    Estimate estimate = estimate_of(walk.scans[i]);
    estimate.stamp_ns += kPause;
    estimate.segment = 1;
    mapper.add(estimate, walk.points[i]);
  }
  mapper.finish();
  EXPECT_TRUE(mapper.T_map_world(elsewhere.scans[9].stamp_ns)) << "the walk's own map has it";
  ASSERT_TRUE(mapper.join(folder()).joined);
  EXPECT_EQ(mapper.trajectory().size(), walk.scans.size());
  EXPECT_FALSE(mapper.T_map_world(elsewhere.scans[9].stamp_ns));
  const std::optional<Pose> T_map_world = mapper.T_map_world(walk.scans[9].stamp_ns + kPause);
  ASSERT_TRUE(T_map_world);
  const Pose found = *T_map_world * walk.scans[9].T_world_lidar;
  EXPECT_LT((found.translation - walk.truth[9].translation).norm(), 0.1);
}

TEST_F(PublicMapping, ARobotIsFoundInASavedMap) {
  const SceneWalk walk = later_day();
  Localizer localizer(file());
  EXPECT_FALSE(localizer.T_map_lidar());
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    localizer.add(estimate_of(walk.scans[i]), walk.points[i]);
    if (!localizer.T_map_lidar()) continue;
    ASSERT_LT((localizer.T_map_lidar()->translation - walk.truth[i].translation).norm(), 0.3) << i;
  }
  ASSERT_TRUE(localizer.T_map_lidar()) << localizer.message();
  Estimate lost;
  lost.status = Status::lost;
  localizer.add(lost, DeskewedScan{});
  EXPECT_FALSE(localizer.T_map_lidar()) << "of a scan that was not registered";
  EXPECT_TRUE(localizer.T_map_world());
}

TEST_F(PublicMapping, WhatIsWrongIsSaid) {
  Mapper mapper;
  EXPECT_THROW((void)mapper.trajectory(), std::logic_error);
  EXPECT_THROW(mapper.save(file()), std::logic_error);
  mapper.finish();
  EXPECT_TRUE(mapper.trajectory().empty());
  EXPECT_THROW(mapper.finish(), std::logic_error);
  EXPECT_THROW(mapper.add({}, {}), std::logic_error);
  EXPECT_FALSE(mapper.join(file()).joined);
  EXPECT_THROW((void)mapper.join(folder() / "nothing"), std::runtime_error);
  EXPECT_THROW(mapper.save(folder() / "no" / "such" / "map"), std::runtime_error);
  std::ofstream(folder() / "broken.surefoot") << "SUREFOOT-MAP\nnot";
  EXPECT_THROW((void)Localizer(folder() / "broken.surefoot"), std::runtime_error);
}

}  // namespace
}  // namespace surefoot
