// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/seed_scenes.hpp"

#include <nlohmann/json.hpp>

#include "support/scratch.hpp"

namespace surefoot::experiments {
namespace {

using SeedScenes = test::Scratch;
using Names = std::vector<std::string>;
using nlohmann::json;

json scene_json(int seed) {
  return {{"surefoot", "0.1.0"},
          {"seed", seed},
          {"scans", 600},
          {"gait_scale", 1.0},
          {"mount", {{"offset_m", {0.1, 0.0, 0.16}}}},
          {"rays_per_beam", 5},
          {"dual_return", false},
          {"robot_body_in_view", false},
          {"scene", {{"name", "forest"}, {"triangles", 1000 + seed}}},
          {"robot", {{"name", "trot"}, {"speed_m_s", 0.8}}},
          {"lidar", {{"name", "vlp16"}}}};
}

TEST_F(SeedScenes, DifferInTheirSeedAlone) {
  json longer = scene_json(3);
  longer["scans"] = 700;
  json faster = scene_json(4);
  faster["robot"]["speed_m_s"] = 1.6;
  json other = scene_json(5);
  other["scene"]["name"] = "campus";
  write("a/scene.json", scene_json(1).dump());
  write("b/scene.json", longer.dump());
  write("c/scene.json", scene_json(2).dump());
  write("d/scene.json", faster.dump());
  write("e/scene.json", other.dump());
  write("f/walk.pcap", "");
  write("f/scene.json", scene_json(6).dump());
  EXPECT_EQ(seed_scenes({folder_ / "a", folder_ / "b", folder_ / "c", folder_ / "d", folder_ / "e",
                         folder_ / "f/walk.pcap"}),
            (Names{"forest-trot", "forest-trot (2)", "forest-trot", "forest-trot (3)",
                   "campus-trot", "forest-trot"}));
}

TEST_F(SeedScenes, TheSameSeedIsNoOther) {
  write("a/scene.json", scene_json(1).dump());
  write("b/scene.json", scene_json(1).dump());
  write("c/scene.json", scene_json(2).dump());
  EXPECT_EQ(seed_scenes({folder_ / "a", folder_ / "b", folder_ / "c"}),
            (Names{"forest-trot", "", "forest-trot"}));
}

TEST_F(SeedScenes, NoSeedChangesAFile) {
  const auto made = [&](const std::string& name, int seed, const json& route, bool of_file) {
    json scene = scene_json(seed);
    if (of_file) scene["scene"]["description"] = "from forest";
    scene["route_given"] = !of_file;
    scene["scene"]["route_m"] = route;
    write(name + "/scene.json", scene.dump());
    return folder_ / name;
  };
  const json one = {{0, 0, 0}, {1, 0, 0}}, other = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(seed_scenes({made("a", 1, one, true), made("b", 2, one, true)}),
            (Names{"forest-trot", "forest-trot (2)"}))
      << "other triangles";
  EXPECT_EQ(
      seed_scenes({made("c", 1, one, false), made("d", 2, one, false), made("e", 3, other, false)}),
      (Names{"forest-trot", "forest-trot", "forest-trot (2)"}));
}

TEST_F(SeedScenes, WhatTellsNothingIsOneOfAKind) {
  json nameless = scene_json(1);
  nameless["scene"].erase("name");
  json number = scene_json(1);
  number["scene"]["name"] = 7;
  write("none/gt.tum", "");
  write("empty/scene.json", "");
  write("list/scene.json", "[1, 2]");
  write("nameless/scene.json", nameless.dump());
  write("number/scene.json", number.dump());
  write("deep/scene.json", std::string(100'000, '['));
  for (const char* name : {"none", "empty", "list", "nameless", "number", "deep", "missing"}) {
    EXPECT_EQ(seed_scenes({folder_ / name}), Names{""}) << name;
  }
}

}  // namespace
}  // namespace surefoot::experiments
