// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_prior.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/random.hpp"

namespace surefoot {
namespace {

// Standard deviations of a walker's velocity of whom nothing is known [m/s, rad/s].
const Twist kVelocity = (Twist() << 1.0, 1.0, 0.3, 0.5, 0.5, 0.7).finished();

/// Standard deviations of J times both poses' differences.
Twist deviations(const KnotPrior& prior, const Eigen::Matrix<double, 6, 12>& J) {
  const Matrix12 covariance = prior.information.inverse();
  return (J * covariance * J.transpose()).diagonal().cwiseSqrt();
}

Eigen::Matrix<double, 6, 12> first() {
  Eigen::Matrix<double, 6, 12> J = Eigen::Matrix<double, 6, 12>::Zero();
  J.leftCols<6>().setIdentity();
  return J;
}

Eigen::Matrix<double, 6, 12> velocity(double step) {
  Eigen::Matrix<double, 6, 12> J;
  J << -Matrix6::Identity() / step, Matrix6::Identity() / step;
  return J;
}

TEST(KnotPrior, ThePlaceIsKnownAndTheVelocityIsNot) {
  test::Random random(1);
  const Pose pose = random.pose(5.0, 3.0);
  for (const double step : {0.0125, 0.1}) {
    const KnotPrior prior = at_rest(pose, step);
    for (const Pose& mean : prior.means) {
      EXPECT_EQ(mean.translation, pose.translation);
      EXPECT_EQ(mean.rotation.coeffs(), pose.rotation.coeffs());
    }
    EXPECT_LT((deviations(prior, first()) - Twist::Constant(1e-3)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((deviations(prior, velocity(step)) - kVelocity).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(KnotPrior, ThePlaceIsKnownTheLessTheLongerAgoItWas) {
  constexpr double kStep = 0.0125;
  for (const double since : {0.3, 2.0, 60.0}) {
    const KnotPrior prior = at_rest(Pose{}, kStep, since);
    const Twist expected = Twist::Constant(1e-3) + since * kVelocity;
    EXPECT_LT((deviations(prior, first()) - expected).cwiseAbs().maxCoeff(), 1e-6 * since);
    EXPECT_LT((deviations(prior, velocity(kStep)) - kVelocity).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST(KnotPrior, ItsTermsAreTheGaussians) {
  // Alone, it leads back to its means in one step, and knows them as well as it says.
  test::Random random(2);
  for (int round = 0; round < 20; ++round) {
    Matrix12 root = Matrix12::Identity();
    for (int i = 0; i < 144; ++i) root(i / 12, i % 12) += random.uniform(-0.3, 0.3);
    const KnotPrior prior{{random.pose(10.0, 3.0), random.pose(10.0, 3.0)},
                          root * root.transpose()};
    const Twist off[2] = {random.twist(0.3, 0.3), random.twist(0.3, 0.3)};
    KnotWindow window;
    for (const int k : {0, 1}) window.knots.push_back(displaced(prior.means[k], off[k]));
    BandedSystem system(2);
    prior.add_to(system, window);
    ASSERT_TRUE(system.factorise());
    EXPECT_LT((system.last_two_information() - prior.information).norm(), 1e-9);
    const std::vector<Twist> step = system.solve();
    EXPECT_LT((step[0] + off[0]).norm(), 1e-9);
    EXPECT_LT((step[1] + off[1]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace surefoot
