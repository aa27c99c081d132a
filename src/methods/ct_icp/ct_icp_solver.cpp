// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_solver.hpp"

#include <cmath>

#include "geometry/so3.hpp"
#include "methods/shared/levenberg_marquardt.hpp"

namespace surefoot {

namespace {

constexpr double kNoRotation = 1e-9;  // [rad] 0.1 um at 100 m

/// Ceres' Cauchy loss rho(r^2) and its derivative.
struct Loss {
  double value, slope;
};
Loss cauchy(double squared, double sigma) {
  const double sum = 1.0 + squared / (sigma * sigma);
  return {sigma * sigma * std::log(sum), 1.0 / sum};
}

Linearisation<12> linearise(const std::vector<CtIcpResidual>& residuals, const CtIcpFrame& frame,
                            double sigma, const Workers& workers) {
  const CtIcpMotion motion(frame);
  return workers.sum<Linearisation<12>>(residuals.size(), [&](std::size_t begin, std::size_t end) {
    Linearisation<12> sum;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Matrix<double, 1, 1> r(ct_icp_residual(residuals[i], motion));
      const Loss loss = cauchy(r.squaredNorm(), sigma);
      sum.equations.add<1>(ct_icp_jacobian(residuals[i], motion), r, loss.slope);
      sum.cost += 0.5 * loss.value;
    }
    return sum;
  });
}

/// Norm of the fourteen parameters: two unit quaternions and two translations.
double parameter_norm(const CtIcpFrame& frame) {
  return std::sqrt(2.0 + frame.begin.translation.squaredNorm() +
                   frame.end.translation.squaredNorm());
}

}  // namespace

CtIcpFrame moved(const CtIcpFrame& frame, const CtIcpStep& step) {
  const auto moved_pose = [](const Pose& pose, const Twist& change) {
    return Pose{(so3_exp(change.tail<3>()) * pose.rotation).normalized(),
                pose.translation + change.head<3>()};
  };
  return {moved_pose(frame.begin, step.head<6>()), moved_pose(frame.end, step.tail<6>())};
}

CtIcpMotion::CtIcpMotion(const CtIcpFrame& frame)
    : frame_(frame), R_begin_(frame.begin.rotation.toRotationMatrix()) {
  const Eigen::Vector3d turn =
      R_begin_ * so3_log(frame.begin.rotation.conjugate() * frame.end.rotation);
  angle_ = turn.norm();
  axis_ = angle_ < kNoRotation ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(turn / angle_);
  left_inverse_ = so3_left_jacobian_inverse(turn);
  left_inverse_back_ = so3_left_jacobian_inverse(-turn);
}

Eigen::Vector3d CtIcpMotion::rotate(double alpha, const Eigen::Vector3d& point) const {
  const Eigen::Vector3d begun = R_begin_ * point;
  const Eigen::Vector3d turned = axis_.cross(begun);  // Rodrigues' formula
  return begun + std::sin(alpha * angle_) * turned +
         (1.0 - std::cos(alpha * angle_)) * axis_.cross(turned);
}

Eigen::Vector3d CtIcpMotion::translation(double alpha) const {
  return (1.0 - alpha) * frame_.begin.translation + alpha * frame_.end.translation;
}

Pose CtIcpMotion::at(double alpha) const {
  return {(so3_exp(alpha * angle_ * axis_) * frame_.begin.rotation).normalized(),
          translation(alpha)};
}

/// With phi the rotation from first to last pose, both their changes d_begin, d_end turn the pose
/// at alpha by A J_l^-1(phi) d_end + (exp(alpha phi) - A J_l^-1(-phi)) d_begin, where
/// A = alpha J_l(alpha phi).
Eigen::Matrix<double, 1, 12> CtIcpMotion::derivative(double alpha, const Eigen::Vector3d& point,
                                                     const Eigen::Vector3d& normal) const {
  const Eigen::Vector3d lever = rotate(alpha, point).cross(normal);
  Eigen::Matrix<double, 1, 12> row;
  if (alpha == 1.0) {  // exactly: a rigid scan's first pose must not be moved by rounding errors
    row << Eigen::Matrix<double, 1, 6>::Zero(), normal.transpose(), lever.transpose();
    return row;
  }
  const double sine = std::sin(alpha * angle_);
  const double versine = 1.0 - std::cos(alpha * angle_);
  const Eigen::Vector3d turned = axis_.cross(lever);
  const Eigen::Vector3d turned_back = lever - sine * turned + versine * axis_.cross(turned);
  Eigen::Vector3d A_lever = alpha * lever;  // A^T lever
  if (angle_ >= kNoRotation) {
    A_lever = sine / angle_ * lever + (alpha - sine / angle_) * axis_.dot(lever) * axis_ -
              versine / angle_ * turned;
  }
  row << (1.0 - alpha) * normal.transpose(), (turned_back - left_inverse_ * A_lever).transpose(),
      alpha * normal.transpose(), (left_inverse_back_ * A_lever).transpose();
  return row;
}

double ct_icp_residual(const CtIcpResidual& residual, const CtIcpMotion& motion) {
  const Eigen::Vector3d placed = motion.place(residual.alpha, residual.point);
  return residual.weight * residual.normal.dot(residual.anchor - placed);
}

Eigen::Matrix<double, 1, 12> ct_icp_jacobian(const CtIcpResidual& residual,
                                             const CtIcpMotion& motion) {
  return -residual.weight * motion.derivative(residual.alpha, residual.point, residual.normal);
}

NormalEquations<12> ct_icp_constraints(const CtIcpFrame& frame, const CtIcpFrame& previous,
                                       int residuals, const CtIcpParameters& config) {
  using Rows = Eigen::Matrix<double, 3, 12>;
  const auto share = [&](double beta) { return residuals * beta; };
  NormalEquations<12> sum;
  Rows begin = Rows::Zero();  // d begin.translation
  begin.leftCols<3>().setIdentity();
  Rows way = -begin;  // d (end.translation - begin.translation)
  way.middleCols<3>(6).setIdentity();
  const Eigen::Vector3d velocity = frame.end.translation - frame.begin.translation;
  const Eigen::Vector3d last_velocity = previous.end.translation - previous.begin.translation;

  sum.add<3>(begin, frame.begin.translation - previous.end.translation,
             share(config.beta_location_consistency));
  sum.add<3>(way, velocity - last_velocity, share(config.beta_constant_velocity));
  sum.add<3>(way, velocity, share(config.beta_small_velocity));

  // 1 - (q . p)^2 = sin^2 of half the angle between.
  const Eigen::Quaterniond apart = previous.end.rotation * frame.begin.rotation.conjugate();
  Eigen::Matrix<double, 1, 12> turn = Eigen::Matrix<double, 1, 12>::Zero();
  turn.middleCols<3>(3) = -apart.w() * apart.vec().transpose();
  sum.add<1>(turn, Eigen::Matrix<double, 1, 1>(apart.vec().squaredNorm()),
             share(config.beta_orientation_consistency));
  return sum;
}

CtIcpFrame solve_ct_icp(const std::vector<CtIcpResidual>& residuals, const CtIcpFrame& start,
                        const CtIcpFrame& previous, const CtIcpParameters& config,
                        const Workers& workers) {
  const auto linearise_all = [&](const CtIcpFrame& frame) {
    Linearisation<12> sum = linearise(residuals, frame, config.ls_sigma, workers);
    const NormalEquations<12> constraints =
        ct_icp_constraints(frame, previous, static_cast<int>(residuals.size()), config);
    sum.equations += constraints;
    sum.cost += 0.5 * constraints.weighted_squares;
    return sum;
  };
  return minimise<12>(start, config.ls_max_num_iters, linearise_all, moved, parameter_norm).state;
}

NormalEquations<6> rigid_equations(const std::vector<CtIcpResidual>& residuals,
                                   const CtIcpFrame& frame, const CtIcpParameters& config,
                                   const Workers& workers) {
  const NormalEquations<12> both = linearise(residuals, frame, config.ls_sigma, workers).equations;
  // The twist's effect on the two poses: a translation also by turning about the far origin.
  Eigen::Matrix<double, 12, 6> B;
  B << Matrix6::Identity(), Matrix6::Identity();
  B.block<3, 3>(0, 3) = -hat(frame.begin.translation);
  B.block<3, 3>(6, 3) = -hat(frame.end.translation);
  NormalEquations<6> rigid;
  rigid.H = B.transpose() * both.H * B;
  rigid.g = B.transpose() * both.g;
  rigid.weight = both.weight;
  rigid.weighted_squares = both.weighted_squares;
  rigid.count = both.count;
  return rigid;
}

}  // namespace surefoot
