// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Nobody walks through a wall: in no recording of the suite, on no layout of a scene. What is named
// "Whole" takes minutes: unit_simulation_whole, labelled long.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/ground_path.hpp"
#include "simulation/standard_suite.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

/// Directions spread evenly over the sphere (golden spiral).
std::vector<Eigen::Vector3f> directions(int count) {
  std::vector<Eigen::Vector3f> result;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = 2.399963229728653 * i;
    const double flat = std::sqrt(1.0 - z * z);
    result.emplace_back(flat * std::cos(angle), flat * std::sin(angle), z);
  }
  return result;
}

struct Recording {
  std::string scene;
  std::string robot;
  SceneSeeds seeds;
  double seconds;
};

/// Looks round from the sensor every 50 ms; between two looks it passes through nothing.
void expect_free_sensor(const Recording& recording) {
  constexpr double kStep = 0.05;
  constexpr float kClearance = 0.1F;
  const std::string which =
      recording.scene + "-" + recording.robot + " seed " + std::to_string(recording.seeds.things);
  const Scene scene = build_scene(recording.scene, recording.seeds);
  RayCaster rays(scene);
  const Motion motion = make_motion(scene, rays, gait_model(recording.robot), recording.seconds,
                                    recording.seeds.things, kMount);
  const std::vector<Eigen::Vector3f> around = directions(64);
  std::vector<Ray> cast(around.size() + 1);
  std::vector<Hit> hits(cast.size());
  for (double time = 0.0; time + kStep < motion.duration(); time += kStep) {
    rays.set_interval(time, time + kStep);
    const Eigen::Vector3f here = motion.T_map_lidar(time).translation.cast<float>();
    const Eigen::Vector3f step = motion.T_map_lidar(time + kStep).translation.cast<float>() - here;
    for (std::size_t i = 0; i < around.size(); ++i) cast[i] = {here, around[i], 0.0F};
    cast.back() = {here, step.norm() > 0 ? Eigen::Vector3f(step.normalized()) : around[0], 0.0F};
    rays.cast(cast, kClearance + step.norm(), hits);
    for (std::size_t i = 0; i < around.size(); ++i) {
      ASSERT_TRUE(!hits[i].valid() || hits[i].distance > kClearance)
          << which << " at " << time << " s, " << here.transpose() << ": " << hits[i].distance
          << " m from a surface";
    }
    ASSERT_TRUE(!hits.back().valid() || hits.back().distance > step.norm()) << which << time;
  }
}

class SuiteSetTest : public ::testing::TestWithParam<SuiteSet> {};

TEST_P(SuiteSetTest, InNoRecordingIsTheSensorInsideAnything) {
  const SuiteSet set = GetParam();
  for (std::size_t i = 0; i < set.entries().size(); ++i) {
    const SuiteEntry& entry = set.entries()[i];
    const std::uint64_t seed = suite_seed(set, i);
    expect_free_sensor({entry.scene,
                        entry.robot,
                        {set.own_layouts ? seed : kFirstLayout, seed},
                        0.1 * static_cast<double>(entry.scans + 1)});
  }
}

INSTANTIATE_TEST_SUITE_P(Newest, SuiteSetTest, ::testing::Values(kSuiteSets.back()));
INSTANTIATE_TEST_SUITE_P(Whole, SuiteSetTest,
                         ::testing::ValuesIn(kSuiteSets.begin(), kSuiteSets.end() - 1));

/// A lap over the ground of a layout: nothing firm within reach of the body's sides, no slope that
/// a robot could not walk.
void expect_walkable(const std::string& name, std::uint64_t layout) {
  constexpr double kStep = 0.2;
  constexpr double kBody = 0.35;      // above the ground [m]
  constexpr float kClearance = 0.3F;  // from the body's middle to either side
  const bool grown = name.starts_with("hill") || name.starts_with("forest");
  // Of the plane through the four footholds, stones and steps included.
  const bool stairs = name == "stairwell" || name == "storeys";
  const double steepest = stairs ? 0.72 : grown ? 0.60 : 0.45;  // [rad]
  const std::string which = name + " layout " + std::to_string(layout);
  const Scene scene = build_scene(name, SceneSeeds{layout, layout});
  const RayCaster rays(scene);
  const GroundPath path(scene, rays, Stance{}, 1.0);
  double last_z = path.at(0.0).z();
  for (double way = 0.0; way < path.lap(); way += kStep) {
    const PoseAngles support = path.at(way);
    ASSERT_LT(std::abs(support(3)), steepest) << which << " roll after " << way << " m";
    ASSERT_LT(std::abs(support(4)), steepest) << which << " pitch after " << way << " m";
    ASSERT_LT(std::abs(support.z() - last_z), kStep) << which << " after " << way << " m";
    last_z = support.z();
    for (int i = 0; i < 16; ++i) {
      const double angle = 0.3927 * i;
      const Ray ray{(support.head<3>() + Eigen::Vector3d(0.0, 0.0, kBody)).cast<float>(),
                    Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0).cast<float>(), 0.0F};
      Hit hit;
      rays.cast({&ray, 1}, kClearance, {&hit, 1});
      // On stairs and slopes what rises ahead is the ground itself.
      const bool ground = hit.cos_incidence < 0.9F || name == "stairwell";
      ASSERT_TRUE(!hit.valid() || is_soft(hit.material) || hit.met != Met::still || ground)
          << which << " after " << way << " m at " << support.head<3>().transpose() << ": "
          << hit.distance << " m from a surface";
    }
  }
}

class LayoutTest : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(LayoutTest, CanBeWalkedInEveryScene) {
  for (const char* name : {"campus", "parking", "stairwell", "playground", "forest", "corridor",
                           "rubble", "plaza", "foyer", "storeys", "bays", "street"}) {
    expect_walkable(name, GetParam());
  }
  if (GetParam() > 3) return;  // the larger ones
  for (const char* name : {"hillside", "hilltop", "forest-path", "town", "quarter", "avenue"}) {
    expect_walkable(name, GetParam());
  }
}

INSTANTIATE_TEST_SUITE_P(First, LayoutTest, ::testing::Values(1));
INSTANTIATE_TEST_SUITE_P(Whole, LayoutTest, ::testing::Range<std::uint64_t>(2, 13));

}  // namespace
}  // namespace surefoot::simulation::test
