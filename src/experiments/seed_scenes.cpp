// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/seed_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace surefoot::experiments {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

struct Scene {
  std::string name;  ///< empty: not known
  std::string all;   ///< everything by which a recording was made, but for the seed
  std::string seed;
};

/// As the simulation describes a scene that was read from a file: no seed changes it.
bool is_of_file(const Json& scene) {
  return scene.value("description", "") == "from " + scene.at("name").get<std::string>();
}

/// Of what scene.json holds, the seed changes the number of triangles and the route, too, unless
/// the scene, or the route, was given as a file.
Scene scene_of(const fs::path& recording) {
  const fs::path folder = fs::is_directory(recording) ? recording : recording.parent_path();
  std::ifstream stream(folder / "scene.json");
  const Json json = Json::parse(stream, nullptr, false);
  try {
    Json all = {{"scene", json.at("scene").at("name")},
                {"robot", json.at("robot")},
                {"lidar", json.at("lidar")}};
    for (const char* key :
         {"scans", "gait_scale", "mount", "rays_per_beam", "dual_return", "robot_body_in_view"}) {
      all[key] = json.at(key);
    }
    for (const char* key : {"rain", "dust", "people"}) all[key] = json.value(key, 0.0);
    const Json& scene = json.at("scene");
    const bool of_file = is_of_file(scene), route_given = json.value("route_given", false);
    if (of_file) all["triangles"] = scene.at("triangles");
    if (of_file || route_given) all["route_m"] = scene.at("route_m");
    return {fmt::format("{}-{}", json.at("scene").at("name").get<std::string>(),
                        json.at("robot").at("name").get<std::string>()),
            all.dump(-1, ' ', false, Json::error_handler_t::replace), json.at("seed").dump()};
  } catch (const Json::exception&) {
    return {};  // another program's scene.json, or none
  }
}

}  // namespace

std::vector<std::string> seed_scenes(const std::vector<fs::path>& recordings) {
  std::map<std::string, std::vector<std::string>> known;  // by name: the different ways to make it
  std::set<std::array<std::string, 2>> seeds;             // of each name
  std::vector<std::string> names;
  for (const fs::path& recording : recordings) {
    Scene scene = scene_of(recording);
    if (!scene.name.empty()) {
      std::vector<std::string>& ways = known[scene.name];
      const auto way = std::find(ways.begin(), ways.end(), scene.all);
      const auto number = static_cast<std::size_t>(way - ways.begin()) + 1;
      if (way == ways.end()) ways.push_back(scene.all);
      if (number > 1) scene.name += fmt::format(" ({})", number);
      if (!seeds.insert({scene.name, scene.seed}).second) scene.name.clear();  // no other seed
    }
    names.push_back(std::move(scene.name));
  }
  return names;
}

}  // namespace surefoot::experiments
