// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "simulation/standard_suite.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

class SceneTest : public ::testing::TestWithParam<std::string> {};

/// gtest's names hold letters, digits and underscores.
std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST(SceneLayouts, TwoShareNoRouteAndThingsMoveNone) {
  for (const SceneEntry& entry : scene_catalogue()) {
    const Scene one = entry.build({2, 5});
    const Scene other = entry.build({3, 5});
    EXPECT_NE(one.route, other.route) << entry.name;
    EXPECT_EQ(one.route, entry.build({2, 6}).route) << entry.name;
  }
}

/// But for the city, of which a picture of this size shows little.
TEST(SceneCatalogue, EverySceneHasAPictureOnThePage) {
  std::ifstream file(SUREFOOT_SIMULATION_PAGE);
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const SceneEntry& entry : scene_catalogue()) {
    const std::string name(entry.name);
    const std::string row = "| " + name + " | ![" + name + "](images/scenes/" + name + ".png) |";
    EXPECT_EQ(page.find(row) != std::string::npos, name != "city") << name;
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
                         [](const auto& instance) { return test_name(instance.param); });

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
