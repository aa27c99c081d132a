// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/mesh_writer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

template <typename T>
void append_three(std::string& out, const T& values) {
  for (const auto value : values) append_bytes(out, value);
}

Eigen::Vector3f in_floats(const Eigen::Vector3d& values) { return values.cast<float>(); }

}  // namespace

std::string format_mesh_ply(const MeshView& mesh) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment Surefoot\nelement vertex " +
                    std::to_string(mesh.vertices.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(mesh.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& vertex : mesh.vertices) append_three(out, in_floats(vertex));
  for (const auto& triangle : mesh.triangles) {
    append_bytes(out, std::uint8_t{3});
    append_three(out, triangle);
  }
  return out;
}

std::string format_mesh_obj(const MeshView& mesh) {
  std::string out = "# Surefoot\n";
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    out += 'v';
    for (const double value : vertex) {
      out += ' ';
      append_fixed(out, value, 4);
    }
    out += '\n';
  }
  for (const auto& triangle : mesh.triangles) {
    out += 'f';
    for (const std::uint32_t corner : triangle) out += ' ' + std::to_string(corner + 1);
    out += '\n';
  }
  return out;
}

std::string format_mesh_stl(const MeshView& mesh) {
  std::string out = "Surefoot";
  out.resize(80, ' ');
  append_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& first = mesh.vertices[a];
    const Eigen::Vector3d normal =
        (mesh.vertices[b] - first).cross(mesh.vertices[c] - first).normalized();
    append_three(out, in_floats(normal));
    for (const std::uint32_t corner : {a, b, c}) {
      append_three(out, in_floats(mesh.vertices[corner]));
    }
    append_bytes(out, std::uint16_t{0});
  }
  return out;
}

MeshFormat mesh_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".ply") return MeshFormat::ply;
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".stl") return MeshFormat::stl;
  throw std::invalid_argument(file.string() + ": ends with '" + ending +
                              "', expected .ply, .obj or .stl for a mesh");
}

void write_mesh(const std::filesystem::path& file, const MeshView& mesh) {
  switch (mesh_format(file)) {
    case MeshFormat::ply:
      return write_whole_file(file, format_mesh_ply(mesh));
    case MeshFormat::obj:
      return write_whole_file(file, format_mesh_obj(mesh));
    case MeshFormat::stl:
      return write_whole_file(file, format_mesh_stl(mesh));
  }
}

}  // namespace surefoot::io
