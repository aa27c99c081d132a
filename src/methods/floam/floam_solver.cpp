// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/floam_solver.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "methods/shared/levenberg_marquardt.hpp"

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr double kHuber = 0.1;           // [m] where the loss turns linear
constexpr int kMaxSteps = 4;             // of Levenberg-Marquardt
constexpr double kLineRatio = 3.0;       // largest eigenvalue against the second, of a line
constexpr double kPlaneTolerance = 0.2;  // [m] of a plane's neighbours

/// Ceres' Huber loss rho(r^2) and its derivative.
struct HuberLoss {
  double value, slope;
};
HuberLoss huber(double squared) {
  if (squared <= kHuber * kHuber) return {squared, 1.0};
  const double norm = std::sqrt(squared);
  return {2.0 * kHuber * norm - kHuber * kHuber, kHuber / norm};
}

Linearisation<6> linearise(const std::vector<FloamResidual>& residuals, const Pose& T,
                           const Workers& workers) {
  const Eigen::Matrix3d R = T.rotation.toRotationMatrix();
  return workers.sum<Linearisation<6>>(residuals.size(), [&](std::size_t begin, std::size_t end) {
    Linearisation<6> sum;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d placed = R * residuals[i].point + T.translation;
      const Eigen::Matrix<double, 1, 1> r(floam_residual(residuals[i], placed));
      const HuberLoss loss = huber(r.squaredNorm());
      sum.equations.add<1>(floam_jacobian(residuals[i], placed), r, loss.slope);
      sum.cost += 0.5 * loss.value;
    }
    return sum;
  });
}

struct Scatter {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  SymmetricEigen<3> eigen;
};
Scatter scatter_of(std::span<const Eigen::Vector3d, 5> neighbours) {
  Scatter scatter;
  for (const Eigen::Vector3d& point : neighbours) scatter.centre += point / 5.0;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : neighbours) {
    sum += (point - scatter.centre) * (point - scatter.centre).transpose();
  }
  scatter.eigen = symmetric_eigen(sum);
  return scatter;
}

/// Norm of the seven parameters: unit quaternion and translation.
double pose_norm(const Pose& T) { return std::sqrt(1.0 + T.translation.squaredNorm()); }

}  // namespace

double floam_residual(const FloamResidual& residual, const Eigen::Vector3d& placed) {
  if (residual.kind == FloamResidual::Kind::surface) {
    return residual.direction.dot(placed) + residual.offset;
  }
  return residual.direction.cross(placed - residual.anchor).norm();
}

Eigen::Matrix<double, 1, 6> floam_jacobian(const FloamResidual& residual,
                                           const Eigen::Vector3d& placed) {
  Eigen::Vector3d gradient = residual.direction;  // by the placed point
  if (residual.kind == FloamResidual::Kind::edge) {
    const Eigen::Vector3d apart = placed - residual.anchor;
    gradient = apart - residual.direction * residual.direction.dot(apart);
    const double norm = gradient.norm();
    gradient = norm > 0.0 ? Eigen::Vector3d(gradient / norm) : Eigen::Vector3d::Zero();
  }
  Eigen::Matrix<double, 1, 6> J;
  J << gradient.transpose(), placed.cross(gradient).transpose();
  return J;
}

bool fit_line(std::span<const Eigen::Vector3d, 5> neighbours, FloamResidual& residual) {
  const Scatter scatter = scatter_of(neighbours);
  residual.kind = FloamResidual::Kind::edge;
  residual.anchor = scatter.centre;
  residual.direction = scatter.eigen.vectors.col(2);
  return scatter.eigen.values[2] > kLineRatio * scatter.eigen.values[1];
}

bool fit_plane(std::span<const Eigen::Vector3d, 5> neighbours, bool centred,
               FloamResidual& residual) {
  residual.kind = FloamResidual::Kind::surface;
  if (centred) {
    const Scatter scatter = scatter_of(neighbours);
    residual.direction = scatter.eigen.vectors.col(0);
    residual.offset = -residual.direction.dot(scatter.centre);
  } else {
    Eigen::Matrix<double, 5, 3> A;
    for (Eigen::Index i = 0; i < 5; ++i) {
      A.row(i) = neighbours[static_cast<std::size_t>(i)].transpose();
    }
    const Eigen::Matrix<double, 5, 1> b = -Eigen::Matrix<double, 5, 1>::Ones();
    const Eigen::Vector3d n = A.colPivHouseholderQr().solve(b);
    const double norm = n.norm();
    if (!(norm > 0.0) || !std::isfinite(norm)) return false;
    residual.direction = n / norm;
    residual.offset = 1.0 / norm;
  }
  return std::all_of(neighbours.begin(), neighbours.end(), [&](const Eigen::Vector3d& point) {
    return std::abs(residual.direction.dot(point) + residual.offset) <= kPlaneTolerance;
  });
}

FloamSolution solve_floam(const std::vector<FloamResidual>& residuals, const Pose& T_map_lidar,
                          const Workers& workers) {
  const auto minimum = minimise<6>(
      T_map_lidar, kMaxSteps, [&](const Pose& T) { return linearise(residuals, T, workers); },
      [](const Pose& T, const Twist& delta) { return se3_exp(delta) * T; }, pose_norm);
  return {minimum.state, minimum.here.equations, minimum.steps, minimum.converged};
}

}  // namespace surefoot
