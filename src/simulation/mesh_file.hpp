// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the readers of mesh files share: the file's text, its words, and vertices and faces checked
// as they come in. read_mesh() in mesh_scene.hpp is the way in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/triangle_mesh.hpp"

namespace surefoot::simulation {

/// @throws std::runtime_error "FILE: what".
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what);
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// Words of a text, separated by white space.
class Words {
 public:
  Words(const std::filesystem::path& file, std::string_view text) : file_(file), rest_(text) {}
  /// Empty at the end.
  std::string_view next();
  /// @throws for a word that is not a finite number. @param what is named in the message.
  double number(const std::string& what);
  [[nodiscard]] bool at_end();

 private:
  void skip_space();
  std::filesystem::path file_;
  std::string_view rest_;
};

/// The line up to the next line feed, without it and without a carriage return before it; `text`
/// goes on after it.
std::string_view take_line(std::string_view& text);

/// Collects a mesh and refuses what no mesh can be.
class MeshCollector {
 public:
  explicit MeshCollector(const std::filesystem::path& file) : file_(file) {}
  /// Coordinates must be finite and within 100 km: beyond, single precision is not exact enough.
  void add_vertex(const Eigen::Vector3d& vertex);
  /// A convex polygon, cut into triangles. Indices from 0.
  void add_polygon(const std::vector<std::int64_t>& corners);
  /// @throws where there is not one triangle.
  [[nodiscard]] TriangleMesh finish();

 private:
  std::filesystem::path file_;
  TriangleMesh mesh_;
};

[[nodiscard]] TriangleMesh read_ply(const std::filesystem::path& file);
[[nodiscard]] TriangleMesh read_obj(const std::filesystem::path& file);
[[nodiscard]] TriangleMesh read_ascii_grid(const std::filesystem::path& file);

}  // namespace surefoot::simulation
