// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What grows and lies about on ground that nobody built, leaf by leaf. The robot's way stays
// passable: no trunk on it, and nothing at the height of its sensor.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "simulation/scene.hpp"
#include "simulation/scenes/terrain.hpp"

namespace surefoot::simulation {

/// How many things stand on a square metre, by the distance from the robot's way [m].
using Density = std::function<double(double distance)>;

/// `near` a square metre up to `reach` metres from the way, falling to `far` over as much again.
[[nodiscard]] Density thinning_out(double near, double far, double reach);
/// None on the way and `margin` metres beside it.
[[nodiscard]] Density beside_way(double density, double margin);

class Vegetation {
 public:
  /// Plants on a square of twice `half` metres round the middle, on `ground`, round the scene's
  /// route. @param seed draws every plant.
  Vegetation(Scene& scene, const Terrain& ground, double half, std::uint64_t seed);

  /// Single blades, wider where they are fewer. @param tallest [m], away from the way.
  void add_grass(const Density& density, double tallest);
  /// Knee-high plants of a few big leaves.
  void add_herbs(const Density& density, double tallest);
  /// Balls of leaves on twigs; those near the way sway.
  void add_bushes(const Density& density, double tallest);
  /// Trunk, boughs, crown; crowns near the way sway.
  void add_trees(const Density& density, double tallest);
  /// Trunks without crowns, leaning and lying.
  void add_dead_wood(const Density& density);
  /// @param largest radius [m]; on the way as small as a foot can stand on.
  void add_stones(const Density& density, double largest);
  /// Leaves of a hedge between two places, cut 0.6 m wide.
  void add_hedge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
                 std::uint64_t number);
  /// A root that crosses the way: a low ridge that winds.
  void add_root(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius,
                std::uint64_t number);

 private:
  class Draw;
  using Plant = std::function<void(const Eigen::Vector3d& foot, double distance, const Draw& draw)>;

  void for_each(std::uint64_t kind, const Density& density, const Plant& plant) const;
  /// What may grow this far from the way [m]: low on it, so that the sensor passes above.
  [[nodiscard]] static double allowed_height(double distance, double tallest);
  void add_swaying(TriangleMesh mesh, const Eigen::Vector3d& foot, double tilt, double hertz,
                   const Draw& draw);

  Scene* scene_;
  Terrain ground_;
  double half_;
  std::uint64_t seed_;
};

}  // namespace surefoot::simulation
