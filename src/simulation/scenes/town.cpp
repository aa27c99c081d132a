// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Streets that go on longer than any local map is wide: for ways of kilometres that return.
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeTown = 301;
constexpr std::uint64_t kPurposeTownMeasures = 341;
constexpr double kMargin = 60.0;  // ground beyond the streets [m]
constexpr double kHouse = 20.0;
constexpr double kAlley = 4.0;
constexpr double kHouseFront = 8.0;  // from the street's middle
constexpr double kHouseBack = 20.0;
constexpr double kKerb = 5.0;  // where trees stand and cars park
constexpr double kRounding = 2.0;

/// Asphalt is never quite even.
double ground(double x, double y) {
  return 0.03 * std::sin(0.23 * x + 0.4) * std::cos(0.19 * y) + 0.01 * std::sin(0.8 * x + 0.6 * y);
}

Eigen::Vector3d on_ground(const Eigen::Vector2d& place) {
  return {place.x(), place.y(), ground(place.x(), place.y())};
}

/// What a street is drawn from: its houses by the layout, what stands before them by the things.
struct StreetDraws {
  CounterRandom houses;
  CounterRandom things;

  StreetDraws(const SceneSeeds& seeds, std::uint64_t street)
      : houses(seeds.layout, kPurposeTown + street), things(seeds.things, kPurposeTown + street) {}
};

/// Houses of several heights on both sides, with trees, cars and lamps before them.
void add_street(TriangleMesh& mesh, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                const StreetDraws& random) {
  const TriangleMesh car = make_car();
  const double length = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length;
  const Eigen::Vector2d left(-along.y(), along.x());
  const double heading = std::atan2(along.y(), along.x());
  std::uint64_t house = 0;
  for (double start = kHouseBack; start + kHouse < length - kHouseBack; start += kHouse + kAlley) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double distance, double aside) -> Eigen::Vector2d {
        return from + (start + distance) * along + side * aside * left;
      };
      const std::uint64_t draw = 8 * house;
      const Eigen::Vector2d front = at(0.0, kHouseFront + random.houses.uniform(draw, -0.8, 0.8));
      const Eigen::Vector2d back = at(kHouse, kHouseBack);
      const int storeys = 2 + static_cast<int>(random.houses.uniform(draw + 1, 0.0, 4.0));
      add_building(mesh, front.cwiseMin(back), front.cwiseMax(back), storeys);
      const double shift = random.things.uniform(draw + 2, 0.0, 4.0);
      add_tree(mesh, on_ground(at(2.0 + shift, kKerb)), random.things.uniform(draw + 3, 4.5, 8.0),
               random.things, 1'000 + house);
      mesh.add_mesh(placed(car, on_ground(at(10.0 + shift, kKerb - 0.5)), heading));
      add_lamp(mesh, on_ground(at(18.0, kKerb + 1.0)));
      ++house;
    }
  }
}

/// Ground under streets that reach from the one corner to the other.
Scene streets_between(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  Scene scene;
  scene.mesh.add_heightfield(low.array() - kMargin, high.array() + kMargin, 2.0, ground,
                             Material::asphalt);
  scene.corner_rounding = kRounding;
  scene.robot = "trot";
  return scene;
}

}  // namespace

/// Four streets round a block: 1.3 km a lap.
Scene town(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeTownMeasures);
  const double length = draw.between(1, 400.0, 330.0, 450.0);
  const double width = draw.between(2, 250.0, 200.0, 300.0);
  const Eigen::Vector2d corners[] = {{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}};
  Scene scene = streets_between({0.0, 0.0}, {length, width});
  for (std::uint64_t i = 0; i < 4; ++i) {
    add_street(scene.mesh, corners[i], corners[(i + 1) % 4], StreetDraws(seeds, i));
    scene.route.push_back(on_ground(corners[i]));
  }
  return scene;
}

/// Two blocks of streets, and a figure eight round them: the street between them is walked twice a
/// lap, the same way.
Scene quarter(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeTownMeasures + 1);
  const double length = draw.between(1, 180.0, 140.0, 220.0);
  const double width = draw.between(2, 120.0, 100.0, 150.0);
  const auto corner = [&](int column, int row) -> Eigen::Vector2d {
    return {length * column, width * row};
  };
  Scene scene = streets_between(corner(0, -1), corner(1, 1));
  std::uint64_t street = 10;
  for (const int row : {-1, 0, 1}) {
    add_street(scene.mesh, corner(0, row), corner(1, row), StreetDraws(seeds, street++));
  }
  for (const int column : {0, 1}) {
    for (const int row : {-1, 0}) {
      add_street(scene.mesh, corner(column, row), corner(column, row + 1),
                 StreetDraws(seeds, street++));
    }
  }
  for (const Eigen::Vector2d& at : {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1),
                                    corner(0, 0), corner(1, 0), corner(1, -1), corner(0, -1)}) {
    scene.route.push_back(on_ground(at));
  }
  return scene;
}

/// One bent street, out and back on its other side: seen again the other way round only.
Scene avenue(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeTownMeasures + 2);
  constexpr double kAside = 2.0;  // of the street's middle
  constexpr double kTurn = 3.0;   // beyond the end
  const double first = draw.between(1, 240.0, 200.0, 280.0);
  const double second = draw.between(2, 260.0, 220.0, 300.0);
  const Eigen::Vector2d begin(0.0, 0.0), bend(first, 0.0), end(first, second);
  Scene scene = streets_between({-10.0, -10.0}, {first + 10.0, second + 10.0});
  add_street(scene.mesh, begin, bend, StreetDraws(seeds, 20));
  add_street(scene.mesh, bend, end, StreetDraws(seeds, 21));
  for (const Eigen::Vector2d& at :
       {Eigen::Vector2d(0.0, -kAside), Eigen::Vector2d(first + kAside, -kAside),
        Eigen::Vector2d(first + kAside, second), Eigen::Vector2d(first, second + kTurn),
        Eigen::Vector2d(first - kAside, second), Eigen::Vector2d(first - kAside, kAside),
        Eigen::Vector2d(0.0, kAside), Eigen::Vector2d(-kTurn, 0.0)}) {
    scene.route.push_back(on_ground(at));
  }
  scene.corner_rounding = 1.0;
  return scene;
}

/// Streets round eight by eight blocks, 21 km of them; its own way goes along the streets of one
/// direction, up and down. For maps that are made apart, of ways of --route.
Scene city(const SceneSeeds& seeds) {
  constexpr int kBlocks = 8;  // in a row, and of these
  const LayoutDraws draw(seeds.layout, kPurposeTownMeasures + 3);
  const double length = draw.between(1, 180.0, 150.0, 200.0);
  const double width = draw.between(2, 120.0, 100.0, 140.0);
  const auto corner = [&](int column, int row) -> Eigen::Vector2d {
    return {length * column, width * row};
  };
  Scene scene = streets_between(corner(0, 0), corner(kBlocks, kBlocks));
  std::uint64_t street = 100;
  for (int across = 0; across <= kBlocks; ++across) {
    for (int along = 0; along < kBlocks; ++along) {
      add_street(scene.mesh, corner(along, across), corner(along + 1, across),
                 StreetDraws(seeds, street++));
      add_street(scene.mesh, corner(across, along), corner(across, along + 1),
                 StreetDraws(seeds, street++));
    }
  }
  for (int row = 0; row <= kBlocks; ++row) {  // back down the first column, which they leave out
    const bool out = row % 2 == 0;
    scene.route.push_back(on_ground(corner(out ? 1 : kBlocks, row)));
    scene.route.push_back(on_ground(corner(out ? kBlocks : 1, row)));
  }
  scene.route.push_back(on_ground(corner(0, kBlocks)));
  scene.route.push_back(on_ground(corner(0, 0)));
  return scene;
}

}  // namespace surefoot::simulation
