// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A scene: what stands still, what moves, and where the robot walks.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "simulation/layout.hpp"
#include "simulation/triangle_mesh.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::simulation {

/// A rigid thing that moves by itself: a walking person, a car.
struct MovingObject {
  TriangleMesh mesh;                         ///< in the object's own frame
  std::function<Pose(double)> T_map_object;  ///< by seconds since the recording's start
};

struct Scene {
  std::string name;
  std::string description;  ///< one line
  TriangleMesh mesh;        ///< everything that stands still, map frame
  std::vector<MovingObject> moving;
  /// Corners of the closed way that the robot walks, at ground height [m]; walked round and round.
  std::vector<Eigen::Vector3d> route;
  double corner_rounding = 0.5;  ///< how far the way is smoothed at its corners [m]
  std::string robot = "trot";    ///< the robot that suits the scene
  // For pictures: roofs and near walls hide rooms.
  double view_ceiling = 1e3;  ///< what is higher is left out [m]
  double view_front = -1e3;   ///< what has a smaller y is left out [m]
  double view_margin = 9.0;   ///< shown round the route [m]
};

/// A scene that the program brings along.
struct SceneEntry {
  std::string name;
  std::string description;
  Scene (*build)(const SceneSeeds& seeds);
};
/// All of them, in the order in which they are listed.
[[nodiscard]] const std::vector<SceneEntry>& scene_catalogue();
/// @throws std::invalid_argument that names the scenes there are.
[[nodiscard]] Scene build_scene(const std::string& name, const SceneSeeds& seeds);
/// Layout and things from the same seed.
[[nodiscard]] inline Scene build_scene(const std::string& name, std::uint64_t seed) {
  return build_scene(name, SceneSeeds::of(seed));
}

}  // namespace surefoot::simulation
