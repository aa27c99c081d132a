// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Things that stand in more than one scene.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "simulation/random.hpp"
#include "simulation/triangle_mesh.hpp"

namespace surefoot::simulation {

/// Trunk, branches' mass as leaning leaves. @param counter picks the tree's shape.
void add_tree(TriangleMesh& mesh, const Eigen::Vector3d& foot, double height,
              const CounterRandom& random, std::uint64_t counter);
/// House of `storeys` with windows set back into its walls. Corners are of the ground plan.
void add_building(TriangleMesh& mesh, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                  int storeys, double ground = 0.0);
/// Pole with an arm.
void add_lamp(TriangleMesh& mesh, const Eigen::Vector3d& foot);
/// Seat, back and legs.
void add_bench(TriangleMesh& mesh, const Eigen::Vector3d& foot, double yaw);
/// Car of 4.3 m with cabin and wheels, in its own frame: x forward, origin on the ground.
[[nodiscard]] TriangleMesh make_car();
/// Standing person of 1.75 m, in its own frame: origin between the feet.
[[nodiscard]] TriangleMesh make_person();
/// `mesh` turned about the vertical and moved.
[[nodiscard]] TriangleMesh placed(TriangleMesh mesh, const Eigen::Vector3d& at, double yaw);

}  // namespace surefoot::simulation
