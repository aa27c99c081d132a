// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/held_back.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "methods/knots/knot_window.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

const Eigen::Quaterniond kLevel = Eigen::Quaterniond::Identity();

Twist tilting(double rate) { return (Twist() << 0.2, 0.2, 0.2, rate, rate, 0.2).finished(); }

TEST(HeldBack, IsThePosesOwnAndHalfTheUsual) {
  Random random(1);
  const Twist now = random.twist(0.01, 0.01), before = random.twist(0.01, 0.01);
  HeldBack held_back(HeldBack::Mean::counted);
  const Matrix6 own = now * now.transpose();
  EXPECT_LT((held_back.covariance(now, tilting(0.5), kLevel) - own).norm(), 1e-15);
  held_back.learn(before, kLevel, 0.25);
  const Matrix6 expected = own + 0.5 * 0.25 * before * before.transpose();
  EXPECT_LT((held_back.covariance(now, tilting(0.5), kLevel) - expected).norm(), 1e-15);
}

TEST(HeldBack, CountsTheMoreTheMoreTheTiltFluctuates) {
  const Twist now = Twist::Constant(0.01);
  const auto variance = [&now](double tilt) {
    return HeldBack(HeldBack::Mean::left_out).covariance(now, tilting(tilt), kLevel)(0, 0);
  };
  EXPECT_NEAR(variance(1.0), 2.0 * variance(0.5), 1e-15);
  EXPECT_LT(variance(0.1), variance(0.5));
  EXPECT_EQ(variance(0.0), variance(0.1));  // but nothing is followed without end
}

TEST(HeldBack, TheUsualTurnsWithTheSensor) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Quaterniond attitude = so3_exp(random.twist(1.0, 1.0).tail<3>());
    const Eigen::Quaterniond turn = so3_exp({0.0, 0.0, random.uniform(-3.0, 3.0)});
    const Twist before = random.twist(0.01, 0.01), now = random.twist(0.01, 0.01);
    HeldBack here(HeldBack::Mean::left_out), there(HeldBack::Mean::left_out);
    here.learn(before, attitude, 0.5);
    there.learn(rotated(turn, before), turn * attitude, 0.5);
    Matrix6 both = Matrix6::Zero();
    both.topLeftCorner<3, 3>() = both.bottomRightCorner<3, 3>() = turn.toRotationMatrix();
    const Matrix6 expected = both * here.covariance(now, tilting(0.3), attitude) * both.transpose();
    const Matrix6 found = there.covariance(rotated(turn, now), tilting(0.3), turn * attitude);
    EXPECT_LT((found - expected).norm(), 1e-15);
  }
}

TEST(HeldBack, WhatAllPosesAreHeldBackByAlikeIsNoErrorOfAMotion) {
  Random random(3);
  const Twist always = random.twist(0.01, 0.01), now = random.twist(0.01, 0.01);
  HeldBack left_out(HeldBack::Mean::left_out), counted(HeldBack::Mean::counted);
  for (int i = 0; i < 400; ++i) {
    left_out.learn(always, kLevel, 0.1);
    counted.learn(always, kLevel, 0.1);
  }
  const Twist own = now - always;
  EXPECT_LT((left_out.covariance(now, tilting(0.5), kLevel) - own * own.transpose()).norm(), 1e-9);
  const Matrix6 all = now * now.transpose() + 0.5 * always * always.transpose();
  EXPECT_LT((counted.covariance(now, tilting(0.5), kLevel) - all).norm(), 1e-9);
}

/// Having learnt from so many scans, held back by two twists in turn.
HeldBack held_back_by(const Twist& even, const Twist& odd, int scans) {
  HeldBack held_back(HeldBack::Mean::counted);
  for (int i = 0; i < scans; ++i) held_back.learn(i % 2 == 0 ? even : odd, kLevel, 0.1);
  return held_back;
}

TEST(HeldBack, WhatAlternatesIsLetGoAndWhatLastsIsNot) {
  Random random(4);
  const Twist a = random.twist(0.01, 0.01), now = random.twist(0.01, 0.01);
  EXPECT_LT((held_back_by(a, -a, 200).let_go(now, kLevel) - now).norm(), 1e-15);
  EXPECT_EQ(held_back_by(a, a, 200).let_go(now, kLevel), Twist(Twist::Zero()));
}

TEST(HeldBack, EachAxisIsLetGoByItself) {
  Twist even = Twist::Constant(0.01), odd = even;
  odd[2] = odd[4] = -0.01;
  const Twist now = Twist::Constant(0.02);
  Twist expected = Twist::Zero();
  expected[2] = expected[4] = 0.02;
  EXPECT_LT((held_back_by(even, odd, 200).let_go(now, kLevel) - expected).norm(), 1e-15);
}

TEST(HeldBack, NothingIsLetGoUntilItIsKnownToAlternate) {
  const Twist a = Twist::Constant(0.01);
  EXPECT_EQ(held_back_by(a, -a, 0).let_go(a, kLevel), Twist(Twist::Zero()));
  // n scans say -(n - 1)/n, and 20 that it lasts: 1 is let go of at 0, nothing at 0.4 and more.
  for (const int n : {5, 10, 12, 15, 20}) {
    const double alike = (20.0 - (n - 1.0)) / (n + 20.0);
    const Twist expected = std::clamp(1.0 - alike / 0.4, 0.0, 1.0) * a;
    EXPECT_LT((held_back_by(a, -a, n).let_go(a, kLevel) - expected).norm(), 1e-15) << n;
  }
}

TEST(HeldBack, WhatIsLetGoTurnsWithTheSensor) {
  Random random(5);
  const Eigen::Quaterniond attitude = so3_exp(random.twist(1.0, 1.0).tail<3>());
  const Eigen::Quaterniond turn = so3_exp({0.0, 0.0, 1.0});
  HeldBack here(HeldBack::Mean::left_out), there(HeldBack::Mean::left_out);
  for (int i = 0; i < 60; ++i) {
    const Twist before = random.twist(0.01, 0.01);
    here.learn(before, attitude, 0.1);
    there.learn(rotated(turn, before), turn * attitude, 0.1);
  }
  const Twist now = random.twist(0.01, 0.01);
  const Twist found = there.let_go(rotated(turn, now), turn * attitude);
  EXPECT_GT(found.norm(), 1e-3);
  EXPECT_LT((found - rotated(turn, here.let_go(now, attitude))).norm(), 1e-15);
}

}  // namespace
}  // namespace surefoot
