// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is no wall: leaves that a foot sinks through, panes, rain and dust, people that come along,
// what starts anew elsewhere.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "geometry/decompositions.hpp"
#include "simulation/companions.hpp"
#include "simulation/walk_plan.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

SimulatedScan scan_of(const Scene& scene, const ScannerOptions& options, std::uint64_t index = 20) {
  RayCaster rays(scene);
  Scanner scanner(rays, lidar_model("vlp16"),
                  make_motion(scene, rays, gait_model("trot"), 3.0, 7, kMount), options);
  return scanner.scan(index);
}

Hit cast_one(const RayCaster& rays, const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction) {
  const Ray ray{origin.cast<float>(), direction.normalized().cast<float>(), 0.0F};
  Hit hit;
  rays.cast({&ray, 1}, 100.0F, {&hit, 1});
  return hit;
}

TEST(GroundTest, IsWhatBearsAFootUnderTheLeaves) {
  Scene scene = room();
  const auto lay = [&](double height, Material material) {
    scene.mesh.add_quad({-1, -1, height}, {1, -1, height}, {1, 1, height}, {-1, 1, height},
                        material);
  };
  lay(1e-5, Material::blade);  // so near to the ground that no step goes between
  lay(0.3, Material::foliage);
  const RayCaster leaves(scene);
  EXPECT_NEAR(leaves.ground_below({0.2, 0.1, 1.0}, 3.0).value(), 0.0, 1e-6);
  EXPECT_FALSE(leaves.ground_below({0.2, 0.1, 1.0}, 0.9).has_value());
  lay(0.1, Material::rock);
  const RayCaster stone(scene);
  EXPECT_NEAR(stone.ground_below({0.2, 0.1, 1.0}, 3.0).value(), 0.1, 1e-6);
  EXPECT_NEAR(stone.ground_below({2.2, 0.1, 1.0}, 3.0).value(), 0.0, 1e-6);
}

/// A pane at x = 2, walls of a room at x = +-9, y = +-7.
Scene room_with_pane() {
  Scene scene = room();
  scene.mesh.add_quad({2, -6, 0}, {2, 6, 0}, {2, 6, 4}, {2, -6, 4}, Material::pane);
  return scene;
}

TEST(PaneTest, LetsThroughWhatIsNotGrazingAndWeakensIt) {
  const RayCaster rays(room_with_pane());
  const double angle = 0.4;
  const Hit hit = cast_one(rays, {0, 0, 1}, {std::cos(angle), std::sin(angle), 0.0});
  EXPECT_EQ(hit.met, Met::still);
  EXPECT_EQ(hit.material, Material::concrete);
  EXPECT_NEAR(hit.distance, 9.0 / std::cos(angle), 2e-3);
  const double reflected = 0.08 + 0.92 * std::pow(1.0 - std::cos(angle), 5.0);
  EXPECT_NEAR(hit.passed, (1.0 - reflected) * (1.0 - reflected), 1e-5);
}

TEST(PaneTest, ShinesBackWhereItIsMetStraight) {
  const RayCaster rays(room_with_pane());
  const Hit hit = cast_one(rays, {0, 0, 1}, {1, 0, 0});
  EXPECT_EQ(hit.material, Material::pane);
  EXPECT_NEAR(hit.distance, 2.0, 1e-5);
}

TEST(PaneTest, MirrorsAtALowAngle) {
  const RayCaster rays(room_with_pane());
  // Meets the pane at y = 4.5 going almost along it, and then the wall y = 7.
  const Eigen::Vector3d direction = Eigen::Vector3d(0.1, 3.0, 0.0).normalized();
  const Hit hit = cast_one(rays, {1.85, 0, 1}, direction);
  EXPECT_EQ(hit.met, Met::mirrored);
  EXPECT_NEAR(hit.distance, 7.0 / direction.y(), 2e-3);
  EXPECT_LT(hit.passed, 1.0F);
}

TEST(PaneTest, MirroredPointsAreLabelled) {
  const SimulatedScan scan = scan_of(room_with_pane(), {.seed = 3});
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    if (scan.labels[i] == kLabelMirrored) continue;
    // Only what is seen in a mirror lies on nothing that is there.
    if (scan.labels[i] == kLabelStatic) {
      const double pane = std::abs(scan.true_points[i].x() - 2.0);
      EXPECT_LT(std::min(distance_to_room(scan.true_points[i]), pane), 0.02) << i;
    }
    beyond += scan.true_points[i].x() > 8.9 ? 1U : 0U;
  }
  EXPECT_GT(beyond, 300U);  // of the wall behind the pane
}

TEST(AirTest, EndsTheShareOfBeamsThatWasAskedAndChangesNothingElse) {
  const Scene scene = room();
  const SimulatedScan clear = scan_of(scene, {.seed = 3});
  std::map<std::pair<std::int32_t, int>, Eigen::Vector3f> seen;
  for (std::size_t i = 0; i < clear.scan.points.size(); ++i) {
    seen[{clear.scan.times_ns[i], clear.scan.rings[i]}] = clear.scan.points[i];
  }
  for (const AirOptions& air : {AirOptions{0.1, 0.0}, AirOptions{0.0, 0.1}}) {
    const SimulatedScan wet = scan_of(scene, {.seed = 3, .air = air});
    double drops = 0.0;
    for (std::size_t i = 0; i < wet.scan.points.size(); ++i) {
      const auto same = seen.find({wet.scan.times_ns[i], wet.scan.rings[i]});
      if (wet.labels[i] != kLabelAir) {
        ASSERT_TRUE(same != seen.end());
        EXPECT_EQ(wet.scan.points[i], same->second);
        continue;
      }
      drops += 1.0;
      // Nearer than the surface, whose own range is noisy.
      if (same != seen.end()) {
        EXPECT_LT(wet.scan.points[i].norm(), same->second.norm() + 0.15F);
      }
    }
    // A few fall behind the walls, where there is nothing to see.
    const double share = drops / static_cast<double>(wet.scan.points.size());
    EXPECT_GT(share, 0.06) << air.rain;
    EXPECT_LT(share, 0.11) << air.rain;
  }
}

TEST(CompanionTest, StaysNearTheRobotOutOfItsSensorAndOutOfWalls) {
  const Scene scene = room();
  const RayCaster rays(scene);
  const GaitModel gait = gait_model("trot");
  const Motion motion = make_motion(scene, rays, gait, 60.0, 7, kMount);
  const std::vector<MovingObject> people = make_companions(3, scene, rays, gait, 60.0, 7);
  ASSERT_EQ(people.size(), 3U);
  bool in_front = false;
  for (const MovingObject& person : people) {
    for (double time = 0.0; time < 60.0; time += 0.05) {
      const Eigen::Vector3d at = person.T_map_object(time).translation;
      const Pose T_map_lidar = motion.T_map_lidar(time);
      const Eigen::Vector2d apart = (at - T_map_lidar.translation).head<2>();
      EXPECT_GT(apart.norm(), 0.6) << time;
      EXPECT_LT(apart.norm(), 2.0) << time;
      EXPECT_NEAR(at.z(), 0.0, 1e-5);
      EXPECT_LT(std::abs(at.x()), 8.8);
      EXPECT_LT(std::abs(at.y()), 6.8);
      const Eigen::Vector3d ahead = T_map_lidar.rotation * Eigen::Vector3d::UnitX();
      in_front = in_front || apart.normalized().dot(ahead.head<2>()) > 0.95;
    }
  }
  EXPECT_TRUE(in_front);
  EXPECT_TRUE(make_companions(0, scene, rays, gait, 60.0, 7).empty());
}

// In a corridor there is no room beside the robot, only before and behind it.
TEST(CompanionTest, GoesAtAPersonsPaceRoundTheSensor) {
  const Scene scene = build_scene("corridor", 1);
  const RayCaster rays(scene);
  const GaitModel gait = gait_model("trot");
  const Motion motion = make_motion(scene, rays, gait, 60.0, 1, kMount);
  for (const MovingObject& person : make_companions(6, scene, rays, gait, 60.0, 1)) {
    constexpr double kStep = 0.02;  // between the places that are kept
    Eigen::Vector3d before = person.T_map_object(0.0).translation;
    for (double time = 0.0; time < 60.0; time += kStep) {
      const Eigen::Vector3d at = person.T_map_object(time).translation;
      EXPECT_GT((at - motion.T_map_lidar(time).translation).head<2>().norm(), 0.6) << time;
      EXPECT_LT((at - before).head<2>().norm(), 8.0 * kStep) << time;
      before = at;
    }
  }
}

// As a car that leaves the scene at one end of the road and enters it at the other.
TEST(MoverTest, DoesNotSweepTheWayBackToWhereItStartsAnew) {
  Scene scene = room();
  // At either side of the robot: the head looks at one of them in the middle of the way back.
  for (const double x : {-6.0, 6.0}) {
    MovingObject box;
    box.mesh.add_box({-0.5, -0.5, 0.0}, {0.5, 0.5, 3.0}, Material::concrete);
    box.T_map_object = [x](double time) {
      const double along = std::fmod(2.0 * (time + 4.95), 14.0);  // anew at 2.05 s
      return Pose{Eigen::Quaterniond::Identity(), {x, along - 7.0, 0.0}};
    };
    scene.moving.push_back(box);
  }
  std::size_t moving = 0;
  for (std::uint64_t index = 18; index < 23; ++index) {
    const SimulatedScan scan = scan_of(scene, {.seed = 3, .footprint = false}, index);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      if (scan.labels[i] != kLabelMoving) continue;
      ++moving;
      EXPECT_GT(std::abs(scan.true_points[i].y()), 5.9) << index;  // at either end
    }
  }
  EXPECT_GT(moving, 50U);
}

/// Share of points whose neighbours within 0.8 m lie within 5 cm (RMS) of a plane.
double planar_share(const SimulatedScan& scan) {
  constexpr double kReach = 0.8;
  constexpr std::size_t kFewest = 15;
  double planar = 0.0;
  double asked = 0.0;
  for (std::size_t i = 0; i < scan.true_points.size(); i += 97) {
    asked += 1.0;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (const Eigen::Vector3d& other : scan.true_points) {
      const Eigen::Vector3d apart = other - scan.true_points[i];
      if (apart.squaredNorm() > kReach * kReach) continue;
      scatter += apart * apart.transpose();
      sum += apart;
      ++count;
    }
    if (count < kFewest) continue;
    const auto n = static_cast<double>(count);
    const SymmetricEigen<3> eigen =
        symmetric_eigen<3>(scatter / n - sum * sum.transpose() / (n * n));
    planar += eigen.values[0] < 0.05 * 0.05 ? 1.0 : 0.0;
  }
  return planar / asked;
}

TEST(NatureTest, OnTheHilltopHardlyAnythingIsFlat) {
  EXPECT_LT(planar_share(scan_of(build_scene("hilltop", 4), {.seed = 3})), 0.1);
  EXPECT_GT(planar_share(scan_of(build_scene("corridor", 4), {.seed = 3})), 0.5);
}

}  // namespace
}  // namespace surefoot::simulation::test
