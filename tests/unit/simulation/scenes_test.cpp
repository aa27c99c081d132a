// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "simulation/standard_suite.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

class SceneTest : public ::testing::TestWithParam<std::string> {};

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
  std::uint64_t seed;
  double seconds;
};

/// Looks round from the sensor every 50 ms; between two looks it passes through nothing.
void expect_free_sensor(const Recording& recording) {
  constexpr double kStep = 0.05;
  constexpr float kClearance = 0.1F;
  const std::string which =
      recording.scene + "-" + recording.robot + " seed " + std::to_string(recording.seed);
  const Scene scene = build_scene(recording.scene, recording.seed);
  RayCaster rays(scene);
  const Motion motion = make_motion(scene, rays, gait_model(recording.robot), recording.seconds,
                                    recording.seed, kMount);
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

TEST(SuiteTest, InNoRecordingIsTheSensorInsideAnything) {
  for (const SuiteSet& set : kSuiteSets) {
    for (std::size_t i = 0; i < kStandardSuite.size(); ++i) {
      const SuiteEntry& entry = kStandardSuite[i];
      expect_free_sensor({entry.scene, entry.robot, suite_seed(set, i),
                          0.1 * static_cast<double>(entry.scans + 1)});
    }
  }
}

TEST(SuiteTest, SetsShareNoSeedAndNoNameIsTakenTwice) {
  std::set<std::uint64_t> seeds;
  std::set<std::string> recordings;
  for (std::size_t i = 0; i < kStandardSuite.size(); ++i) {
    for (const SuiteSet& set : kSuiteSets) seeds.insert(suite_seed(set, i));
    recordings.insert(std::string(kStandardSuite[i].scene) + "-" + kStandardSuite[i].robot);
  }
  EXPECT_EQ(seeds.size(), kSuiteSets.size() * kStandardSuite.size());
  EXPECT_EQ(recordings.size(), kStandardSuite.size());
}

TEST_P(SceneTest, GivesScansWithReturnsAndTheSameOnesAgain) {
  std::array<SimulatedScan, 2> scans;
  for (SimulatedScan& scan : scans) {
    const Scene scene = build_scene(GetParam(), 12);
    RayCaster rays(scene);
    Scanner scanner(rays, lidar_model("vlp16"),
                    make_motion(scene, rays, gait_model(scene.robot), 3.0, 12, kMount), {});
    scan = scanner.scan(25);
  }
  EXPECT_GT(scans[0].scan.points.size(), 9000U);
  EXPECT_EQ(scans[0].scan.points, scans[1].scan.points);
  EXPECT_EQ(scans[0].scan.intensities, scans[1].scan.intensities);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const SceneEntry& entry : scene_catalogue()) result.push_back(entry.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, SceneTest, ::testing::ValuesIn(names()),
                         [](const auto& instance) { return instance.param; });

TEST(SceneCatalogueTest, UnknownNamesAreAnsweredWithTheKnownOnes) {
  try {
    (void)build_scene("moon", 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("stairwell"), std::string::npos);
  }
}

}  // namespace
}  // namespace surefoot::simulation::test
