// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "support/matrix_exponential.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace surefoot::test {

namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) m.col(i) = v.cross(Eigen::Vector3d::Unit(i));
  return m;
}

}  // namespace

Eigen::Matrix4d matrix_exponential(const Twist& twist) {
  Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
  generator.topLeftCorner<3, 3>() = cross_matrix(twist.tail<3>());
  generator.topRightCorner<3, 1>() = twist.head<3>();
  return generator.exp();
}

Eigen::Matrix3d rotation_exponential(const Eigen::Vector3d& rotation_vector) {
  return cross_matrix(rotation_vector).exp();
}

Twist matrix_logarithm(const Eigen::Matrix4d& motion) {
  const Eigen::Matrix4d generator = motion.log();
  Twist twist;
  twist.head<3>() = generator.topRightCorner<3, 1>();
  twist.tail<3>() << generator(2, 1), generator(0, 2), generator(1, 0);
  return twist;
}

}  // namespace surefoot::test
