// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/mesh_scene.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "simulation/mesh_file.hpp"
#include "simulation/ray_caster.hpp"

namespace surefoot::simulation {

namespace {

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// An ellipse over the middle half of the mesh, on whatever is topmost there.
std::vector<Eigen::Vector3d> ellipse_route(const std::filesystem::path& file, const Scene& scene) {
  constexpr int kCorners = 64;
  Eigen::Vector3f low = scene.mesh.vertices.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& vertex : scene.mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const Eigen::Vector3d centre = 0.5 * (low + high).cast<double>();
  const Eigen::Vector3d half = 0.25 * (high - low).cast<double>();
  const RayCaster rays(scene);
  const double top = static_cast<double>(high.z()) + 1.0;
  std::vector<Eigen::Vector3d> route;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    Eigen::Vector3d corner(centre.x() + half.x() * std::cos(angle),
                           centre.y() + half.y() * std::sin(angle), top);
    const auto ground = rays.ground_below(corner, top - static_cast<double>(low.z()) + 2.0);
    if (!ground) {
      fail(file, "there is no ground under a way round its middle; give one with --route");
    }
    corner.z() = *ground;
    route.push_back(corner);
  }
  return route;
}

}  // namespace

bool is_mesh_file(const std::string& name) {
  const std::string ending = ending_of(name);
  return ending == ".ply" || ending == ".obj" || ending == ".asc";
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending == ".ply") return read_ply(file);
  if (ending == ".obj") return read_obj(file);
  if (ending == ".asc") return read_ascii_grid(file);
  fail(file, "ends in '" + ending + "', expected .ply, .obj or .asc");
}

std::vector<Eigen::Vector3d> read_route(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::string_view rest = text;
  std::vector<Eigen::Vector3d> route;
  while (!rest.empty()) {
    std::string_view line = take_line(rest);
    Words words(file, line.substr(0, line.find('#')));
    if (words.at_end()) continue;
    Eigen::Vector3d corner;
    for (int axis = 0; axis < 3; ++axis) corner(axis) = words.number("a corner's coordinate");
    if (!words.at_end()) fail(file, "got '" + std::string(line) + "', expected a corner's x y z");
    route.push_back(corner);
  }
  if (route.size() < 3) {
    fail(file, "a closed way needs 3 corners at least, there are " + std::to_string(route.size()));
  }
  return route;
}

Scene mesh_scene(const std::filesystem::path& file, const std::filesystem::path& route_file) {
  Scene scene;
  scene.name = file.filename().string();
  scene.description = "from " + scene.name;
  scene.mesh = read_mesh(file);
  scene.route = route_file.empty() ? ellipse_route(file, scene) : read_route(route_file);
  return scene;
}

}  // namespace surefoot::simulation
