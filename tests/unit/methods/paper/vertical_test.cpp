// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The vertical stage, eqs. (23), (25), (26), (32)-(34) and line 21 of Algorithm 1, against sums
// over dense matrices written out as in the paper.
#include "methods/paper/vertical.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "registration_fixture.hpp"

namespace surefoot {
namespace {

using test::Random;

struct VerticalScene {
  PaperParameters config = test::step_config();
  Pose T{so3_exp({0.02, -0.03, 0.4}), {1.0, -0.5, 0.2}};
  LocalMap map = test::make_map(test::room_points(1, 1000), config);
  Source source;

  VerticalScene() {
    config.vertical.near_distance = 4.0;  // points on both sides of d_0
    config.vertical.near_gate = 0.05;     // and of epsilon_0
    const Pose T_true = apply_update(T, (Twist() << 0.1, 0.05, -0.1, 0.01, -0.02, 0.03).finished());
    source = test::make_source(test::room_points(2, 150), T_true);
    test::match_by_brute_force(source, map.points(), T, 0.8);
  }
};

/// Eqs. (28)-(32) as printed.
double vertical_weight(double d, double r, const Eigen::Vector3d& n,
                       const PaperParameters::Vertical& c) {
  const double excess = d - c.near_distance;
  const double gamma = d < c.near_distance ? 1.0 : 1.0 / (1.0 + c.distance_decay * excess * excess);
  const double eta = std::abs(n.z());
  const double kappa2 = c.kernel_scale * c.kernel_scale;
  double rho = kappa2 / (kappa2 + r * r);
  if (d < c.near_distance) rho = std::abs(r) <= c.near_gate ? 1.0 : c.near_suppression;
  return rho * gamma * eta;
}

TEST(Vertical, NormalEquationsEqualTheDenseSum) {
  VerticalScene scene;
  const PaperParameters::Vertical& c = scene.config.vertical;
  Eigen::Matrix<double, 6, 3> S_V;
  S_V << 0, 0, 0, /**/ 0, 0, 0, /**/ 1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 1, /**/ 0, 0, 0;
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  int count = 0, near = 0, suppressed = 0, left_out = 0;
  for (std::size_t i = 0; i < scene.source.points.size(); ++i) {
    const Match& match = scene.source.matches[i];
    if (!match.found) continue;
    const Eigen::Vector3d place = scene.T * scene.source.points[i].cast<double>();
    const Eigen::Vector3d s = place - scene.T.translation;
    const Surface surface = scene.map.surface(scene.map.voxel_of(place));
    const Eigen::Vector3d n = surface.normal;
    if (surface.neighbours < c.min_neighbours || std::abs(n.z()) < c.min_normal_z ||
        s.norm() > c.max_range) {
      ++left_out;
      continue;
    }
    Eigen::Matrix<double, 1, 6> J_V;
    J_V << n.transpose(), n.transpose() * (-test::skew(s));
    const Eigen::Matrix<double, 1, 3> J = J_V * S_V;
    const double r = n.dot(place - match.target);
    const double w = vertical_weight(s.norm(), r, n, c);
    H += w * J.transpose() * J;
    g += w * J.transpose() * r;
    ++count;
    near += s.norm() < c.near_distance ? 1 : 0;
    suppressed += s.norm() < c.near_distance && std::abs(r) > c.near_gate ? 1 : 0;
  }
  ASSERT_GT(near, 20);  // every branch takes part
  ASSERT_GT(count - near, 20);
  ASSERT_GT(suppressed, 5);
  ASSERT_GT(left_out, 100);
  const auto sum = vertical_equations(scene.source, scene.map, scene.T, c, Workers(1));
  EXPECT_EQ(sum.count, count);
  EXPECT_LT((sum.H - H).norm(), 1e-9 * H.norm());
  EXPECT_LT((sum.g - g).norm(), 1e-9 * g.norm());
  EXPECT_LT((sum.solve() + H.inverse() * g).norm(), 1e-9);
}

// The same correspondences and weights with the whole residual of eq. (13) in its place.
TEST(Vertical, PointToPointResidualsEqualTheDenseSum) {
  VerticalScene scene;
  PaperParameters::Vertical& c = scene.config.vertical;
  const int planes = vertical_equations(scene.source, scene.map, scene.T, c, Workers(1)).count;
  c.residual = Residual::point_to_point;
  Eigen::Matrix<double, 6, 3> S_V;
  S_V << 0, 0, 0, /**/ 0, 0, 0, /**/ 1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 1, /**/ 0, 0, 0;
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < scene.source.points.size(); ++i) {
    const Match& match = scene.source.matches[i];
    if (!match.found) continue;
    const Eigen::Vector3d place = scene.T * scene.source.points[i].cast<double>();
    const Eigen::Vector3d s = place - scene.T.translation;
    const Surface surface = scene.map.surface(scene.map.voxel_of(place));
    if (!valid_vertical(surface, s.norm(), c)) continue;
    Eigen::Matrix<double, 3, 6> J_p;
    J_p << Eigen::Matrix3d::Identity(), -test::skew(s);
    const Eigen::Matrix3d J = J_p * S_V;
    const Eigen::Vector3d r = place - match.target;
    const double w = vertical_weight(s.norm(), r.norm(), surface.normal, c);
    H += w * J.transpose() * J;
    g += w * J.transpose() * r;
  }
  const auto sum = vertical_equations(scene.source, scene.map, scene.T, c, Workers(1));
  EXPECT_EQ(sum.count, planes);
  EXPECT_LT((sum.H - H).norm(), 1e-9 * H.norm());
  EXPECT_LT((sum.g - g).norm(), 1e-9 * g.norm());
}

TEST(Vertical, ThreadsAndCachedSurfacesDoNotChangeABit) {
  VerticalScene scene;
  const auto& c = scene.config.vertical;
  const auto alone = vertical_equations(scene.source, scene.map, scene.T, c, Workers(1));
  for (const int threads : {1, 2, 3, 8}) {  // the first finds every surface cached
    const auto again = vertical_equations(scene.source, scene.map, scene.T, c, Workers(threads));
    EXPECT_EQ(again.H, alone.H);
    EXPECT_EQ(again.g, alone.g);
    scene.source.surfaces.assign(scene.source.points.size(), CachedSurface{});
  }
}

TEST(Vertical, CachedSurfaceIsRenewedWhenAPointChangesItsVoxel) {
  VerticalScene scene;
  CachedSurface cached;
  for (double x = -5.0; x < 5.0; x += 0.3) {
    const Eigen::Vector3d place(x, 0.2, -0.4);
    const Surface fresh = scene.map.surface(scene.map.voxel_of(place));
    const Surface& kept = surface_at(scene.map, place, cached);
    EXPECT_EQ(kept.normal, fresh.normal);
    EXPECT_EQ(kept.neighbours, fresh.neighbours);
  }
}

TEST(Vertical, ValidityHoldsAtEachLimitAndFailsBeyond) {
  PaperParameters::Vertical c = test::step_config().vertical;
  c.min_neighbours = 8;
  c.min_normal_z = 0.5;
  c.max_range = 20.0;
  Surface surface;
  surface.neighbours = 8;
  surface.normal = {std::sqrt(0.75), 0.0, -0.5};  // either sign of the normal
  EXPECT_TRUE(valid_vertical(surface, 20.0, c));
  EXPECT_FALSE(valid_vertical(surface, std::nextafter(20.0, 21.0), c));
  surface.neighbours = 7;
  EXPECT_FALSE(valid_vertical(surface, 1.0, c));
  surface.neighbours = 8;
  surface.normal.z() = -0.4999;
  EXPECT_FALSE(valid_vertical(surface, 1.0, c));
}

TEST(Vertical, TrustRegionKeepsShortUpdatesAndTheDirectionOfLongOnes) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d direction = random.unit_vector();
    const Eigen::Vector3d below = 0.19999 * direction;
    EXPECT_EQ(limit_to_trust_region(below, 0.2), below);
    for (const double length : {0.2001, 1.0, 1e6}) {
      const Eigen::Vector3d limited = limit_to_trust_region(length * direction, 0.2);
      EXPECT_NEAR(limited.norm(), 0.2, 1e-15);
      EXPECT_LT((limited - 0.2 * direction).norm(), 1e-15);
    }
  }
}

TEST(Vertical, TrustRegionAtItsBoundAndAtZero) {
  const Eigen::Vector3d at(0.0, 0.25, 0.0);
  EXPECT_EQ(limit_to_trust_region(at, 0.25), at);
  EXPECT_EQ(limit_to_trust_region(Eigen::Vector3d::Zero(), 0.25), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace surefoot
