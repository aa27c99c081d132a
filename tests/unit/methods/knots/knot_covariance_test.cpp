// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a registration's covariances say, against its normal equations written down as one dense
// system.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "methods/knots/knot_registration.hpp"
#include "support/dense_algebra.hpp"
#include "support/random.hpp"
#include "support/synthetic_run.hpp"
#include "unit/methods/knots/swaying_scan.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

/// The normal equations of the cost's Gauss-Newton step at a window, whole.
struct DenseEquations {
  Eigen::MatrixXd H;                   ///< of all knots
  Eigen::VectorXd g;                   ///< of the surfels alone
  Eigen::MatrixXd worth;               ///< H of the surfels alone, clouds counted by their worth
  Matrix6 rigid = Matrix6::Zero();     ///< of the surfels alone, the scan moved as one
  Matrix6 clusters = Matrix6::Zero();  ///< outer products of the gradients of neighbours
  double weighted_squares = 0.0;
  int residuals = 0;
};

void add_dense_surfels(const KnotWindow& window, const Config::Knots& config,
                       DenseEquations& dense) {
  const KnotPoints& points = scan_points();
  for (std::size_t s = 0; s < window.segments(); ++s) {
    const Pose &first = window.knots[s + 1], &last = window.knots[s + 2];
    Eigen::Matrix<double, 6, 3> neighbours = Eigen::Matrix<double, 6, 3>::Zero();
    for (std::size_t i = points.begins[s]; i < points.begins[s + 1]; ++i) {
      const double u = points.points[i].share;
      const Eigen::Vector3d place =
          first * se3_exp(u * se3_log(first.inverse() * last)) * points.points[i].position;
      const Eigen::Vector3d arm = place - (1.0 - u) * first.translation - u * last.translation;
      const Surfel* const surfel = true_map().find(place, arm, 0);
      for (int d = 0; surfel != nullptr && d < surfel->directions; ++d) {
        const Eigen::Vector3d n = surfel->across(d);
        const double r = n.dot(place - surfel->mean);
        const double variance = config.noise * config.noise + surfel->variance(d);
        const double share = surfel->directions == 3 ? config.cloud_weight : 1.0;
        const double w =
            share * config.independence / variance / std::pow(1.0 + r * r / (9.0 * variance), 2);
        Twist of_pose;
        of_pose << n, arm.cross(n);
        Eigen::VectorXd J = Eigen::VectorXd::Zero(dense.H.rows());
        J.segment<6>(6 * static_cast<Eigen::Index>(s + 1)) = (1.0 - u) * of_pose;
        J.segment<6>(6 * static_cast<Eigen::Index>(s + 2)) = u * of_pose;
        dense.H += w * J * J.transpose();
        dense.g += w * r * J;
        dense.worth += w * surfel->worth(d) * J * J.transpose();
        dense.rigid += w * of_pose * of_pose.transpose();
        dense.weighted_squares += w * r * r;
        ++dense.residuals;
        Eigen::Index axis = 0;
        n.cwiseAbs().maxCoeff(&axis);
        neighbours.col(axis) += w * r * of_pose;
      }
    }
    dense.clusters += neighbours * neighbours.transpose();
  }
}

DenseEquations dense_equations(const KnotWindow& window, const KnotPrior& prior,
                               const Config::Knots& config) {
  DenseEquations dense;
  const auto size = static_cast<Eigen::Index>(6 * window.knots.size());
  dense.H = dense.worth = Eigen::MatrixXd::Zero(size, size);
  dense.g = Eigen::VectorXd::Zero(size);
  add_dense_surfels(window, config, dense);
  const double phi = std::exp(-kStep / config.correlation_time);
  const Twist s = VelocityModel(config).fluctuation();
  for (Eigen::Index k = 0; k + 18 <= size; k += 6) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, size);  // of v_{k+1} - phi v_k
    J.middleCols<6>(k) = phi / kStep * Matrix6::Identity();
    J.middleCols<6>(k + 6) = -(1.0 + phi) / kStep * Matrix6::Identity();
    J.middleCols<6>(k + 12) = 1.0 / kStep * Matrix6::Identity();
    const Twist information = s.cwiseAbs2().cwiseInverse() / (1.0 - phi * phi);
    dense.H += J.transpose() * information.asDiagonal() * J;
  }
  dense.H.topLeftCorner<12, 12>() += prior.information;
  return dense;
}

/// A registration that went on until nothing moves, and its window's equations written down anew.
struct Settled {
  KnotRegistration found;
  DenseEquations dense;
};

Settled settle() {
  Config::Knots config = Config().knots;
  config.convergence = 1e-7;
  config.max_iterations = 200;
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  KnotRegistration found = register_from(truth, prior, config);
  DenseEquations dense = dense_equations(found.window, prior, config);
  return {std::move(found), std::move(dense)};
}

TEST(KnotRegistration, ItsCovarianceIsTheInverseOfTheDenseNormalEquations) {
  const auto [found, dense] = settle();
  ASSERT_TRUE(found.converged);
  const Eigen::MatrixXd C = test::inverse(dense.H);
  const std::size_t knots = found.window.knots.size();
  for (std::size_t i = 0; i < knots; ++i) {
    for (std::size_t j = i; j < std::min(i + 3, knots); ++j) {
      const Matrix6 expected =
          C.block<6, 6>(6 * static_cast<Eigen::Index>(i), 6 * static_cast<Eigen::Index>(j));
      EXPECT_LT((found.covariance(i, j) - expected).norm(), 1e-5 * expected.norm())
          << i << ' ' << j;
    }
  }
  const Eigen::Matrix<double, 12, 12> last = test::inverse(C.bottomRightCorner<12, 12>());
  EXPECT_LT((found.last_two - last).norm(), 1e-5 * last.norm());
  EXPECT_LT((found.rigid.H - dense.rigid).norm(), 1e-5 * dense.rigid.norm());
  EXPECT_EQ(found.rigid.count, dense.residuals);
}

/// Where a registration ended, and the equations there with all residuals counted in full.
struct InFull {
  KnotRegistration found;
  Eigen::VectorXd step;
  Eigen::MatrixXd covariance;
};

InFull in_full() {
  auto [found, dense] = settle();
  const double c = Config().knots.independence;
  DenseEquations surfels;
  surfels.H = surfels.worth = Eigen::MatrixXd::Zero(dense.H.rows(), dense.H.cols());
  surfels.g = Eigen::VectorXd::Zero(dense.g.size());
  add_dense_surfels(found.window, Config().knots, surfels);
  const Eigen::MatrixXd others = dense.H - surfels.H;
  // Where nothing moves any more, the surfels' gradient and the others' cancel.
  const Eigen::VectorXd g = (1.0 / c - 1.0) * surfels.g;
  return {std::move(found), -test::solve(others + surfels.H / c, g),
          test::inverse(others + surfels.worth / c)};
}

TEST(KnotRegistration, HeldBackIsTheStepWithAllResidualsInFull) {
  const auto [found, step, covariance] = in_full();
  ASSERT_EQ(found.held_back.size(), found.window.knots.size());
  for (std::size_t k = 0; k < found.held_back.size(); ++k) {
    const Twist expected = step.segment<6>(6 * static_cast<Eigen::Index>(k));
    EXPECT_LT((found.held_back[k] - expected).norm(), 1e-3 * step.norm()) << k;
  }
  EXPECT_GT(step.norm(), 1e-4);  // or it would tell nothing
  const auto step_ns = static_cast<std::int64_t>(1e9 * kStep);
  const Twist between = 0.75 * found.held_back[3] + 0.25 * found.held_back[4];
  const Twist at = found.held_back_at(found.window.begin_ns + 2 * step_ns + step_ns / 4);
  EXPECT_LT((at - between).norm(), 1e-6 * step.norm());
}

TEST(KnotRegistration, ItsFullCovarianceCountsAllResidualsAndCloudsByTheirWorth) {
  const auto [found, step, covariance] = in_full();
  for (std::size_t k = 0; k < found.window.knots.size(); ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    const Matrix6 expected = covariance.block<6, 6>(at, at);
    EXPECT_LT((found.full_covariance(k, k) - expected).norm(), 1e-4 * expected.norm()) << k;
  }
}

TEST(KnotRegistration, NeighboursAreSummedUpBySegmentAndAxis) {
  const auto [found, dense] = settle();
  ASSERT_EQ(found.neighbours.size(), static_cast<std::size_t>(kSegments));
  Matrix6 products = Matrix6::Zero();
  for (const auto& segment : found.neighbours) {
    for (const Twist& gradient : segment) products += gradient * gradient.transpose();
  }
  EXPECT_LT((products - dense.clusters).norm(), 1e-4 * dense.clusters.norm());
  const double variance = dense.weighted_squares / dense.residuals;
  const Eigen::MatrixXd C = test::inverse(dense.rigid);
  const double once = (C * dense.clusters).trace() / (6.0 * variance);
  EXPECT_GT(std::abs(once - 1.0), 0.1);  // or they could as well be independent
}

TEST(KnotRegistration, ThePoseBetweenTwoKnotsHasTheirJointCovariance) {
  const KnotWindow truth = window_along(swaying);
  const KnotRegistration found = register_from(truth, prior_at(truth, 0.01));
  const auto step_ns = static_cast<std::int64_t>(1e9 * kStep);
  for (std::size_t segment = 0; segment < kSegments; ++segment) {
    for (const double u : {0.0, 0.3, 1.0}) {
      const std::int64_t at = found.window.begin_ns + static_cast<std::int64_t>(segment) * step_ns +
                              static_cast<std::int64_t>(u * 1e9 * kStep);
      Eigen::Matrix<double, 12, 12> joint;
      const BandedSystem::Covariance& C = found.full_covariance;
      joint << C(segment + 1, segment + 1), C(segment + 1, segment + 2),
          C(segment + 2, segment + 1), C(segment + 2, segment + 2);
      Eigen::Matrix<double, 6, 12> share;
      share << (1.0 - u) * Matrix6::Identity(), u * Matrix6::Identity();
      const Matrix6 expected = share * joint * share.transpose();
      EXPECT_LT((found.covariance_at(at) - expected).norm(), 1e-6 * expected.norm())
          << segment << ' ' << u;
    }
  }
}
}  // namespace
}  // namespace surefoot
