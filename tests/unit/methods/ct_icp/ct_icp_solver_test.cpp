// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

CtIcpFrame random_frame(test::Random& random, double turn) {
  const Pose begin = random.pose(10.0, 3.0);
  return {begin, {so3_exp(turn * random.unit_vector()) * begin.rotation, random.vector(10.0)}};
}

CtIcpResidual random_residual(test::Random& random) {
  return {random.vector(10.0), random.uniform(0.0, 1.0), random.vector(10.0), random.unit_vector(),
          random.uniform(0.1, 1.0)};
}

// Without a turn, with a tiny one, with a scan's, with a wild one.
constexpr double kTurns[] = {0.0, 1e-7, 0.05, 2.5};

TEST(CtIcpMotion, IsASlerpAndALine) {
  test::Random random(1);
  for (const double turn : kTurns) {
    const CtIcpFrame frame = random_frame(random, turn);
    const CtIcpMotion motion(frame);
    for (const double alpha : {0.0, 0.3, 1.0}) {
      const Pose expected{frame.begin.rotation.slerp(alpha, frame.end.rotation),
                          (1.0 - alpha) * frame.begin.translation + alpha * frame.end.translation};
      const Eigen::Vector3d point = random.vector(10.0);
      EXPECT_LT((motion.place(alpha, point) - expected * point).norm(), 1e-12) << turn;
      EXPECT_LT((motion.at(alpha) * point - expected * point).norm(), 1e-12) << turn;
    }
  }
}

TEST(CtIcpSolver, ResidualsAreWeightedDistances) {
  test::Random random(2);
  const CtIcpFrame frame = random_frame(random, 0.1);
  for (int i = 0; i < 20; ++i) {
    const CtIcpResidual residual = random_residual(random);
    const Eigen::Vector3d placed =
        frame.begin.rotation.slerp(residual.alpha, frame.end.rotation) * residual.point +
        frame.begin.translation +
        residual.alpha * (frame.end.translation - frame.begin.translation);
    EXPECT_NEAR(ct_icp_residual(residual, CtIcpMotion(frame)),
                residual.weight * (residual.anchor - placed).dot(residual.normal), 1e-12);
  }
}

TEST(CtIcpSolver, JacobiansAreDerivatives) {
  test::Random random(3);
  constexpr double kStep = 1e-6;
  for (const double turn : kTurns) {
    for (int i = 0; i < 20; ++i) {
      const CtIcpFrame frame = random_frame(random, turn);
      const CtIcpResidual residual = random_residual(random);
      const auto J = ct_icp_jacobian(residual, CtIcpMotion(frame));
      for (int k = 0; k < 12; ++k) {
        const auto value = [&](double x) {
          return ct_icp_residual(residual, CtIcpMotion(moved(frame, x * CtIcpStep::Unit(k))));
        };
        EXPECT_NEAR(J(k), (value(kStep) - value(-kStep)) / (2.0 * kStep), 1e-6) << turn << ' ' << k;
      }
    }
  }
}

TEST(CtIcpSolver, APointOfTheLastInstantSaysNothingOfTheFirst) {
  test::Random random(4);
  CtIcpResidual residual = random_residual(random);
  residual.alpha = 1.0;
  const auto J = ct_icp_jacobian(residual, CtIcpMotion(random_frame(random, 0.1)));
  EXPECT_EQ(J.leftCols<6>().norm(), 0.0);
  EXPECT_GT(J.rightCols<6>().norm(), 0.0);
}

CtIcpParameters all_constraints() {
  CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  config.beta_location_consistency = 0.3;
  config.beta_constant_velocity = 0.2;
  config.beta_small_velocity = 0.5;
  config.beta_orientation_consistency = 0.7;
  return config;
}

/// The constraints as the original writes them.
double constraints_cost(const CtIcpFrame& frame, const CtIcpFrame& previous) {
  const Eigen::Vector3d velocity = frame.end.translation - frame.begin.translation;
  const Eigen::Vector3d last = previous.end.translation - previous.begin.translation;
  const double dot = frame.begin.rotation.dot(previous.end.rotation);
  return 100.0 * (0.3 * (frame.begin.translation - previous.end.translation).squaredNorm() +
                  0.2 * (velocity - last).squaredNorm() + 0.5 * velocity.squaredNorm() +
                  0.7 * std::pow(1.0 - dot * dot, 2));
}

TEST(CtIcpSolver, ConstraintsHoldTheTrajectory) {
  test::Random random(5);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 20; ++i) {
    const CtIcpFrame frame = random_frame(random, 0.2), previous = random_frame(random, 0.2);
    const auto equations = ct_icp_constraints(frame, previous, 100, all_constraints());
    const double cost = constraints_cost(frame, previous);
    EXPECT_NEAR(equations.weighted_squares, cost, 1e-9 * cost);
    for (int k = 0; k < 12; ++k) {  // the cost's derivative is 2 g
      const auto value = [&](double x) {
        return constraints_cost(moved(frame, x * CtIcpStep::Unit(k)), previous);
      };
      EXPECT_NEAR(2.0 * equations.g[k], (value(kStep) - value(-kStep)) / (2.0 * kStep),
                  1e-7 * cost);
    }
  }
}

/// Points of three walls, met exactly by a sensor that moves by `truth`.
std::vector<CtIcpResidual> corner(const CtIcpFrame& truth, test::Random& random) {
  const CtIcpMotion motion(truth);
  std::vector<CtIcpResidual> residuals;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector3d normal = Eigen::Vector3d::Unit(i % 3);
    const Eigen::Vector3d on_wall =
        8.0 * normal + random.vector(6.0).cwiseProduct(Eigen::Vector3d::Ones() - normal);
    const double alpha = random.uniform(0.0, 1.0);
    residuals.push_back({motion.at(alpha).inverse() * on_wall, alpha, 8.0 * normal, normal, 0.8});
  }
  return residuals;
}

TEST(CtIcpSolver, FindsBothPosesOfACorner) {
  test::Random random(6);
  const CtIcpFrame truth{{so3_exp({0.01, -0.02, 0.1}), {0.3, -0.2, 0.1}},
                         {so3_exp({-0.02, 0.03, 0.2}), {0.5, -0.1, 0.15}}};
  CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  config.beta_location_consistency = config.beta_constant_velocity = 0.0;
  config.ls_max_num_iters = 50;
  const Workers workers(1);
  const CtIcpFrame found = solve_ct_icp(corner(truth, random), {}, {}, config, workers);
  EXPECT_LT((found.begin.translation - truth.begin.translation).norm(), 1e-4);
  EXPECT_LT((found.end.translation - truth.end.translation).norm(), 1e-4);
  EXPECT_LT(found.begin.rotation.angularDistance(truth.begin.rotation), 1e-4);
  EXPECT_LT(found.end.rotation.angularDistance(truth.end.rotation), 1e-4);
}

TEST(CtIcpSolver, RigidEquationsMoveTheWholeScan) {
  test::Random random(7);
  const CtIcpFrame frame = random_frame(random, 0.1);
  CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  config.ls_sigma = 1e6;  // no loss: squares
  std::vector<CtIcpResidual> residuals;
  for (int i = 0; i < 300; ++i) residuals.push_back(random_residual(random));
  const Workers workers(1);
  const NormalEquations<6> rigid = rigid_equations(residuals, frame, config, workers);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const auto cost = [&](double x) {
      const Pose T = se3_exp(x * Twist::Unit(k));
      const CtIcpMotion motion({T * frame.begin, T * frame.end});
      double sum = 0.0;
      for (const auto& residual : residuals) sum += std::pow(ct_icp_residual(residual, motion), 2);
      return sum;
    };
    const double slope = (cost(kStep) - cost(-kStep)) / (2.0 * kStep);
    EXPECT_NEAR(2.0 * rigid.g[k], slope, 1e-5 * rigid.H.norm());
  }
  EXPECT_EQ(rigid.count, 300);
}

TEST(CtIcpSolver, ThreadsDoNotChangeABit) {
  test::Random random(8);
  const auto residuals = corner({}, random);
  const CtIcpFrame start{{so3_exp({0.0, 0.0, 0.05}), {0.2, 0.1, 0.0}}, {}};
  const CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  const Workers one(1), four(4);
  const CtIcpFrame a = solve_ct_icp(residuals, start, {}, config, one);
  const CtIcpFrame b = solve_ct_icp(residuals, start, {}, config, four);
  EXPECT_EQ(a.begin.translation, b.begin.translation);
  EXPECT_EQ(a.end.rotation.coeffs(), b.end.rotation.coeffs());
  EXPECT_NE(a.begin.translation, start.begin.translation);
}

}  // namespace
}  // namespace surefoot
