// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/floam_solver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/random.hpp"

namespace surefoot {
namespace {

using Kind = FloamResidual::Kind;
using Five = std::array<Eigen::Vector3d, 5>;

FloamResidual random_floam_residual(test::Random& random, Kind kind) {
  FloamResidual residual;
  residual.kind = kind;
  residual.point = random.vector(10.0);
  residual.anchor = random.vector(10.0);
  residual.direction = random.unit_vector();
  residual.offset = random.uniform(-5.0, 5.0);
  return residual;
}

TEST(FloamSolver, ResidualsAreDistances) {
  test::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const FloamResidual edge = random_floam_residual(random, Kind::edge);
    const Eigen::Vector3d p = random.vector(10.0);
    // As the original writes it, with two points of the line.
    const Eigen::Vector3d a = edge.anchor + 0.1 * edge.direction;
    const Eigen::Vector3d b = edge.anchor - 0.1 * edge.direction;
    EXPECT_NEAR(floam_residual(edge, p), (p - a).cross(p - b).norm() / (a - b).norm(), 1e-9);
    const FloamResidual surface = random_floam_residual(random, Kind::surface);
    const Eigen::Vector3d foot = -surface.offset * surface.direction;
    EXPECT_NEAR(floam_residual(surface, p), (p - foot).dot(surface.direction), 1e-9);
  }
}

TEST(FloamSolver, JacobiansAreDerivatives) {
  test::Random random(2);
  for (const Kind kind : {Kind::edge, Kind::surface}) {
    for (int i = 0; i < 20; ++i) {
      const FloamResidual residual = random_floam_residual(random, kind);
      const Eigen::Vector3d p = random.vector(10.0);
      const auto J = floam_jacobian(residual, p);
      for (int k = 0; k < 6; ++k) {
        const double step = 1e-6;
        const auto value = [&](double x) {
          return floam_residual(residual, se3_exp(x * Twist::Unit(k)) * p);
        };
        EXPECT_NEAR(J(k), (value(step) - value(-step)) / (2.0 * step), 1e-6);
      }
    }
  }
}

TEST(FloamSolver, APointOnItsLineHasNoDerivativeButNumbers) {
  test::Random random(3);
  FloamResidual edge = random_floam_residual(random, Kind::edge);
  EXPECT_TRUE(floam_jacobian(edge, edge.anchor).allFinite());
}

Five on_plane(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double roughness) {
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  return {centre + 0.3 * u, centre - 0.2 * u + 0.1 * v, centre + 0.25 * v + roughness * normal,
          centre - 0.3 * v, centre + 0.1 * u + 0.1 * v};
}

TEST(FloamSolver, PlanesAreFittedWhereTheyAre) {
  test::Random random(4);
  for (const bool centred : {false, true}) {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d normal = random.unit_vector();
      const Five five = on_plane(random.vector(10.0) + 3.0 * normal, normal, 0.0);
      FloamResidual residual;
      if (!centred && std::abs(normal.dot(five[0])) < 0.5) continue;
      ASSERT_TRUE(fit_plane(five, centred, residual));
      EXPECT_NEAR(std::abs(residual.direction.dot(normal)), 1.0, 1e-6);
      for (const auto& point : five) EXPECT_NEAR(floam_residual(residual, point), 0.0, 1e-6);
    }
  }
  FloamResidual residual;
  EXPECT_FALSE(fit_plane(on_plane({9, 8, 7}, Eigen::Vector3d::UnitX(), 1.5), false, residual));
}

TEST(FloamSolver, OnlyCentredPlanesMayPassThroughTheOrigin) {
  const Five five = on_plane({0.0, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), 0.01);
  FloamResidual residual;
  ASSERT_TRUE(fit_plane(five, true, residual));
  EXPECT_GT(std::abs(residual.direction.z()), 0.99);
  const bool fitted = fit_plane(five, false, residual);
  EXPECT_TRUE(!fitted || std::abs(residual.direction.z()) < 0.99 ||
              std::abs(residual.offset) > 0.005);  // the original's defect
}

TEST(FloamSolver, LinesAreFittedAndPatchesRefused) {
  const Eigen::Vector3d u = Eigen::Vector3d(1, 2, 3).normalized(), c(4, 5, 6);
  const Five line = {c, c + 0.2 * u, c - 0.2 * u, c + 0.4 * u, c - 0.4 * u};
  FloamResidual residual;
  ASSERT_TRUE(fit_line(line, residual));
  EXPECT_NEAR(std::abs(residual.direction.dot(u)), 1.0, 1e-9);
  EXPECT_FALSE(fit_line(on_plane(c, u, 0.0), residual));
}

/// Residuals of planes and lines that a motion makes zero.
std::vector<FloamResidual> consistent_with(const Pose& truth, int count) {
  test::Random random(5);
  std::vector<FloamResidual> residuals;
  for (int i = 0; i < count; ++i) {
    FloamResidual residual = random_floam_residual(random, i % 3 == 0 ? Kind::edge : Kind::surface);
    const Eigen::Vector3d placed = truth * residual.point;
    residual.anchor = placed + random.uniform(-1.0, 1.0) * residual.direction;
    residual.offset = -residual.direction.dot(placed);
    residuals.push_back(residual);
  }
  return residuals;
}

TEST(FloamSolver, FindsTheMotionThatMakesTheResidualsZero) {
  test::Random random(6);
  const Pose truth = se3_exp(random.twist(5.0, 1.0));
  const auto residuals = consistent_with(truth, 300);
  Pose T = se3_exp(random.twist(0.05, 0.02)) * truth;
  FloamSolution solution;
  for (int i = 0; i < 4; ++i) {
    solution = solve_floam(residuals, T, Workers(1));
    T = solution.T_map_lidar;
  }
  EXPECT_LT((T.translation - truth.translation).norm(), 1e-4);
  EXPECT_LT(so3_log(T.rotation.conjugate() * truth.rotation).norm(), 1e-5);
}

TEST(FloamSolver, NeverMakesTheCostWorse) {
  const auto cost = [](const std::vector<FloamResidual>& residuals, const Pose& T) {
    double sum = 0.0;  // Huber's loss, written down anew
    for (const FloamResidual& residual : residuals) {
      const double r = std::abs(floam_residual(residual, T * residual.point));
      sum += r <= 0.1 ? 0.5 * r * r : 0.1 * (r - 0.05);
    }
    return sum;
  };
  test::Random random(7);
  for (int i = 0; i < 30; ++i) {
    std::vector<FloamResidual> residuals;
    for (int k = 0; k < 40; ++k) {
      residuals.push_back(random_floam_residual(random, k % 2 ? Kind::edge : Kind::surface));
    }
    const FloamSolution solution = solve_floam(residuals, Pose{}, Workers(1));
    EXPECT_LE(cost(residuals, solution.T_map_lidar), cost(residuals, Pose{}) * (1.0 + 1e-12));
    EXPECT_LE(solution.steps, 4);
  }
}

TEST(FloamSolver, WithoutResidualsNothingMoves) {
  const Pose T = se3_exp((Twist() << 1, 2, 3, 0.1, 0.2, 0.3).finished());
  const FloamSolution solution = solve_floam({}, T, Workers(1));
  EXPECT_EQ(solution.T_map_lidar.translation, T.translation);
  EXPECT_EQ(solution.equations.count, 0);
}

}  // namespace
}  // namespace surefoot
