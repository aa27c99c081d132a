// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/pose_graph_solver.hpp"

#include <ceres/ceres.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "geometry/decompositions.hpp"

namespace surefoot::mapping {

namespace {

using Parameters = std::array<double, 7>;  // qx qy qz qw, x y z

Pose pose_of(const double* parameters) {
  return {Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(parameters)),
          Eigen::Map<const Eigen::Vector3d>(parameters + 4)};
}

void write_pose(const Pose& pose, double* parameters) {
  Eigen::Map<Eigen::Vector4d>(parameters).operator=(pose.rotation.coeffs());
  Eigen::Map<Eigen::Vector3d>(parameters + 4).operator=(pose.translation);
}

/// A pose moves in its own frame. The cost functions give their derivatives by that motion, in the
/// first six columns, so that nothing needs to be differentiated by the seven numbers.
class RigidMotion final : public ceres::Manifold {
 public:
  [[nodiscard]] int AmbientSize() const override { return 7; }
  [[nodiscard]] int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* moved) const override {
    write_pose(pose_of(x) * se3_exp(Eigen::Map<const Twist>(delta)), moved);
    return true;
  }
  bool PlusJacobian(const double* /*x*/, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>> J(jacobian);
    J.setZero();
    J.topRows<6>().setIdentity();
    return true;
  }
  bool Minus(const double* y, const double* x, double* difference) const override {
    Eigen::Map<Twist>(difference).operator=(se3_log(pose_of(x).inverse() * pose_of(y)));
    return true;
  }
  bool MinusJacobian(const double* /*x*/, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> J(jacobian);
    J.setZero();
    J.leftCols<6>().setIdentity();
    return true;
  }
};

/// A root of a matrix that may be singular.
Matrix6 square_root(const Matrix6& information) {
  const SymmetricEigen<6> eigen = symmetric_eigen(information);
  return eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() * eigen.vectors.transpose();
}

class EdgeCost final : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  EdgeCost(const PoseEdge& edge, double weight)
      : edge_(edge), root_(square_root(weight * edge.information)) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Pose from = pose_of(parameters[0]);
    const Pose to = pose_of(parameters[1]);
    const Twist error = edge_error(edge_, from, to);
    Eigen::Map<Twist>(residuals).operator=(root_ * error);
    if (jacobians == nullptr) return true;
    const EdgeJacobians by = edge_jacobians(error, from, to);
    fill(by.from, jacobians[0]);
    fill(by.to, jacobians[1]);
    return true;
  }

 private:
  void fill(const Matrix6& by_motion, double* jacobian) const {
    if (jacobian == nullptr) return;
    Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> J(jacobian);
    J.leftCols<6>() = root_ * by_motion;
    J.col(6).setZero();
  }

  const PoseEdge& edge_;
  Matrix6 root_;
};

ceres::Solver::Options solver_options(int max_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_iterations;
  options.num_threads = 1;  // the same sums in the same order
  options.max_solver_time_in_seconds = 1e9;
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

bool has_solver() { return true; }

double solve(PoseGraph& graph, const std::vector<double>& weights, int max_iterations) {
  const auto weight = [&](std::size_t edge) { return weights.empty() ? 1.0 : weights[edge]; };
  ceres::Problem::Options ownership;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  RigidMotion motion;
  ceres::Problem problem(ownership);
  std::vector<Parameters> parameters(graph.poses.size());
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    write_pose(graph.poses[i], parameters[i].data());
    problem.AddParameterBlock(parameters[i].data(), 7, &motion);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (weight(e) <= 0.0) continue;
    const PoseEdge& edge = graph.edges[e];
    problem.AddResidualBlock(new EdgeCost(edge, weight(e)), nullptr, parameters[edge.from].data(),
                             parameters[edge.to].data());
  }
  if (graph.poses.size() < 2 || problem.NumResidualBlocks() == 0) return 0.0;
  problem.SetParameterBlockConstant(parameters.front().data());
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(max_iterations), &problem, &summary);
  double sum = 0.0;
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    const Pose solved = pose_of(parameters[i].data());
    graph.poses[i] = {solved.rotation.normalized(), solved.translation};
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (weight(e) > 0.0) sum += weight(e) * chi2(graph.edges[e], graph.poses);
  }
  return sum;
}

}  // namespace surefoot::mapping
