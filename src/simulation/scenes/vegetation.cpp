// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/vegetation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "simulation/scenes/furniture.hpp"

namespace surefoot::simulation {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kSwayReach = 12.0;  // farther from the way nothing sways [m]
constexpr double kFineReach = 18.0;  // farther from the way leaves are fewer and bigger [m]

enum Kind : std::uint64_t { kGrass = 301, kHerb, kBush, kTree, kDeadWood, kStone, kHedge, kRoot };

/// Round a thing's middle.
Eigen::Vector3d sideways(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }

}  // namespace

/// The draws of one plant.
class Vegetation::Draw {
 public:
  Draw(const CounterRandom& random, std::uint64_t plant) : random_(random), first_(plant << 12U) {}
  [[nodiscard]] double operator()(std::uint64_t number, double low, double high) const {
    return random_.uniform(first_ + number, low, high);
  }
  [[nodiscard]] Eigen::Vector3d direction(std::uint64_t number) const {
    const double up = (*this)(number, -1.0, 1.0);
    return std::sqrt(1.0 - up * up) * sideways((*this)(number + 1, 0.0, kTwoPi)) +
           up * Eigen::Vector3d::UnitZ();
  }

 private:
  CounterRandom random_;
  std::uint64_t first_;
};

namespace {

/// A triangle of this size that faces anywhere.
void add_leaf(TriangleMesh& mesh, const Eigen::Vector3d& at, const Eigen::Vector3d& along,
              const Eigen::Vector3d& across, double size) {
  mesh.add_triangle(at - 0.5 * size * along, at + 0.5 * size * along,
                    at + 0.8 * size * across.cross(along).normalized(), Material::foliage);
}

/// A stick from a to b: three sides.
void add_stick(TriangleMesh& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               double radius) {
  const Eigen::Vector3d axis = (b - a).normalized();
  const Eigen::Vector3d side =
      axis.cross(std::abs(axis.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX())
          .normalized();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d from = radius * (Eigen::AngleAxisd(kTwoPi * i / 3.0, axis) * side);
    const Eigen::Vector3d to = radius * (Eigen::AngleAxisd(kTwoPi * (i + 1) / 3.0, axis) * side);
    mesh.add_quad(a + from, a + to, b + to, b + from, Material::bark);
  }
}

/// A stone of eight faces, flattened and turned.
void add_stone(TriangleMesh& mesh, const Eigen::Vector3d& at, const Eigen::Vector3d& half,
               double yaw) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d x = turn.col(0) * half.x();
  const Eigen::Vector3d y = turn.col(1) * half.y();
  const Eigen::Vector3d z(0.0, 0.0, half.z());
  const std::array<Eigen::Vector3d, 4> rim = {at + x, at + y, at - 0.8 * x, at - 1.1 * y};
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Eigen::Vector3d& a = rim.at(i);
    const Eigen::Vector3d& b = rim.at((i + 1) % rim.size());
    mesh.add_triangle(a, b, at + z + 0.3 * x, Material::rock);
    mesh.add_triangle(a, b, at - z, Material::rock);
  }
}

}  // namespace

Density thinning_out(double near, double far, double reach) {
  return [=](double distance) {
    const double part = std::clamp((distance - reach) / reach, 0.0, 1.0);
    return near + part * (far - near);
  };
}

Density beside_way(double density, double margin) {
  return [=](double distance) { return distance < margin ? 0.0 : density; };
}

Vegetation::Vegetation(Scene& scene, const Terrain& ground, double half, std::uint64_t seed)
    : scene_(&scene), ground_(ground), half_(half), seed_(seed) {}

void Vegetation::for_each(std::uint64_t kind, const Density& density, const Plant& plant) const {
  constexpr std::uint64_t kMostInCell = 1U << 12U;
  constexpr double kNear = 4.0;  // [m]
  const RouteSegments way(scene_->route);
  const CounterRandom random(seed_, kind);
  const auto cells = static_cast<std::uint64_t>(2.0 * half_);
  for (std::uint64_t cell = 0; cell < cells * cells; ++cell) {
    const Eigen::Vector2d corner(static_cast<double>(cell % cells) - half_,
                                 static_cast<double>(cell / cells) - half_);
    const Eigen::Vector2d middle = corner + Eigen::Vector2d::Constant(0.5);
    const double distance = way.distance(middle);
    // Near the way every step counts; far from it the cell's own distance is near enough.
    const RouteSegments near = distance < kNear ? way.within(distance + 1.5, middle) : way;
    const double wanted = density(distance);
    for (std::uint64_t i = 0; i < kMostInCell; ++i) {
      const Draw draw(random, cell * kMostInCell + i);
      if (static_cast<double>(i) + draw(0, 0.0, 1.0) >= wanted) break;
      const Eigen::Vector2d place = corner + Eigen::Vector2d(draw(1, 0.0, 1.0), draw(2, 0.0, 1.0));
      const double own = distance < kNear ? near.distance(place) : distance;
      plant(ground_.at(place), own, draw);
    }
  }
}

double Vegetation::allowed_height(double distance, double tallest) {
  constexpr double kOnWay = 0.22;
  constexpr double kHalfWay = 0.6;
  return std::min(tallest, kOnWay + 0.7 * std::max(0.0, distance - kHalfWay));
}

void Vegetation::add_grass(const Density& density, double tallest) {
  TriangleMesh& mesh = scene_->mesh;
  for_each(kGrass, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    const double height = allowed_height(distance, tallest) * draw(3, 0.35, 1.0);
    // As many square metres of leaf where the blades are fewer.
    const double width = 0.012 * std::sqrt(density(0.0) / density(distance));
    const Eigen::Vector3d across = 0.5 * width * sideways(draw(4, 0.0, kTwoPi));
    const Eigen::Vector3d lean = draw(5, 0.1, 0.8) * height * sideways(draw(6, 0.0, kTwoPi));
    const Eigen::Vector3d root = foot - Eigen::Vector3d(0.0, 0.0, 0.04);
    mesh.add_triangle(root - across, root + across, foot + lean + Eigen::Vector3d(0.0, 0.0, height),
                      Material::blade);
  });
}

void Vegetation::add_herbs(const Density& density, double tallest) {
  TriangleMesh& mesh = scene_->mesh;
  for_each(kHerb, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    constexpr std::uint64_t kLeaves = 14;
    const double height = allowed_height(distance, tallest) * draw(3, 0.4, 1.0);
    for (std::uint64_t leaf = 0; leaf < kLeaves; ++leaf) {
      const std::uint64_t number = 8 + 8 * leaf;
      const Eigen::Vector3d at =
          foot + height * draw(number, 0.1, 0.6) * sideways(draw(number + 1, 0.0, kTwoPi)) +
          Eigen::Vector3d(0.0, 0.0, height * draw(number + 2, 0.2, 0.9));
      add_leaf(mesh, at, draw.direction(number + 3), draw.direction(number + 5),
               std::min(0.12, 0.35 * height));
    }
  });
}

void Vegetation::add_swaying(TriangleMesh mesh, const Eigen::Vector3d& foot, double tilt,
                             double hertz, const Draw& draw) {
  const double phase = draw(4000, 0.0, kTwoPi);
  const double gust = draw(4001, 0.03, 0.09);  // [Hz]
  const double wind = draw(4002, 0.0, kTwoPi);
  scene_->moving.push_back(
      {std::move(mesh), [=](double time) {
         // It leans with the gusts and swings about that.
         const double strength = 0.6 + 0.4 * std::sin(kTwoPi * gust * time + wind);
         const double swing = std::sin(kTwoPi * hertz * time + phase);
         const double across = std::sin(kTwoPi * 0.83 * hertz * time + 2.0 * phase);
         return Pose{from_roll_pitch_yaw({tilt * strength * 0.6 * across,
                                          tilt * strength * (0.4 + 0.8 * swing), 0.0}),
                     foot};
       }});
}

void Vegetation::add_bushes(const Density& density, double tallest) {
  for_each(kBush, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    const double height = tallest * draw(3, 0.4, 1.0);
    const double radius = height * draw(4, 0.35, 0.6);
    if (distance < radius + 0.9) return;
    const bool near = distance < kFineReach;
    const auto leaves = static_cast<std::uint64_t>((near ? 1.0 : 0.3) * (90.0 + 120.0 * height));
    TriangleMesh bush;
    for (std::uint64_t leaf = 0; leaf < leaves; ++leaf) {
      const std::uint64_t number = 16 + 8 * leaf;
      const Eigen::Vector3d out = draw.direction(number) * std::cbrt(draw(number + 2, 0.1, 1.0));
      const Eigen::Vector3d at(radius * out.x(), radius * out.y(), 0.5 * height * (1.05 + out.z()));
      add_leaf(bush, at, draw.direction(number + 3), draw.direction(number + 5),
               (near ? 1.0 : 1.8) * draw(number + 7, 0.05, 0.12));
      if (leaf % 12 == 0) add_stick(bush, {0.0, 0.0, -0.1}, at, 0.008);
    }
    if (distance < kSwayReach) {
      add_swaying(std::move(bush), foot, 0.06, draw(8, 0.5, 1.1), draw);
    } else {
      scene_->mesh.add_mesh(placed(std::move(bush), foot, 0.0));
    }
  });
}

void Vegetation::add_trees(const Density& density, double tallest) {
  constexpr double kLowBough = 2.0;  // above the ground [m]
  const RouteSegments way(scene_->route);
  for_each(kTree, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    const double height = tallest * draw(3, 0.45, 1.0);
    const double thick = height * draw(4, 0.012, 0.024);
    if (distance < thick + 1.2) return;
    const double bare = height * draw(5, 0.12, 0.35);
    scene_->mesh.add_column(foot - Eigen::Vector3d(0.0, 0.0, 0.4), thick, bare + 0.6,
                            Material::bark, 9, 0.8 * thick);
    TriangleMesh crown;
    crown.add_column({0.0, 0.0, 0.0}, 0.8 * thick, height - bare, Material::bark, 6, 0.01);
    constexpr std::uint64_t kBoughs = 14;
    constexpr std::uint64_t kLeavesOnBough = 18;
    for (std::uint64_t bough = 0; bough < kBoughs; ++bough) {
      const std::uint64_t number = 16 + 200 * bough;
      const double up = (height - bare) * (static_cast<double>(bough) + draw(number, 0.0, 1.0)) /
                        static_cast<double>(kBoughs);
      const double reach = 0.28 * (height - up) * draw(number + 1, 0.5, 1.0);
      const Eigen::Vector3d start(0.0, 0.0, up);
      const Eigen::Vector3d end =
          start + reach * (sideways(draw(number + 2, 0.0, kTwoPi)) +
                           Eigen::Vector3d(0.0, 0.0, draw(number + 3, -0.15, 0.4)));
      // Low boughs that would hang over the way have been cut.
      const Eigen::Vector2d tip = (foot + end).head<2>();
      if (distance < kFineReach && bare + up < kLowBough && way.distance(tip) < 1.0 + 0.2 * reach) {
        continue;
      }
      add_stick(crown, start, end, 0.012 + 0.006 * reach);
      for (std::uint64_t leaf = 0; leaf < kLeavesOnBough; ++leaf) {
        const std::uint64_t own = number + 8 + 10 * leaf;
        const Eigen::Vector3d at =
            start + draw(own, 0.2, 1.05) * (end - start) + 0.15 * reach * draw.direction(own + 1);
        add_leaf(crown, at, draw.direction(own + 3), draw.direction(own + 5),
                 draw(own + 7, 0.12, 0.3));
      }
    }
    const Eigen::Vector3d top = foot + Eigen::Vector3d(0.0, 0.0, bare);
    if (distance < kSwayReach) {
      add_swaying(std::move(crown), top, 0.025, draw(8, 0.25, 0.6), draw);
    } else {
      scene_->mesh.add_mesh(placed(std::move(crown), top, 0.0));
    }
  });
}

void Vegetation::add_dead_wood(const Density& density) {
  for_each(kDeadWood, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    const double length = draw(3, 1.0, 5.0);
    const double radius = draw(4, 0.03, 0.14);
    if (distance < length + 0.8) return;
    const Eigen::Vector3d end = foot + length * sideways(draw(5, 0.0, kTwoPi));
    const double lift = draw(6, 0.0, 1.0) < 0.6 ? 0.0 : draw(7, 0.3, 0.9) * length;
    add_stick(scene_->mesh, foot + Eigen::Vector3d(0.0, 0.0, 0.7 * radius),
              ground_.at(end.head<2>()) + Eigen::Vector3d(0.0, 0.0, 0.7 * radius + lift), radius);
  });
}

void Vegetation::add_stones(const Density& density, double largest) {
  for_each(kStone, density, [&](const Eigen::Vector3d& foot, double distance, const Draw& draw) {
    // Many small ones, few large.
    const double size = largest * std::pow(draw(3, 0.0, 1.0), 3.0);
    const double passable = 0.05 + 0.5 * std::max(0.0, distance - 0.7 - size);
    const double height = std::min(size * draw(4, 0.4, 0.9), passable);
    const double radius = std::max(0.02, std::min(size, 3.0 * height));
    add_stone(scene_->mesh, foot, {radius, radius * draw(5, 0.6, 1.0), std::max(0.012, height)},
              draw(6, 0.0, kTwoPi));
  });
}

void Vegetation::add_hedge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
                           std::uint64_t number) {
  constexpr double kHalfWidth = 0.3;
  constexpr double kLeavesPerCubicMetre = 420.0;
  constexpr double kCut = 1.1;  // a way that bends through it is kept free [m]
  const CounterRandom random(seed_, kHedge);
  const double length = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length;
  const Eigen::Vector2d across(-along.y(), along.x());
  const RouteSegments way(scene_->route);
  const auto leaves =
      static_cast<std::uint64_t>(kLeavesPerCubicMetre * 2.0 * kHalfWidth * height * length);
  for (std::uint64_t leaf = 0; leaf < leaves; ++leaf) {
    const Draw draw(random, (number << 24U) + leaf);
    // Its faces bulge: cut, but not with a ruler.
    const double at_length = draw(0, 0.0, length);
    const double bulge = 0.08 * std::sin(2.1 * at_length + static_cast<double>(number)) +
                         0.05 * std::sin(5.3 * at_length);
    const Eigen::Vector2d place =
        from + at_length * along + (draw(1, -1.0, 1.0) * (kHalfWidth + bulge)) * across;
    if (way.distance(place) < kCut) continue;
    const Eigen::Vector3d at =
        ground_.at(place) + Eigen::Vector3d(0.0, 0.0, draw(2, 0.02, 1.0) * (height + bulge));
    add_leaf(scene_->mesh, at, draw.direction(3), draw.direction(5), draw(7, 0.05, 0.11));
  }
}

void Vegetation::add_root(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius,
                          std::uint64_t number) {
  constexpr int kPieces = 8;
  const Draw draw(CounterRandom(seed_, kRoot), number);
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const double bend = draw(0, -0.25, 0.25);
  const auto ridge = [&](int piece, double side) {
    const double part = static_cast<double>(piece) / kPieces;
    const double thin = radius * (1.0 - 0.6 * part);
    const Eigen::Vector2d place =
        from + part * (to - from) + (bend * std::sin(kTwoPi * part) + side * 1.3 * thin) * across;
    return Eigen::Vector3d(ground_.at(place) +
                           Eigen::Vector3d(0.0, 0.0, side == 0.0 ? thin : -0.03));
  };
  for (int piece = 0; piece < kPieces; ++piece) {
    for (const double side : {-1.0, 1.0}) {
      scene_->mesh.add_quad(ridge(piece, side), ridge(piece + 1, side), ridge(piece + 1, 0.0),
                            ridge(piece, 0.0), Material::bark);
    }
  }
}

}  // namespace surefoot::simulation
