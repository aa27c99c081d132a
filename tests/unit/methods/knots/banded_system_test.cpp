// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The chain's solver against Eigen's dense Cholesky and inverse.
#include "methods/knots/banded_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "methods/knots/knot_window.hpp"
#include "methods/knots/velocity_model.hpp"
#include "support/dense_algebra.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

/// A positive definite chain, as the solver and as a dense matrix hold it.
struct Chain {
  BandedSystem system;
  Eigen::MatrixXd H;
  Eigen::VectorXd g;

  explicit Chain(std::size_t poses)
      : system(poses), H(Eigen::MatrixXd::Zero(6 * poses, 6 * poses)), g(6 * poses) {
    g.setZero();
  }
  void add(std::size_t row, std::size_t column, const Matrix6& block) {
    system.add(row, column, block);
    H.block<6, 6>(6 * row, 6 * column) += block;
    if (row != column) H.block<6, 6>(6 * column, 6 * row) += block.transpose();
  }
};

Eigen::MatrixXd random_matrix(Random& random, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd m(rows, columns);
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = random.normal(1.0);
  return m;
}

/// Least-squares terms over three neighbouring poses at a time, in mixed units.
Chain random_chain(Random& random, std::size_t poses) {
  Chain chain(poses);
  for (std::size_t first = 0; first < poses; ++first) {
    const std::size_t count = std::min<std::size_t>(3, poses - first);
    Eigen::MatrixXd J = random_matrix(random, 24, static_cast<Eigen::Index>(6 * count));
    for (Eigen::Index c = 0; c < J.cols(); ++c) {
      J.col(c) *= std::pow(10.0, 0.4 * static_cast<double>(c % 6) - 1.0);
    }
    const Eigen::MatrixXd products = J.transpose() * J;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        chain.add(first + i, first + j, products.block<6, 6>(6 * i, 6 * j));
      }
    }
  }
  for (std::size_t i = 0; i < poses; ++i) {
    const Twist gradient = random.twist(5.0, 5.0);
    chain.system.add(i, gradient);
    chain.g.segment<6>(6 * i) += gradient;
  }
  return chain;
}

TEST(BandedSystem, StepAndCovarianceEqualTheDenseOnes) {
  Random random(1);
  for (std::size_t poses = 1; poses <= 20; ++poses) {
    Chain chain = random_chain(random, poses);
    ASSERT_TRUE(chain.system.factorise()) << poses << " poses";
    const Eigen::VectorXd expected = test::solve(chain.H, -chain.g);
    const Eigen::MatrixXd inverse = test::inverse(chain.H);
    const auto step = chain.system.solve();
    const auto covariance = chain.system.covariance();
    ASSERT_EQ(step.size(), poses);
    for (std::size_t i = 0; i < poses; ++i) {
      EXPECT_LT((step[i] - expected.segment<6>(6 * i)).norm(), 1e-9 * expected.norm());
      for (std::size_t j = 0; j < poses; ++j) {
        if (std::max(i, j) - std::min(i, j) > 2) continue;
        const Matrix6 block = inverse.block<6, 6>(6 * i, 6 * j);
        EXPECT_LT((covariance(i, j) - block).norm(), 1e-9 * inverse.norm())
            << "block " << i << ", " << j << " of " << poses;
      }
    }
  }
}

// A way's knots, a few milliseconds apart: what joins neighbours is far stronger than what holds
// each of them.
TEST(BandedSystem, ALongChainsCovarianceIsAsGoodAsAShortOnes) {
  Random random(5);
  for (const std::size_t poses : {66U, 122U, 1002U}) {
    BandedSystem system(poses);
    KnotWindow window;
    window.first_step = window.step = 0.004;
    window.knots.resize(poses);
    VelocityModel(Config{}.knots).add_to(system, window, Eigen::Quaterniond::Identity());
    for (std::size_t i = 0; i < poses; ++i) {
      for (int point = 0; point < 5; ++point) {
        const Twist row = random.twist(1.0, 10.0);
        system.add(i, i, 3000.0 * row * row.transpose());
      }
    }
    BandedSystem factors = system;
    ASSERT_TRUE(factors.factorise());
    const auto covariance = factors.covariance();
    for (const std::size_t at : {std::size_t{0}, poses / 2, poses - 2}) {
      for (int axis = 0; axis < 6; ++axis) {
        BandedSystem unit = system;
        unit.add(at, -Twist::Unit(axis));
        ASSERT_TRUE(unit.factorise());
        const auto column = unit.solve();
        EXPECT_LT((covariance(at, at).col(axis) - column[at]).norm(), 1e-8 * column[at].norm());
        EXPECT_LT((covariance(at + 1, at).col(axis) - column[at + 1]).norm(),
                  1e-8 * column[at].norm());
      }
    }
  }
}

TEST(BandedSystem, ChainsAddUp) {
  Random random(3);
  const Chain a = random_chain(random, 6), b = random_chain(random, 6);
  BandedSystem sum = a.system;
  sum.add(b.system, 0.7);
  ASSERT_TRUE(sum.factorise());
  const Eigen::VectorXd expected = test::solve(a.H + 0.7 * b.H, -(a.g + 0.7 * b.g));
  const auto step = sum.solve();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_LT((step[i] - expected.segment<6>(6 * i)).norm(), 1e-9 * expected.norm());
  }
}

TEST(BandedSystem, TermsAddUp) {
  Random random(2);
  const Chain chain = random_chain(random, 5);
  BandedSystem once = chain.system, twice = chain.system;
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = i > 2 ? i - 2 : 0; j <= i; ++j) {
      twice.add(i, j, chain.H.block<6, 6>(6 * i, 6 * j));
    }
  }
  ASSERT_TRUE(once.factorise() && twice.factorise());
  const auto a = once.solve(), b = twice.solve();
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LT((a[i] - 2.0 * b[i]).norm(), 1e-12);
}

TEST(BandedSystem, WhatIsNotPositiveDefiniteIsToldSo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::size_t at : {0U, 3U, 6U}) {
    Random random(3);
    Chain chain = random_chain(random, 7);
    ASSERT_TRUE(BandedSystem(chain.system).factorise());
    for (const double bad : {-1e6, nan, infinity}) {
      BandedSystem system = chain.system;
      Matrix6 block = Matrix6::Zero();
      block(4, 4) = bad;
      system.add(at, at, block);
      EXPECT_FALSE(system.factorise()) << bad << " at pose " << at;
    }
    if (at == 0) continue;
    BandedSystem system = chain.system;
    system.add(at, at - 1, Matrix6::Constant(nan));
    EXPECT_FALSE(system.factorise()) << "beside the diagonal at pose " << at;
  }
}

TEST(BandedSystem, APoseWithoutTermsIsSingular) {
  for (const std::size_t without : {0U, 2U, 4U}) {
    BandedSystem system(5);
    for (std::size_t i = 0; i < 5; ++i) {
      if (i != without) system.add(i, i, Matrix6::Identity());
    }
    EXPECT_FALSE(system.factorise());
  }
  // Poses that are only tied to each other may still move together.
  BandedSystem loose(2);
  loose.add(0, 0, Matrix6::Identity());
  loose.add(1, 0, -Matrix6::Identity());
  loose.add(1, 1, Matrix6::Identity());
  EXPECT_FALSE(loose.factorise());
}

}  // namespace
}  // namespace surefoot
