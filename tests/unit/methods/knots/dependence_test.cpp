// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/dependence.hpp"

#include <gtest/gtest.h>

#include "support/dense_algebra.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

constexpr std::size_t kSegments = 8;
constexpr double kFreedom = 24.0 / 18.0;  // of three sums a segment

Matrix6 turned(const Matrix6& own, const Eigen::Quaterniond& rotation) {
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = rotation.toRotationMatrix();
  return turn * own * turn.transpose();
}

Matrix6 random_information(Random& random) {
  Matrix6 H = Matrix6::Identity();
  for (int i = 0; i < 8; ++i) {
    const Twist row = random.twist(2.0, 2.0);
    H += row * row.transpose();
  }
  return H;
}

/// What is learnt from of a registration, at random, in the sensor's axes.
KnotRegistration registration(Random& random) {
  KnotRegistration found;
  found.rigid.H = random_information(random);
  found.rigid.weighted_squares = 60.0;
  found.rigid.count = 20;
  found.neighbours.resize(kSegments);
  for (auto& segment : found.neighbours) {
    for (Twist& gradient : segment) gradient = random.twist(3.0, 3.0);
  }
  return found;
}

KnotRegistration turned(KnotRegistration found, const Eigen::Quaterniond& rotation) {
  found.rigid.H = turned(found.rigid.H, rotation);
  for (auto& segment : found.neighbours) {
    for (Twist& gradient : segment) gradient = rotated(rotation, gradient);
  }
  return found;
}

KnotRegistration times(double factor, KnotRegistration found) {
  for (auto& segment : found.neighbours) {
    for (Twist& gradient : segment) gradient *= factor;
  }
  return found;
}

Matrix6 products(const KnotRegistration& found) {
  Matrix6 sum = Matrix6::Zero();
  for (const auto& segment : found.neighbours) {
    for (const Twist& gradient : segment) sum += gradient * gradient.transpose();
  }
  return sum;
}

TEST(Dependence, UntilAnythingWasLearntItIsUnknown) {
  Random random(1);
  const Matrix6 covariance = random_information(random);
  const Dependence dependence(7.0);
  const Eigen::Quaterniond attitude = so3_exp({0.3, -0.2, 1.0});
  EXPECT_LT((dependence.applied(covariance, attitude) - 7.0 * covariance).norm(), 1e-12);
  EXPECT_EQ(dependence.mean(), 7.0);
}

TEST(Dependence, IsThatOfEachOfTheSensorsAxes) {
  Random random(2);
  const KnotRegistration found = registration(random);
  const Matrix6 C = test::inverse(found.rigid.H);
  const Twist spread = kFreedom * (C * products(found) * C).diagonal();
  const Twist expected = spread.cwiseQuotient(3.0 * C.diagonal());
  EXPECT_GT(expected.maxCoeff(), 1.2 * expected.minCoeff());  // or one for all would do
  const Eigen::Quaterniond attitude = so3_exp({0.3, -0.2, 1.0});
  Dependence dependence(10.0);
  dependence.learn(turned(found, attitude), attitude, 0.1);
  EXPECT_LT((dependence.factors() - expected).norm(), 1e-9 * expected.norm());

  const Matrix6 independent = random_information(random);
  const Twist root = expected.cwiseSqrt();
  const Matrix6 scaled = root.asDiagonal() * independent * root.asDiagonal();
  const Eigen::Quaterniond later = so3_exp({0.1, 0.2, -2.0});
  const Matrix6 applied = dependence.applied(turned(independent, later), later);
  EXPECT_LT((applied - turned(scaled, later)).norm(), 1e-9 * scaled.norm());
}

TEST(Dependence, WhatAllScansErrByAlikeCountsInTheMeanOnly) {
  Random random(3);
  const KnotRegistration always = registration(random);
  Dependence alike(1.0), fluctuates(1.0);
  for (int i = 0; i < 200; ++i) {
    alike.learn(always, Eigen::Quaterniond::Identity(), 0.1);
    fluctuates.learn(times(i % 2 == 0 ? 1.0 : -1.0, always), Eigen::Quaterniond::Identity(), 0.1);
  }
  const Matrix6 C = test::inverse(always.rigid.H);
  const double mean = kFreedom * (C * products(always)).trace() / 18.0;
  EXPECT_NEAR(alike.mean(), mean, 1e-6 * mean);
  EXPECT_NEAR(fluctuates.mean(), mean, 1e-6 * mean);
  EXPECT_LT(alike.factors().maxCoeff(), 0.01 * fluctuates.factors().minCoeff());
}

TEST(Dependence, FadesAtItsRate) {
  Random random(4);
  const KnotRegistration before = registration(random);
  const KnotRegistration after = times(3.0, before);
  Dependence dependence(1.0);
  // Signs in turns leave nothing that all have in common.
  for (int i = 0; i < 300; ++i) {
    dependence.learn(times(i % 2 == 0 ? 1.0 : -1.0, before), Eigen::Quaterniond::Identity(), 0.1);
  }
  const Twist first = dependence.factors();
  dependence.learn(after, Eigen::Quaterniond::Identity(), 0.1);
  EXPECT_GT(dependence.factors()[0], 1.5 * first[0]);  // 1.8 and what differs from the usual
  EXPECT_LT(dependence.factors()[0], 2.1 * first[0]);
}

// What all scans err by alike would be forgotten, and each gap would make the next scans vague.
TEST(Dependence, ABridgedGapOfMoreSegmentsTellsNothing) {
  Random random(5);
  Dependence dependence(1.0);
  const KnotRegistration usual = registration(random);
  KnotRegistration longer = usual;
  longer.neighbours.resize(3 * kSegments, usual.neighbours.front());
  for (int i = 0; i < 50; ++i) dependence.learn(usual, Eigen::Quaterniond::Identity(), 0.1);
  const Twist before = dependence.factors();
  dependence.learn(longer, Eigen::Quaterniond::Identity(), 0.1);
  EXPECT_EQ(dependence.factors(), before);
  dependence.learn(usual, Eigen::Quaterniond::Identity(), 0.1);
  EXPECT_LE(dependence.factors().maxCoeff(), 1.001 * before.maxCoeff());
}

TEST(Dependence, AnotherSizeIsTheUsualOneOnceItStays) {
  Random random(6);
  Dependence dependence(1.0);
  KnotRegistration first = registration(random);
  first.neighbours.resize(kSegments + 3, first.neighbours.front());
  dependence.learn(first, Eigen::Quaterniond::Identity(), 0.1);
  const KnotRegistration usual = times(2.0, registration(random));
  Dependence without(1.0);
  for (int i = 0; i < 60; ++i) {
    dependence.learn(usual, Eigen::Quaterniond::Identity(), 0.1);
    if (i >= 2) without.learn(usual, Eigen::Quaterniond::Identity(), 0.1);
  }
  EXPECT_TRUE(dependence.factors().isApprox(without.factors(), 1e-9));
}

TEST(Dependence, WithoutResidualsNothingIsLearnt) {
  Dependence dependence(4.0);
  dependence.learn(KnotRegistration{}, Eigen::Quaterniond::Identity(), 0.1);
  EXPECT_EQ(dependence.factors(), Twist::Constant(4.0));
}

}  // namespace
}  // namespace surefoot
