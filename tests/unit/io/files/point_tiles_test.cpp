// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/point_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "io/file_writer.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string tile_content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <typename T>
T number_at(const std::string& bytes, std::size_t place) {
  T value{};
  std::memcpy(&value, bytes.data() + place, sizeof(T));
  return value;
}

/// What a reader of glTF makes of a tile: its points, z up as 3D Tiles turn them.
std::vector<Eigen::Vector3d> points_of_glb(const std::string& glb) {
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(number_at<std::uint32_t>(glb, 4), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(glb, 8), glb.size());
  const auto head = number_at<std::uint32_t>(glb, 12);
  EXPECT_EQ(head % 4, 0U);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  EXPECT_EQ(glb.substr(24 + head, 4), std::string("BIN\0", 4));
  const json gltf = json::parse(glb.substr(20, head));
  const std::size_t bin = 28 + head;
  EXPECT_EQ(number_at<std::uint32_t>(glb, 20 + head), glb.size() - bin);
  EXPECT_EQ(gltf["buffers"][0]["byteLength"], glb.size() - bin);
  EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["mode"], 0);
  const json& positions = gltf["accessors"][0];
  EXPECT_EQ(gltf["accessors"][1]["count"], positions["count"]);
  const json& node = gltf["nodes"][0];
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < positions["count"].get<std::size_t>(); ++i) {
    Eigen::Vector3d at;
    for (int axis = 0; axis < 3; ++axis) {
      const auto step =
          number_at<std::uint16_t>(glb, bin + 8 * i + 2 * static_cast<std::size_t>(axis));
      EXPECT_GE(step, positions["min"][axis].get<int>());
      EXPECT_LE(step, positions["max"][axis].get<int>());
      at[axis] = step * node["scale"][axis].get<double>() + node["translation"][axis].get<double>();
    }
    points.emplace_back(at.x(), -at.z(), at.y());
  }
  return points;
}

/// All points of a tile and of those below it, each within its tile's box.
struct TileWalk {
  fs::path folder;
  std::vector<Eigen::Vector3d> points;
  std::size_t tiles = 0;

  std::vector<Eigen::Vector3d> visit(const json& tile, double error_above) {
    ++tiles;
    const double error = tile["geometricError"];
    EXPECT_LT(error, error_above);
    std::vector<Eigen::Vector3d> below =
        points_of_glb(tile_content(folder / tile["content"]["uri"].get<std::string>()));
    EXPECT_FALSE(below.empty());
    points.insert(points.end(), below.begin(), below.end());
    EXPECT_EQ(tile.contains("children"), error > 0.0);
    for (const json& child : tile.value("children", json::array())) {
      const std::vector<Eigen::Vector3d> found = visit(child, error);
      below.insert(below.end(), found.begin(), found.end());
    }
    const std::vector<double> box = tile["boundingVolume"]["box"];
    for (const Eigen::Vector3d& point : below) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        EXPECT_LE(std::abs(point[axis] - box[i]), box[3 + 4 * i]);
      }
    }
    return below;
  }
};

/// A hilly square of ground, denser in one corner, so that branches differ in depth.
std::vector<Eigen::Vector3f> hills(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float scale = i % 2 == 0 ? 400.0F : 40.0F;
    const float x = scale * uniform(random), y = scale * uniform(random);
    points.emplace_back(x, y, 3.0F * std::sin(0.05F * x) + uniform(random));
  }
  return points;
}

bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

TEST(PointTilesTest, EveryPointIsInOneTileAndWithinAllBoxesAboveIt) {
  const test::TemporaryFolder scratch;
  const std::vector<Eigen::Vector3f> given = hills(250'000);
  std::vector<Eigen::Vector3f> tiled = given;
  const TileCounts counts = write_point_tiles(scratch.path() / "tiles", {100.0, -50.0, 7.0}, tiled);
  const json tileset = json::parse(tile_content(scratch.path() / "tiles/tileset.json"));
  EXPECT_EQ(tileset["asset"]["version"], "1.1");
  EXPECT_EQ(tileset["root"]["refine"], "ADD");
  TileWalk walk{scratch.path() / "tiles", {}, 0};
  walk.visit(tileset["root"], tileset["geometricError"]);
  EXPECT_EQ(walk.tiles, counts.tiles);
  EXPECT_GE(counts.levels, 3);
  EXPECT_EQ(counts.points, given.size());
  ASSERT_EQ(walk.points.size(), given.size());
  // A point is moved by no more than half a step of the largest cube; so sums of all agree.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), expected = sum;
  for (const Eigen::Vector3d& point : walk.points) sum += point;
  for (const Eigen::Vector3f& point : given) expected += point.cast<double>();
  EXPECT_LT((sum - expected).cwiseAbs().maxCoeff() / static_cast<double>(given.size()), 1e-4);
  std::sort(walk.points.begin(), walk.points.end(), before);
  for (std::size_t i = 0; i < given.size(); i += 997) {
    const Eigen::Vector3d point = given[i].cast<double>();
    const auto from = std::lower_bound(walk.points.begin(), walk.points.end(),
                                       Eigen::Vector3d(point.x() - 0.004, -1e9, -1e9), before);
    const bool found = std::any_of(from, walk.points.end(), [&](const Eigen::Vector3d& other) {
      return (other - point).cwiseAbs().maxCoeff() < 0.004;
    });
    EXPECT_TRUE(found) << point.transpose();
  }
}

TEST(PointTilesTest, TheTransformIsTheOrigins) {
  const test::TemporaryFolder scratch;
  std::vector<Eigen::Vector3f> one{{1.0F, 2.0F, 3.0F}};
  write_point_tiles(scratch.path() / "tiles", {100.0, -50.0, 7.0}, one);
  const json tileset = json::parse(tile_content(scratch.path() / "tiles/tileset.json"));
  const std::vector<double> transform = tileset["root"]["transform"];
  EXPECT_EQ(transform, (std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100, -50, 7, 1}));
  const std::vector<Eigen::Vector3d> points =
      points_of_glb(tile_content(scratch.path() / "tiles/tiles/r.glb"));
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT((points[0] - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-4);
}

TEST(PointTilesTest, APlaceOnTheEarthTurnsTheMapsAxes) {
  // At the equator and the meridian of Greenwich: up is x, east y, north z.
  const Eigen::Matrix4d T = T_earth_map({0.0, 0.0, 10.0, 90.0});
  Eigen::Matrix4d expected;
  expected << 0, 0, 1, 6378147, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1;
  EXPECT_LT((T - expected).cwiseAbs().maxCoeff(), 1e-6);
  // At the pole, by the ellipsoid's other axis; x to the north.
  EXPECT_NEAR(T_earth_map({90.0, 0.0, 0.0, 0.0})(2, 3), 6356752.3142, 1e-3);
  EXPECT_NEAR(T_earth_map({0.0, 0.0, 0.0, 0.0})(2, 0), 1.0, 1e-12);
}

TEST(PointTilesTest, NothingAndManyInOnePlaceAndFoldersInUse) {
  const test::TemporaryFolder scratch;
  EXPECT_THROW(write_point_tiles(scratch.path() / "none", {0, 0, 0}, {}), std::invalid_argument);
  EXPECT_FALSE(fs::exists(scratch.path() / "none"));
  std::vector<Eigen::Vector3f> same(100'000, Eigen::Vector3f(5.0F, 5.0F, 5.0F));
  EXPECT_EQ(write_point_tiles(scratch.path() / "same", {0, 0, 0}, same).points, same.size());
  EXPECT_THROW(write_point_tiles(scratch.path() / "same", {0, 0, 0}, same), WriteError);
}

}  // namespace
}  // namespace surefoot::io
