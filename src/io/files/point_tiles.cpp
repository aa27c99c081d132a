// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/point_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file_writer.hpp"
#include "io/files/glb_points.hpp"

namespace surefoot::io {

namespace {

constexpr int kTileCells = 64;              // an axis: a tile above others has one point a cell
constexpr std::size_t kLeafPoints = 40000;  // so many are not split any more
constexpr float kLeastEdge = 0.05F;         // nor cubes as small as this [m]
// Viewers refine where an error is more than 16 pixels: then points lie 4 pixels apart.
constexpr double kErrorPerSpacing = 4.0;

struct TileCube {
  Eigen::Vector3f low;
  float edge = 0.0F;
};

TileCube cube_of(std::span<const Eigen::Vector3f> points) {
  if (points.empty()) throw std::invalid_argument("a map without points, for 3D Tiles");
  Eigen::Vector3f low = points.front(), high = points.front();
  for (const Eigen::Vector3f& point : points) {
    if (!point.allFinite()) throw std::invalid_argument("a point that is not finite, for 3D Tiles");
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {low, std::max((high - low).maxCoeff(), 1.0F) * 1.0001F};
}

/// Between which heights most points lie: a few high ones would leave the others in one colour.
std::array<float, 2> usual_heights(std::span<const Eigen::Vector3f> points) {
  std::vector<float> heights;
  const std::size_t every = points.size() / 100'000 + 1;
  for (std::size_t i = 0; i < points.size(); i += every) heights.push_back(points[i].z());
  std::sort(heights.begin(), heights.end());
  const std::size_t last = heights.size() - 1;
  return {heights[last / 100], heights[last - last / 50]};
}

/// Brings one point a cell to the front, and says how many they are.
std::size_t bring_sample_forward(std::span<Eigen::Vector3f> points, const TileCube& cube) {
  std::vector<bool> taken(static_cast<std::size_t>(kTileCells) * kTileCells * kTileCells, false);
  std::size_t front = 0;
  for (Eigen::Vector3f& point : points) {
    const Eigen::Vector3i cell = ((point - cube.low) * (kTileCells / cube.edge))
                                     .cast<int>()
                                     .cwiseMax(0)
                                     .cwiseMin(kTileCells - 1);
    const auto index =
        static_cast<std::size_t>((cell.x() * kTileCells + cell.y()) * kTileCells + cell.z());
    if (taken[index]) continue;
    taken[index] = true;
    std::swap(points[front++], point);
  }
  return front;
}

void append_numbers(std::string& json, std::span<const double> values) {
  json += '[';
  for (const double& value : values) {
    if (&value != values.data()) json += ',';
    append_fixed(json, value, 6);
  }
  json += ']';
}

class TileTree {
 public:
  TileTree(std::filesystem::path folder, std::array<float, 2> heights)
      : folder_(std::move(folder)), heights_(heights) {}

  void add(std::span<Eigen::Vector3f> points, const TileCube& cube, const std::string& name,
           int level, const Eigen::Matrix4d* transform = nullptr) {
    const bool leaf = points.size() <= kLeafPoints || cube.edge < kLeastEdge;
    json_ += "{";
    append_box(points, cube);
    json_ += R"(,"geometricError":)";
    append_fixed(json_, leaf ? 0.0 : error_of(cube), 6);
    if (transform != nullptr) {
      json_ += R"(,"refine":"ADD","transform":)";
      append_numbers(json_, {transform->data(), 16});
    }
    json_ += R"(,"content":{"uri":"tiles/)" + name + R"(.glb"})";
    const std::size_t own = leaf ? points.size() : bring_sample_forward(points, cube);
    write_whole_file(folder_ / "tiles" / (name + ".glb"),
                     format_glb({points.first(own), cube.low, cube.edge, heights_}));
    ++counts_.tiles;
    counts_.points += own;
    counts_.levels = std::max(counts_.levels, level);
    if (own < points.size()) add_children(points.subspan(own), cube, name, level + 1);
    json_ += '}';
  }
  static double error_of(const TileCube& cube) {
    return kErrorPerSpacing * static_cast<double>(cube.edge) / kTileCells;
  }
  [[nodiscard]] const std::string& json() const { return json_; }
  [[nodiscard]] const TileCounts& counts() const { return counts_; }

 private:
  void add_children(std::span<Eigen::Vector3f> points, const TileCube& cube,
                    const std::string& name, int level) {
    const float half = 0.5F * cube.edge;
    const Eigen::Vector3f middle = cube.low.array() + half;
    json_ += R"(,"children":[)";
    bool first = true;
    for (int octant = 0; octant < 8; ++octant) {
      const auto inside = [&](const Eigen::Vector3f& point) {
        const int x = point.x() < middle.x() ? 0 : 1;
        const int y = point.y() < middle.y() ? 0 : 2;
        const int z = point.z() < middle.z() ? 0 : 4;
        return x + y + z == octant;
      };
      const auto end = std::partition(points.begin(), points.end(), inside);
      const auto count = static_cast<std::size_t>(end - points.begin());
      if (count == 0) continue;
      if (!first) json_ += ',';
      first = false;
      const Eigen::Vector3f corner(octant & 1 ? half : 0.0F, octant & 2 ? half : 0.0F,
                                   octant & 4 ? half : 0.0F);
      add(points.first(count), {cube.low + corner, half}, name + static_cast<char>('0' + octant),
          level);
      points = points.subspan(count);
    }
    json_ += ']';
  }

  /// About all points, those of the tiles below among them; rounding moves them by half a step.
  void append_box(std::span<const Eigen::Vector3f> points, const TileCube& cube) {
    Eigen::Vector3f low = points.front(), high = points.front();
    for (const Eigen::Vector3f& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const Eigen::Vector3d middle = 0.5 * (low + high).cast<double>();
    const Eigen::Vector3d half = (0.5 * (high - low).cast<double>()).array() +
                                 static_cast<double>(cube.edge) / 65535.0 + 1e-5;
    json_ += R"("boundingVolume":{"box":)";
    append_numbers(json_, std::array{middle.x(), middle.y(), middle.z(), half.x(), 0.0, 0.0, 0.0,
                                     half.y(), 0.0, 0.0, 0.0, half.z()});
    json_ += '}';
  }

  std::filesystem::path folder_;
  std::array<float, 2> heights_;
  std::string json_;
  TileCounts counts_;
};

}  // namespace

Eigen::Matrix4d T_earth_map(const EarthPlace& place) {
  constexpr double kRadius = 6378137.0, kFlattening = 1.0 / 298.257223563;  // WGS84
  constexpr double kSquared = kFlattening * (2.0 - kFlattening);
  constexpr double kDegrees = std::numbers::pi / 180.0;
  const double latitude = place.latitude_deg * kDegrees, longitude = place.longitude_deg * kDegrees;
  const double s = std::sin(latitude), c = std::cos(latitude);
  const double across = kRadius / std::sqrt(1.0 - kSquared * s * s);
  const Eigen::Vector3d along(std::cos(longitude), std::sin(longitude), 0.0);
  const Eigen::Vector3d east(-along.y(), along.x(), 0.0);
  const Eigen::Vector3d north = -s * along + c * Eigen::Vector3d::UnitZ();
  const double azimuth = place.azimuth_deg * kDegrees;
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.block<3, 1>(0, 0) = std::sin(azimuth) * east + std::cos(azimuth) * north;
  T.block<3, 1>(0, 1) = -std::cos(azimuth) * east + std::sin(azimuth) * north;
  T.block<3, 1>(0, 2) = c * along + s * Eigen::Vector3d::UnitZ();
  T.block<3, 1>(0, 3) = (across + place.height) * c * along;
  T(2, 3) = (across * (1.0 - kSquared) + place.height) * s;
  return T;
}

void require_tiles_folder(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return;
  if (std::filesystem::is_directory(folder) && std::filesystem::is_empty(folder)) return;
  throw WriteError(folder.string() +
                   ": is there already; tiles need a new or an empty folder, whatever may be "
                   "written over");
}

TileCounts write_point_tiles(const std::filesystem::path& folder, const Eigen::Vector3d& origin,
                             std::span<Eigen::Vector3f> points,
                             const std::optional<EarthPlace>& place) {
  const TileCube cube = cube_of(points);
  require_tiles_folder(folder);
  UnfinishedOutput output(folder, true);
  std::filesystem::create_directory(output.path() / "tiles");
  Eigen::Matrix4d T_root_points = place ? T_earth_map(*place) : Eigen::Matrix4d::Identity();
  T_root_points.col(3) = T_root_points * origin.homogeneous();
  TileTree tree(output.path(), usual_heights(points));
  tree.add(points, cube, "r", 1, &T_root_points);
  std::string json = R"({"asset":{"version":"1.1"},"geometricError":)";
  append_fixed(json, 2.0 * TileTree::error_of(cube), 6);
  json += R"(,"root":)" + tree.json() + "}\n";
  write_whole_file(output.path() / "tileset.json", json);
  output.finish();
  return tree.counts();
}

}  // namespace surefoot::io
