// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace surefoot::io {

/// Vertices [m] and triangles of their indices; nothing is copied.
struct MeshView {
  std::span<const Eigen::Vector3d> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
};

/// PLY 1.0, little-endian, vertices in floats.
[[nodiscard]] std::string format_mesh_ply(const MeshView& mesh);
/// Wavefront OBJ, to a tenth of a millimetre.
[[nodiscard]] std::string format_mesh_obj(const MeshView& mesh);
/// Binary STL, vertices in floats, each triangle with its normal.
[[nodiscard]] std::string format_mesh_stl(const MeshView& mesh);

enum class MeshFormat { ply, obj, stl };
/// By the name's ending, in any case. Throws std::invalid_argument for another one.
[[nodiscard]] MeshFormat mesh_format(const std::filesystem::path& file);
/// In the format of its name's ending. Throws as mesh_format() does, and WriteError.
void write_mesh(const std::filesystem::path& file, const MeshView& mesh);

}  // namespace surefoot::io
