// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/mesh_writer.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <vector>

namespace surefoot::io {
namespace {

const std::vector<Eigen::Vector3d> kVertices = {
    {0.0, 0.0, 0.5}, {2.0, 0.0, 0.5}, {0.0, -1.25, 0.5}, {2.0, 1.0, 0.5}};
const std::vector<std::array<std::uint32_t, 3>> kTriangles = {{0, 1, 3}, {0, 2, 1}};
const MeshView kMesh{kVertices, kTriangles};

template <typename T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

TEST(MeshWriter, PlyHasVerticesAndFaces) {
  const std::string text = format_mesh_ply(kMesh);
  const std::string end = "end_header\n";
  const std::size_t data = text.find(end) + end.size();
  EXPECT_EQ(text.substr(0, data),
            "ply\nformat binary_little_endian 1.0\ncomment Surefoot\nelement vertex 4\n"
            "property float x\nproperty float y\nproperty float z\nelement face 2\n"
            "property list uchar int vertex_indices\nend_header\n");
  ASSERT_EQ(text.size(), data + 4 * 12 + 2 * 13);
  EXPECT_EQ(value_at<float>(text, data + 2 * 12 + 4), -1.25F);
  EXPECT_EQ(text[data + 48], 3);
  EXPECT_EQ(value_at<std::int32_t>(text, data + 48 + 1 + 8), 3);
}

TEST(MeshWriter, ObjCountsFromOne) {
  EXPECT_EQ(format_mesh_obj(kMesh),
            "# Surefoot\nv 0.0000 0.0000 0.5000\nv 2.0000 0.0000 0.5000\n"
            "v 0.0000 -1.2500 0.5000\nv 2.0000 1.0000 0.5000\nf 1 2 4\nf 1 3 2\n");
}

TEST(MeshWriter, ObjKeepsWhatLiesFarAway) {
  const std::vector<Eigen::Vector3d> far = {{500'000.1234, 5'400'000.5678, 0.0}};
  EXPECT_EQ(format_mesh_obj({far, {}}), "# Surefoot\nv 500000.1234 5400000.5678 0.0000\n");
}

TEST(MeshWriter, StlHasItsNormals) {
  const std::string bytes = format_mesh_stl(kMesh);
  ASSERT_EQ(bytes.size(), 84U + 2 * 50);
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 80), 2U);
  for (const std::size_t triangle : {84U, 134U}) {
    EXPECT_EQ(value_at<float>(bytes, triangle + 8), 1.0F) << "both look up";
  }
  EXPECT_EQ(value_at<float>(bytes, 84 + 12 + 2 * 12 + 4), 1.0F);
}

TEST(MeshWriter, TheEndingIsTheFormat) {
  EXPECT_EQ(mesh_format("a/b.ply"), MeshFormat::ply);
  EXPECT_EQ(mesh_format("B.OBJ"), MeshFormat::obj);
  EXPECT_EQ(mesh_format("b.Stl"), MeshFormat::stl);
  for (const char* other : {"b", "ply", "b.dae", "b.ply.gz", ""}) {
    EXPECT_THROW(static_cast<void>(mesh_format(other)), std::invalid_argument) << other;
  }
}

}  // namespace
}  // namespace surefoot::io
