// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "simulation/mesh_scene.hpp"
#include "support.hpp"
#include "support/scratch.hpp"

namespace surefoot::simulation::test {
namespace {

class MeshFileTest : public surefoot::test::Scratch {
 protected:
  void expect_refused(const std::string& name, const std::string& content,
                      const std::string& reason) {
    try {
      (void)read_mesh(write(name, content));
      ADD_FAILURE() << "accepted: " << content.substr(0, 80);
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
};

TEST_F(MeshFileTest, ReadsObjWithEveryKindOfCorner) {
  const TriangleMesh mesh = read_mesh(write(
      "a.OBJ",
      "# made by hand\r\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nvn 0 0 1\nf 1/1 2//1 3/1/1 -1\n"));
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.triangles[1], (Eigen::Matrix<std::uint32_t, 3, 1>(0, 2, 3)));
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3f(1, 1, 0.5));
}

TEST_F(MeshFileTest, ReadsPlyAsTextAndAsBytes) {
  const std::string elements =
      "element vertex 3\nproperty float x\nproperty double y\nproperty uchar red\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const TriangleMesh text = read_mesh(write(
      "t.ply", "ply\nformat ascii 1.0\n" + elements + "0 0 9 0\n2 0 9 0\n0 3 9 1.5\n3 0 1 2\n"));
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment x\n" + elements;
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (const auto& [x, y, z] : {std::array{0., 0., 0.}, {2., 0., 0.}, {0., 3., 1.5}}) {
    put(static_cast<float>(x));
    put(y);
    put(std::uint8_t{9});
    put(static_cast<float>(z));
  }
  put(std::uint8_t{3});
  for (const std::int32_t corner : {0, 1, 2}) put(corner);
  const TriangleMesh binary = read_mesh(write("b.ply", bytes));
  EXPECT_EQ(text.vertices, binary.vertices);
  EXPECT_EQ(text.triangles, binary.triangles);
  EXPECT_EQ(binary.vertices[2], Eigen::Vector3f(0, 3, 1.5));
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
    EXPECT_THROW((void)read_mesh(write("cut.ply", bytes.substr(0, cut))), std::runtime_error);
  }
}

TEST_F(MeshFileTest, ReadsAGridFromNorthToSouthAndLeavesHolesOut) {
  const TriangleMesh mesh = read_mesh(
      write("g.asc",
            "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4e6\ncellsize 2\nNODATA_value -1\n"
            "5 6 7\n1 2 -1\n"));
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3f(0, 2, 5));
  EXPECT_EQ(mesh.vertices[4], Eigen::Vector3f(2, 0, 2));
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST_F(MeshFileTest, RefusesWhatIsNoMeshAndSaysWhy) {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertex =
      "element vertex 1\nproperty float x\nproperty float y\n"
      "property float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expect_refused("a.ply", "", "does not begin with 'ply'");
  expect_refused("b.ply", "ply\nformat binary_big_endian 1.0\nend_header\n", "binary_big_endian");
  expect_refused("c.ply", head + vertex, "end_header");
  expect_refused("d.ply", head + "property float x\nend_header\n", "before the first element");
  expect_refused("e.ply", head + "element vertex 1e18\nproperty float x\nend_header\n", "claims");
  expect_refused("f.ply", head + "element vertex -3\nproperty float x\nend_header\n", "claims");
  expect_refused("g.ply", head + vertex + face + "0 0 0\n3 0 0 7\n", "names vertex 7 of 1");
  expect_refused("h.ply", head + vertex + face + "0 0 0\n3 0 0 -2\n", "names vertex -2");
  expect_refused("i.ply", head + vertex + face + "0 0 0\n4000000000 0\n", "expected 0 to 1000");
  expect_refused("j.ply", head + vertex + face + "0 nan 0\n3 0 0 0\n", "a number");
  expect_refused("k.ply", head + vertex + face + "0 x 0\n", "there is 'x'");
  expect_refused("l.ply", head + vertex + "end_header\n0 0 0\n", "no face");
  expect_refused("m.ply", head + "element vertex 1\nproperty float x\nend_header\n1\n",
                 "within 100 km");
  expect_refused("n.ply",
                 "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
                 "property half x\nend_header\nabcdefgh",
                 "'half'");
  expect_refused("a.obj", "v 0 0\n", "a number");
  expect_refused("b.obj", "v 0 0 0\nf 1 2 3\n", "names vertex 1 of 1");
  expect_refused("c.obj", "v 0 0 0\nf 0 1 1\n", "the number of a vertex");
  expect_refused("d.obj", "v 0 0 0\nf a b c\n", "'a'");
  expect_refused("e.obj", "v 0 0 1e9\n", "within 100 km");
  expect_refused("f.obj", "v 0 0 0\nf -5 1 1\n", "names vertex -4");
  expect_refused("a.asc", "", "ncols");
  expect_refused("b.asc", "ncols 2\nnrows 2\ncellsize 0\n1 2 3 4\n", "cellsize");
  expect_refused("c.asc", "ncols 1e9\nnrows 1e9\ncellsize 1\n1 2\n", "can hold");
  expect_refused("d.asc", "ncols 2\nnrows 2\ncellsize 1\n1 2 3\n", "a height");
  expect_refused("e.asc", "ncols 2.5\nnrows 2\ncellsize 1\n1 2 3\n", "ncols");
  EXPECT_THROW((void)read_mesh(folder_ / "none.ply"), std::runtime_error);
}

TEST_F(MeshFileTest, SaysWhatIsNoRegularFile) {
  const auto message_of = [&](const std::string& name) {
    try {
      (void)read_mesh(folder_ / name);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  ASSERT_EQ(mkfifo((folder_ / "pipe.ply").c_str(), 0600), 0);  // reading it would wait for ever
  EXPECT_NE(message_of("pipe.ply").find("pipe.ply: it is a pipe"), std::string::npos);
  std::filesystem::create_directory(folder_ / "folder.obj");
  EXPECT_NE(message_of("folder.obj").find("folder.obj: it is a folder"), std::string::npos);
  EXPECT_NE(message_of("none.asc").find("none.asc: No such file"), std::string::npos);
}

TEST_F(MeshFileTest, AMeshBecomesASceneWithAWayOnIt) {
  std::string grid = "ncols 30\nnrows 30\ncellsize 1\n";
  for (int i = 0; i < 900; ++i) grid += std::to_string(0.01 * (i % 30)) + " ";
  const auto file = write("hill.asc", grid);
  const Scene scene = mesh_scene(file, {});
  const RayCaster rays(scene);
  EXPECT_NO_THROW((void)make_motion(scene, rays, gait_model("trot"), 3.0, 1, kMount));
  EXPECT_NEAR(scene.route[0].z(), 0.01 * scene.route[0].x(), 1e-4);
  const Scene own = mesh_scene(file, write("way.txt", "# way\n5 5 0\n9 5 0 # corner\n\n9 9 0\n"));
  EXPECT_EQ(own.route.size(), 3U);
  EXPECT_THROW((void)mesh_scene(file, write("short.txt", "1 2 3\n")), std::runtime_error);
  EXPECT_THROW((void)mesh_scene(file, write("wide.txt", "5 5 0\n9 5 0 7\n9 9 0\n")),
               std::runtime_error);
  EXPECT_THROW((void)mesh_scene(file, write("bad.txt", "1 2\n")), std::runtime_error);
}

}  // namespace
}  // namespace surefoot::simulation::test
