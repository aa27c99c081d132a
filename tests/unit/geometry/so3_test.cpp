// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Rotations: exp and log against Eigen's general matrix exponential, the left Jacobian against
// numerical derivatives.
#include "geometry/so3.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/matrix_exponential.hpp"
#include "support/random.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {
namespace {

using test::Random;

constexpr double kPi = std::numbers::pi;

/// Angles where formulae tend to break: zero, denormal squares, both series' ends, pi.
const std::vector<double> kHardAngles = {0.0,    1e-200,     1e-12,      1e-8,      1e-7, 0.9e-4,
                                         1.1e-4, 0.99e-2,    1.01e-2,    0.1,       1.0,  0.5 * kPi,
                                         3.0,    kPi - 1e-2, kPi - 1e-4, kPi - 1e-8};

TEST(So3, ExponentialAgreesWithTheMatrixExponential) {
  Random random(1);
  for (const double angle : kHardAngles) {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d v = angle * random.unit_vector();
      const Eigen::Matrix3d R = so3_exp(v).toRotationMatrix();
      EXPECT_LT((R - test::rotation_exponential(v)).norm(), 5e-15) << "angle " << angle;
    }
  }
}

TEST(So3, RoundTripFromRotationVectorsAtEveryAngle) {
  Random random(2);
  for (const double angle : kHardAngles) {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d v = angle * random.unit_vector();
      EXPECT_LT((so3_log(so3_exp(v)) - v).norm(), 1e-15 + 4e-15 * angle) << "angle " << angle;
    }
  }
}

TEST(So3, TinyRotationsKeepTheirRelativePrecision) {
  const Eigen::Vector3d v(1e-8, -2e-8, 3e-8);
  EXPECT_LT((so3_log(so3_exp(v)) - v).norm(), 1e-15 * v.norm());
}

TEST(So3, AtPiEitherAxisIsTheSameRotation) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d axis = random.unit_vector();
    const Eigen::Vector3d back = so3_log(so3_exp(kPi * axis));
    EXPECT_NEAR(back.norm(), kPi, 1e-14);
    EXPECT_NEAR(std::abs(back.dot(axis)), kPi, 1e-14);
  }
}

TEST(So3, LogIsTheShorterWayRoundForEitherSignOfTheQuaternion) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d v = random.uniform(0.0, 3.1) * random.unit_vector();
    Eigen::Quaterniond q = so3_exp(v);
    q.coeffs() = -q.coeffs();
    EXPECT_LT((so3_log(q) - v).norm(), 1e-14);
  }
}

TEST(So3, RotationsBeyondPiComeBackTheOtherWay) {
  const Eigen::Vector3d back = so3_log(so3_exp({0.0, 0.0, kPi + 0.3}));
  EXPECT_LT((back - Eigen::Vector3d(0.0, 0.0, 0.3 - kPi)).norm(), 1e-14);
}

TEST(So3, HatIsTheCrossProduct) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d a = random.vector(5.0), b = random.vector(5.0);
    EXPECT_LT((hat(a) * b - a.cross(b)).norm(), 1e-14);
  }
}

/// J_l(phi) d = d/de log(exp(phi + e d) exp(phi)^-1) at e = 0, by central differences.
Eigen::Vector3d numerical_left_jacobian(const Eigen::Vector3d& phi, const Eigen::Vector3d& d) {
  constexpr double kStep = 1e-5;
  const Eigen::Quaterniond back = so3_exp(phi).conjugate();
  const auto turned = [&](double e) { return so3_log(so3_exp(phi + e * d) * back); };
  return (turned(kStep) - turned(-kStep)) / (2.0 * kStep);
}

TEST(So3, LeftJacobianIsTheDerivativeOfTheExponential) {
  Random random(6);
  for (const double angle : {0.0, 1e-8, 1e-4, 0.99e-2, 1.01e-2, 0.3, 1.0, 2.5, 3.1}) {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d phi = angle * random.unit_vector();
      const Eigen::Vector3d d = random.unit_vector();
      const Eigen::Vector3d expected = numerical_left_jacobian(phi, d);
      EXPECT_LT((so3_left_jacobian(phi) * d - expected).norm(), 1e-9) << "angle " << angle;
    }
  }
}

TEST(So3, LeftJacobianIsTheMeanOfTheRotationsOnTheWay) {
  // J_l(phi) = integral of exp(u phi) over u in [0, 1]; midpoint rule with 2,000 cells.
  constexpr int kCells = 2000;
  const Eigen::Vector3d phi(0.7, -1.1, 0.4);
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kCells; ++i) {
    mean += so3_exp((i + 0.5) / kCells * phi).toRotationMatrix() / kCells;
  }
  EXPECT_LT((so3_left_jacobian(phi) - mean).norm(), 1e-6);
}

TEST(So3, LeftJacobianInverseInvertsUpToPi) {
  Random random(7);
  for (const double angle : kHardAngles) {
    const Eigen::Vector3d phi = angle * random.unit_vector();
    const Eigen::Matrix3d product = so3_left_jacobian_inverse(phi) * so3_left_jacobian(phi);
    EXPECT_LT((product - Eigen::Matrix3d::Identity()).norm(), 1e-12) << "angle " << angle;
  }
}

TEST(So3, SeriesAndClosedFormMeetWithoutAStep) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -1.0).normalized();
  const double below = std::nextafter(1e-2, 0.0), above = 1e-2 * (1.0 + 1e-12);
  EXPECT_LT((so3_left_jacobian(below * axis) - so3_left_jacobian(above * axis)).norm(), 1e-13);
  EXPECT_LT(
      (so3_left_jacobian_inverse(below * axis) - so3_left_jacobian_inverse(above * axis)).norm(),
      1e-13);
}

}  // namespace
}  // namespace surefoot
