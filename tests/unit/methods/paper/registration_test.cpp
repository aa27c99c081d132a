// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Algorithm 1, lines 8-30: order of the stages, search distance (20), what each stage may move,
// convergence, and independence of where the map lies.
#include "methods/paper/registration.hpp"

#include <gtest/gtest.h>

#include "methods/paper/horizontal.hpp"
#include "methods/paper/vertical.hpp"
#include "registration_fixture.hpp"

namespace surefoot {
namespace {

using test::Random;

const Pose kTrue{so3_exp({0.0, 0.0, 0.4}), {1.0, -0.5, 0.2}};
const Twist kOffset = (Twist() << 0.15, -0.1, 0.08, 0.01, -0.015, 0.03).finished();

struct Scene {
  PaperParameters config = test::step_config();
  LocalMap map = test::make_map(test::room_points(1, 6000), config);
  Source source = test::make_source(test::room_points(2, 200), kTrue);
  Pose T_0 = apply_update(kTrue, kOffset);

  Registration run(int threads = 1) {
    return register_scan(source, map, T_0, config, test::kMinMatches, Workers(threads),
                         [](Step) {});
  }
};

/// The update that took one pose to another, about the first one's position.
Twist update_between(const Pose& before, const Pose& after) {
  return se3_log(
      {after.rotation * before.rotation.conjugate(), after.translation - before.translation});
}

TEST(Registration, ConvergesToTheTruePose) {
  Scene scene;
  const Registration result = scene.run();
  const Twist error = update_between(kTrue, result.T_map_lidar);
  EXPECT_TRUE(result.converged);
  // Map and scan are different random points of the same faces: the nearest point is some 5 cm
  // away along the face, at random, over a thousand matches.
  EXPECT_LT(error.head<3>().norm(), 0.02);
  EXPECT_LT(error.tail<3>().norm(), 0.005);
}

TEST(Registration, OneHorizontalUpdateMovesOnlyXYAndYaw) {
  Scene scene;
  scene.config.registration.max_iterations = 1;
  scene.config.vertical.sub_iterations = 0;
  const Registration result = scene.run();
  const Twist update = update_between(scene.T_0, result.T_map_lidar);
  EXPECT_GT(update.head<2>().norm(), 0.01);
  EXPECT_GT(std::abs(update[5]), 1e-4);
  EXPECT_LT(update.segment<3>(2).norm(), 1e-12);
  const Eigen::Vector3d before = roll_pitch_yaw(scene.T_0.rotation);
  const Eigen::Vector3d after = roll_pitch_yaw(result.T_map_lidar.rotation);
  EXPECT_LT((after - before).head<2>().norm(), 1e-12);
  EXPECT_EQ(result.horizontal.iterations, 1);
  EXPECT_EQ(result.vertical.iterations, 0);
}

TEST(Registration, OneVerticalUpdateMovesOnlyZRollAndPitch) {
  Scene scene;
  scene.config.registration.max_iterations = 1;
  scene.config.vertical.sub_iterations = 0;
  const Pose between = scene.run().T_map_lidar;
  scene.config.vertical.sub_iterations = 1;
  const Registration result = scene.run();
  const Twist update = update_between(between, result.T_map_lidar);
  EXPECT_GT(std::abs(update[2]), 0.01);
  EXPECT_GT(update.segment<2>(3).norm(), 1e-4);
  EXPECT_LT(std::abs(update[0]) + std::abs(update[1]) + std::abs(update[5]), 1e-12);
  EXPECT_EQ(result.vertical.iterations, 1);
}

TEST(Registration, AnIterationIsOneHorizontalAndThenUVVerticalUpdates) {
  for (const int sub_iterations : {0, 1, 3}) {
    Scene scene;
    const PaperParameters& config = scene.config;
    scene.config.registration.max_iterations = 1;
    scene.config.registration.early_iterations = 0;
    scene.config.vertical.sub_iterations = sub_iterations;
    const Registration result = scene.run();

    Source source = test::make_source(test::room_points(2, 200), kTrue);
    test::match_by_brute_force(source, scene.map.points(), scene.T_0,
                               config.registration.max_distance);
    const auto horizontal =
        horizontal_equations(source, scene.T_0, config.horizontal, Workers(1)).solve();
    Pose T = apply_update(scene.T_0, full_horizontal_update(horizontal));
    for (int u = 0; u < sub_iterations; ++u) {
      const auto vertical =
          vertical_equations(source, scene.map, T, config.vertical, Workers(1)).solve();
      T = apply_update(
          T, full_vertical_update(limit_to_trust_region(vertical, config.vertical.trust_region)));
    }
    EXPECT_LT((result.T_map_lidar.matrix() - T.matrix()).norm(), 1e-9);
    EXPECT_EQ(result.vertical.iterations, sub_iterations);
  }
}

TEST(Registration, TargetsLieOnTheSurfaceWhereTheMapIsFlat) {
  Scene scene;
  scene.config.registration.max_iterations = 1;
  scene.config.registration.early_iterations = 0;
  scene.config.registration.target = TargetKind::surface;
  (void)scene.run();
  Source nearest = test::make_source(test::room_points(2, 200), kTrue);
  test::match_by_brute_force(nearest, scene.map.points(), scene.T_0,
                             scene.config.registration.max_distance);
  int on_surface = 0;
  for (std::size_t i = 0; i < nearest.points.size(); ++i) {
    ASSERT_EQ(scene.source.matches[i].found, nearest.matches[i].found);
    if (!nearest.matches[i].found) continue;
    const Eigen::Vector3d s = scene.T_0 * nearest.points[i].cast<double>();
    const Eigen::Vector3d q = nearest.matches[i].target;
    const Surface surface = scene.map.surface(scene.map.voxel_of(s));
    // The residual across the surface stays, the one along it shrinks by flatness squared.
    const Eigen::Matrix3d across = surface.normal * surface.normal.transpose();
    const Eigen::Vector3d along = (Eigen::Matrix3d::Identity() - across) * (s - q);
    const Eigen::Vector3d residual =
        across * (s - q) + (1.0 - surface.flatness * surface.flatness) * along;
    EXPECT_LT((s - scene.source.matches[i].target - residual).norm(), 1e-6);
    on_surface += surface.flatness > 0.95 ? 1 : 0;
  }
  EXPECT_GT(on_surface, 300);
}

TEST(Registration, StepsFollowTheOrderOfAlgorithm1) {
  Scene scene;
  scene.config.registration.max_iterations = 2;
  scene.config.registration.convergence = 0.0;
  std::vector<Step> steps;
  const auto note = [&](Step step) { steps.push_back(step); };
  (void)register_scan(scene.source, scene.map, scene.T_0, scene.config, test::kMinMatches,
                      Workers(1), note);
  const std::vector<Step> once = {Step::search, Step::solve};
  std::vector<Step> expected = once;
  expected.insert(expected.end(), once.begin(), once.end());
  EXPECT_EQ(steps, expected);
}

TEST(Registration, EarlyIterationsSearchFartherThanTheRest) {
  // A floor 1.5 m above the one in the map: in reach of d_relaxed = 2 only.
  Scene scene;
  scene.config.registration.max_distance = 1.0;
  scene.config.registration.relaxed_distance = 2.0;
  scene.config.vertical.sub_iterations = 0;
  std::vector<Eigen::Vector3d> floor;
  Random random(3);
  test::add_face(floor, random, 20'000, {-6, -4, -0.5}, {12, 0, 0}, {0, 8, 0});
  scene.map = test::make_map(floor, scene.config);
  scene.T_0 = Pose{};
  scene.T_0.translation.z() = 1.5;
  std::vector<Eigen::Vector3d> patch;
  test::add_face(patch, random, 200, {-3, -3, -0.5}, {6, 0, 0}, {0, 6, 0});
  scene.source = test::make_source(patch, Pose{});

  scene.config.registration.max_iterations = 1;
  for (const int early : {0, 1}) {
    scene.config.registration.early_iterations = early;
    EXPECT_EQ(scene.run().matches, early == 0 ? 0 : 200);
  }
  scene.config.registration.early_iterations = 2;
  scene.config.registration.max_iterations = 2;
  EXPECT_EQ(scene.run().matches, 200);
  scene.config.registration.max_iterations = 3;
  EXPECT_EQ(scene.run().matches, 0);  // the third is no longer early
}

TEST(Registration, VerticalUpdatesStayInTheTrustRegion) {
  Scene scene;
  scene.config.registration.max_iterations = 1;
  scene.config.vertical.trust_region = 0.01;
  scene.config.vertical.sub_iterations = 0;
  const Pose between = scene.run().T_map_lidar;
  scene.config.vertical.sub_iterations = 1;
  const Twist update = update_between(between, scene.run().T_map_lidar);
  EXPECT_NEAR(update.segment<3>(2).norm(), 0.01, 1e-6);
}

TEST(Registration, StopsWhenAWholeUpdateIsSmall) {
  Scene scene;
  scene.config.registration.convergence = 0.5;  // reached at once, but not before T_early is over
  scene.config.registration.early_iterations = 3;
  const Registration result = scene.run();
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.horizontal.iterations, 4);
  scene.config.registration.convergence = 0.0;
  scene.config.registration.max_iterations = 6;
  EXPECT_FALSE(scene.run().converged);
  EXPECT_EQ(scene.run().horizontal.iterations, 6);
}

TEST(Registration, TooFewMatchesLeaveThePredictionUntouched) {
  Scene scene;
  scene.T_0.translation.x() += 500.0;
  const Registration result = scene.run();
  EXPECT_EQ(result.matches, 0);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.T_map_lidar.translation, scene.T_0.translation);
}

TEST(Registration, CoupledConvergesToo) {
  for (const auto residual : {Residual::point_to_point, Residual::point_to_plane}) {
    Scene scene;
    scene.config.registration.mode = RegistrationMode::coupled;
    scene.config.registration.coupled_residual = residual;
    const Twist error = update_between(kTrue, scene.run().T_map_lidar);
    EXPECT_LT(error.head<3>().norm(), 0.02);
    EXPECT_LT(error.tail<3>().norm(), 0.005);
  }
}

TEST(Registration, ThreadsDoNotChangeABit) {
  Scene scene;
  const Registration alone = scene.run();
  for (const int threads : {2, 3, 8}) {
    const Registration together = scene.run(threads);
    EXPECT_EQ(together.T_map_lidar.translation, alone.T_map_lidar.translation);
    EXPECT_EQ(together.T_map_lidar.rotation.coeffs(), alone.T_map_lidar.rotation.coeffs());
    EXPECT_EQ(together.matches, alone.matches);
    EXPECT_EQ(together.vertical.residual, alone.vertical.residual);
  }
}

TEST(Registration, TenKilometresAwayTheResultIsTheSame) {
  for (const auto mode : {RegistrationMode::decoupled, RegistrationMode::coupled}) {
    Scene scene;
    scene.config.registration.mode = mode;
    const Pose here = scene.run().T_map_lidar;
    const Eigen::Vector3d shift(10'240.0, -10'240.0, 128.0);  // whole voxels, exact in doubles
    scene.map = test::make_map(test::room_points(1, 6000), scene.config, shift);
    scene.T_0.translation += shift;
    const Pose there = scene.run().T_map_lidar;
    EXPECT_LT((there.translation - shift - here.translation).norm(), 1e-6);
    EXPECT_LT(so3_log(there.rotation * here.rotation.conjugate()).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace surefoot
