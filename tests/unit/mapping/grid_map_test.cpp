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
  EXPECT_EQ(cell_at(grid, 18.93, 0.03), OccupancyGrid::kUnknown) << "a floor and a ceiling";
}

/// A beam at a robot's height to each of these places (x, y), so often; and a floor behind the
/// LiDAR, from which it is seen how high that stands.
Piece beams_to(const std::vector<std::pair<Eigen::Vector2f, int>>& ends) {
  Piece piece;
  piece.eyes = {{0.05F, 0.05F, 0.0F}};
  for (const auto& [end, times] : ends) {
    for (int i = 0; i < times; ++i) piece.points.emplace_back(end.x(), end.y(), 0.0F);
  }
  const auto floor = static_cast<int>(piece.points.size()) / 4 + 20;
  for (int i = 0; i < floor; ++i) piece.points.emplace_back(-3.0F, 0.05F, -0.4F);
  piece.seen_from.assign(piece.points.size(), 0);
  return piece;
}

// Two beams are counted twice in a cell at most, twenty once at least.
TEST(OccupancyGridTest, WhatIsGoneThroughFarMoreOftenThanHitHasMovedAway) {
  const auto where_hit = [](int through) {
    return cell_at(draw_occupancy({beams_to({{{3.05F, 0.05F}, 1}, {{6.05F, 0.05F}, through}})}, {}),
                   3.05, 0.05);
  };
  EXPECT_EQ(where_hit(2), OccupancyGrid::kOccupied);
  EXPECT_EQ(where_hit(20), OccupancyGrid::kFree);
}

TEST(OccupancyGridTest, NothingIsFreeStraightBeforeWhereABeamEndsNorAlongOneThatIsTooLong) {
  const OccupancyGrid grid =
      draw_occupancy({beams_to({{{3.05F, 0.05F}, 1}, {{0.05F, 25.05F}, 1}})}, {});
  EXPECT_EQ(cell_at(grid, 2.65, 0.05), OccupancyGrid::kFree);
  EXPECT_EQ(cell_at(grid, 2.95, 0.05), OccupancyGrid::kUnknown);
  EXPECT_EQ(grid.at(static_cast<int>((0.05 - grid.low.x()) / grid.cell), grid.height - 1),
            OccupancyGrid::kUnknown);
}

// A robot that stands before a wall for an hour.
TEST(OccupancyGridTest, HoweverOftenAWallIsSeenItStays) {
  const OccupancyGrid grid = draw_occupancy({beams_to({{{3.05F, 0.05F}, 1 << 16}})}, {});
  EXPECT_EQ(cell_at(grid, 3.05, 0.05), OccupancyGrid::kOccupied);
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

// From far away a floor is seen at a few degrees, and tilted as the pose is.
TEST(ElevationGridTest, WhatIsSeenFromFarAwaySaysNothingOfTheGround) {
  Piece near = room(), far = room();
  far.T_world_piece.translation.x() = 20.0;
  near.points.emplace_back(20.55F, 0.55F, 0.0F);
  near.seen_from.push_back(0);
  const ElevationGrid grid = draw_elevation({near, far});
  const auto row = static_cast<std::size_t>((0.55 - grid.low.y()) / grid.cell);
  const auto column = static_cast<std::size_t>((20.55 - grid.low.x()) / grid.cell);
  const std::size_t at = row * static_cast<std::size_t>(grid.width) + column;
  EXPECT_NEAR(grid.heights[at], -0.4, 1e-5);
  EXPECT_NEAR(grid.variances[at], 0.0, 1e-5);
}

}  // namespace
}  // namespace surefoot::mapping
