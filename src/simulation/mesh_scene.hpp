// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A scene, or a way through one, from a person's own file: PLY (ascii, binary little-endian),
// Wavefront OBJ, or an ESRI ascii grid of heights.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "simulation/scene.hpp"

namespace surefoot::simulation {

/// By the name's ending: .ply .obj .asc, in any case.
[[nodiscard]] bool is_mesh_file(const std::string& name);

/// @throws std::runtime_error that names the file, the place, what was seen and what was expected.
[[nodiscard]] TriangleMesh read_mesh(const std::filesystem::path& file);

/// Corners of a closed way [m], "x y z" a line, '#' comments.
/// @throws as read_mesh does.
[[nodiscard]] std::vector<Eigen::Vector3d> read_route(const std::filesystem::path& file);

/// @param route_file as above; empty: an ellipse over the middle of the mesh, on its topmost
/// surface.
/// @throws as read_mesh does.
[[nodiscard]] Scene mesh_scene(const std::filesystem::path& file,
                               const std::filesystem::path& route_file);

}  // namespace surefoot::simulation
