// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/grid_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::mapping {
namespace {

/// A room of 8 x 6 m about the LiDAR, its floor 0.4 m below.
Piece room() {
  Piece piece;
  piece.eyes = {Eigen::Vector3f::Zero()};
  for (int i = -40; i <= 40; ++i) {
    for (int j = -30; j <= 30; ++j) {
      const double x = 0.1 * i, y = 0.1 * j;
      piece.points.emplace_back(x, y, -0.4);
      const bool wall = std::abs(i) == 40 || std::abs(j) == 30;
      for (double z = -0.3; wall && z < 1.5; z += 0.1) piece.points.emplace_back(x, y, z);
    }
  }
  piece.seen_from.assign(piece.points.size(), 0);
  return piece;
}

std::uint8_t cell_at(const OccupancyGrid& grid, double x, double y) {
  return grid.at(static_cast<int>((x - grid.low.x()) / grid.cell),
                 static_cast<int>((y - grid.low.y()) / grid.cell));
}

TEST(OccupancyGridTest, WallsAreOccupiedAndTheRoomIsFree) {
  Piece piece = room();
  // Not on the cells' borders, where the last bit would decide.
  piece.T_world_piece.translation = {100.03, -49.97, 7.0};
  const OccupancyGrid grid = draw_occupancy({piece}, {});
  EXPECT_EQ(cell_at(grid, 101.03, -50.47), OccupancyGrid::kFree);
  EXPECT_EQ(cell_at(grid, 104.03, -49.97), OccupancyGrid::kOccupied);
  EXPECT_EQ(cell_at(grid, 96.03, -50.97), OccupancyGrid::kOccupied);
}

// A LiDAR in a hand, 1.7 m above the floor, sees that behind a wall of 1 m, and a ceiling: beams
// that go over what a robot is as high as go through nothing that stops it.
TEST(OccupancyGridTest, AWallThatIsLookedOverStays) {
  constexpr float kFloor = -1.7F, kWall = 3.0F, kSeenFrom = 10.3F;
  Piece piece;
  piece.eyes = {Eigen::Vector3f::Zero()};
  for (int i = -40; i <= 40; ++i) {
    const float slope = 0.02F * static_cast<float>(i);
    for (int j = 2; j <= 10; ++j) {
      piece.points.emplace_back(kWall, slope * kWall, kFloor + 0.1F * static_cast<float>(j));
    }
    for (float x = 1.0F; x < kWall; x += 0.1F) piece.points.emplace_back(x, slope * x, kFloor);
    for (float x = kSeenFrom; x < 19.0F; x += 0.1F) {
      piece.points.emplace_back(x, slope * x, kFloor);
      piece.points.emplace_back(x, slope * x, 1.0F);
    }
  }
  piece.seen_from.assign(piece.points.size(), 0);
  piece.T_world_piece.translation = {0.03, 0.03, 0.0};
  const OccupancyGrid grid = draw_occupancy({piece}, {});
  EXPECT_EQ(cell_at(grid, 3.03, 0.53), OccupancyGrid::kOccupied);
  EXPECT_EQ(cell_at(grid, 2.03, 0.03), OccupancyGrid::kFree);
  EXPECT_EQ(cell_at(grid, 0.23, 0.03), OccupancyGrid::kUnknown) << "looked over, too";
}

TEST(OccupancyGridTest, ImageAndYamlAreThoseOfMapServer) {
  const OccupancyGrid grid = draw_occupancy({room()}, {});
  const std::string image = format_pgm(grid);
  const std::string head =
      "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  EXPECT_EQ(image.substr(0, head.size()), head);
  ASSERT_EQ(image.size(), head.size() + grid.cells.size());
  // The image begins with the highest y.
  for (int x = 0; x < grid.width; ++x) {
    const auto pixel = static_cast<unsigned char>(image[head.size() + static_cast<std::size_t>(x)]);
    const std::uint8_t cell = grid.at(x, grid.height - 1);
    EXPECT_EQ(pixel, cell == OccupancyGrid::kFree       ? 254
                     : cell == OccupancyGrid::kOccupied ? 0
                                                        : 205);
  }
  EXPECT_NE(format_grid_yaml(grid, "map.pgm").find("resolution: 0.1\n"), std::string::npos);
  EXPECT_NE(format_grid_yaml(grid, "map.pgm").find("image: map.pgm\n"), std::string::npos);
  OccupancyGrid far = grid;
  far.low = {512345.65, -4812345.35};
  EXPECT_NE(format_grid_yaml(far, "map.pgm").find("[512345.65, -4812345.35, 0.0]"),
            std::string::npos);
}

/// The number behind a key of the grid's YAML.
double yaml_number(const std::string& yaml, const std::string& key) {
  const std::size_t at = yaml.find('\n' + key + ": ");
  return at == std::string::npos ? -1.0 : std::stod(yaml.substr(at + key.size() + 3));
}

// map_server takes cells from pixels with (255 - pixel) / 255.
TEST(OccupancyGridTest, WhatWasNotSeenIsNeitherFreeNorOccupiedToMapServer) {
  const std::string yaml = format_grid_yaml(draw_occupancy({room()}, {}), "map.pgm");
  const double free = yaml_number(yaml, "free_thresh");
  const double occupied = yaml_number(yaml, "occupied_thresh");
  const auto taken = [](int pixel) { return (255 - pixel) / 255.0; };
  EXPECT_LT(taken(254), free);
  EXPECT_GT(taken(205), free);
  EXPECT_LT(taken(205), occupied);
  EXPECT_GT(taken(0), occupied);
}

TEST(OccupancyGridTest, NothingSeenIsAnEmptyGridAndTooMuchIsRefused) {
  EXPECT_THROW((void)draw_occupancy({}, {}), std::invalid_argument);
  EXPECT_THROW((void)draw_elevation({}), std::invalid_argument);
  Piece far = room();
  far.T_world_piece.translation = {1e6, 1e6, 0.0};
  EXPECT_THROW((void)draw_occupancy({room(), far}, {}), std::invalid_argument);
}

TEST(ElevationGridTest, HoldsTheGroundAndNotTheWalls) {
  Piece piece = room();
  piece.T_world_piece.translation = {0.0, 0.0, 2.0};
  const ElevationGrid grid = draw_elevation({piece});
  const auto at = [&](double x, double y) {
    const auto row = static_cast<std::size_t>((y - grid.low.y()) / grid.cell);
    return row * static_cast<std::size_t>(grid.width) +
           static_cast<std::size_t>((x - grid.low.x()) / grid.cell);
  };
  EXPECT_NEAR(grid.heights[at(0.5, 0.5)], 1.6, 1e-5);
  EXPECT_NEAR(grid.variances[at(0.5, 0.5)], 0.0, 1e-5);
  EXPECT_LT(grid.heights[at(3.97, 0.53)], 1.6 + 0.6) << "at a wall of 1.9 m";
  EXPECT_EQ(format_asc(grid, grid.heights).rfind("ncols ", 0), 0U);
}

}  // namespace
}  // namespace surefoot::mapping
