// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/decompositions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/so3.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

template <int Size>
Eigen::Matrix<double, Size, Size> random_matrix(test::Random& random) {
  Eigen::Matrix<double, Size, Size> result;
  for (int i = 0; i < Size * Size; ++i) result(i) = random.uniform(-1.0, 1.0);
  return result;
}

template <int Size>
void expect_decomposed(const Eigen::Matrix<double, Size, Size>& H,
                       const SymmetricEigen<Size>& eigen, double tolerance) {
  for (int i = 1; i < Size; ++i) EXPECT_LE(eigen.values[i - 1], eigen.values[i]);
  EXPECT_LT((H * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), tolerance);
  EXPECT_LT((eigen.vectors.transpose() * eigen.vectors).diagonal().cwiseAbs().maxCoeff(),
            1.0 + tolerance);
  EXPECT_NEAR(std::abs(eigen.vectors.determinant()), 1.0, tolerance);
}

TEST(Decompositions, EigenvectorsAreScaledByTheirValues) {
  test::Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix3d a = random_matrix<3>(random);
    const Eigen::Matrix3d H = a * a.transpose();
    expect_decomposed<3>(H, symmetric_eigen(H), 1e-12);
    expect_decomposed<3>(H, symmetric_eigen_direct(H), 1e-12);
    const auto b = random_matrix<6>(random);
    const Eigen::Matrix<double, 6, 6> indefinite = b + b.transpose();
    expect_decomposed<6>(indefinite, symmetric_eigen(indefinite), 1e-12);
  }
}

// What a plate, a line and a ball spread alike has no axes of its own, and those of what nearly
// does are easily wrong.
TEST(Decompositions, ClosedFormHoldsWhereValuesAgree) {
  test::Random random(7);
  const Eigen::Vector3d shapes[] = {{0.0, 1.0, 1.0},  {0.0, 0.0, 1.0},         {1.0, 1.0, 1.0},
                                    {0.0, 0.0, 0.0},  {1e-9, 1.0, 1.0 + 1e-9}, {1e-9, 2e-9, 1.0},
                                    {-1.0, 0.0, 1.0}, {1.0, 1.0 + 1e-12, 2.0}, {-2.0, 1.0, 1.0}};
  for (const Eigen::Vector3d& shape : shapes) {
    for (const double scale : {1e-60, 1e-8, 1.0, 1e6}) {
      const Eigen::Matrix3d R =
          Eigen::AngleAxisd(random.uniform(0.0, 3.0), random.unit_vector()).toRotationMatrix();
      for (const Eigen::Matrix3d& turn : {R, Eigen::Matrix3d(Eigen::Matrix3d::Identity())}) {
        const Eigen::Matrix3d H = turn * shape.asDiagonal() * turn.transpose();
        const SymmetricEigen<3> eigen = symmetric_eigen_direct(Eigen::Matrix3d(scale * H));
        expect_decomposed<3>(H, {eigen.values / scale, eigen.vectors}, 1e-12);
        EXPECT_LT((eigen.values / scale - shape).norm(), 1e-12);
      }
    }
  }
}

TEST(Decompositions, ClosedFormOfWhatIsAsGoodAsNothing) {
  const Eigen::Matrix3d H = Eigen::Vector3d(1e-130, 2e-130, 4e-130).asDiagonal();
  const SymmetricEigen<3> eigen = symmetric_eigen_direct(H);
  expect_decomposed<3>(H, eigen, 1e-15);
}

TEST(Decompositions, ClosedFormOfTwoDimensions) {
  test::Random random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix2d a = random_matrix<2>(random);
    const Eigen::Matrix2d H = a + a.transpose();
    expect_decomposed<2>(H, symmetric_eigen_direct(H(0, 0), H(0, 1), H(1, 1)), 1e-14);
  }
  expect_decomposed<2>(Eigen::Matrix2d::Zero(), symmetric_eigen_direct(0.0, 0.0, 0.0), 1e-15);
}

TEST(Decompositions, SingularValuesPutTheMatrixTogetherAgain) {
  test::Random random(4);
  const Eigen::Matrix3d matrix = random_matrix<3>(random);
  const auto [U, V, values] = svd(matrix);
  EXPECT_LT((U * values.asDiagonal() * V.transpose() - matrix).norm(), 1e-12);
  EXPECT_GE(values[0], values[1]);
  EXPECT_GE(values[1], values[2]);
}

// Any small turn of the nearest rotation is farther from the matrix.
TEST(Decompositions, NoRotationIsNearerThanTheNearest) {
  test::Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix3d matrix = random_matrix<3>(random);  // every other one mirrors
    const Eigen::Matrix3d R = nearest_rotation(matrix);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    for (int turn = 0; turn < 20; ++turn) {
      const Eigen::AngleAxisd by(1e-3, random.unit_vector());
      EXPECT_GE((R * by.toRotationMatrix() - matrix).norm(), (R - matrix).norm());
    }
  }
}

TEST(So3, RotationBetweenIsTheShortestThatTurnsOneToTheOther) {
  test::Random random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector3d from = random.unit_vector(), to = random.unit_vector();
    const Eigen::Quaterniond turn = rotation_between(3.0 * from, 0.5 * to);
    EXPECT_LT((turn * from - to).norm(), 1e-12);
    EXPECT_NEAR(std::abs(turn.angularDistance(Eigen::Quaterniond::Identity())),
                std::acos(from.dot(to)), 1e-7);
  }
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_LT((rotation_between(up, up) * up - up).norm(), 1e-15);
  EXPECT_LT((rotation_between(up, -up) * up + up).norm(), 1e-15);
  for (const double short_of_half_a_turn : {1e-3, 1e-5, 2e-6, 1e-6}) {
    const Eigen::Vector3d to =
        Eigen::AngleAxisd(M_PI - short_of_half_a_turn, Eigen::Vector3d::UnitX()) * up;
    const Eigen::Quaterniond turn = rotation_between(up, to);
    EXPECT_NEAR(turn.norm(), 1.0, 1e-15) << short_of_half_a_turn;
    EXPECT_LT((turn * up - to).norm(), 2e-6) << short_of_half_a_turn;
  }
}

}  // namespace
}  // namespace surefoot
