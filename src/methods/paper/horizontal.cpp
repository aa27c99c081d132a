// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/horizontal.hpp"

#include "methods/paper/robust_weight.hpp"

namespace surefoot {

namespace {

/// J^p S_H: the columns of x, y and yaw, eqs. (15)-(16).
Eigen::Matrix3d select_horizontal(const Eigen::Matrix<double, 3, 6>& J) {
  Eigen::Matrix3d selected;  // [Eq 15] and [Eq 16]
  selected << J.col(0), J.col(1), J.col(5);
  return selected;
}

}  // namespace

NormalEquations<3> horizontal_equations(const Source& source, const Pose& T_map_lidar,
                                        const PaperParameters::Horizontal& config,
                                        const Workers& workers) {
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  return workers.sum<NormalEquations<3>>(
      source.points.size(), [&](std::size_t begin, std::size_t end) {
        NormalEquations<3> sum;
        for (std::size_t i = begin; i < end; ++i) {
          const Match& match = source.matches[i];
          if (!match.found) continue;
          const auto [s, q] = about_sensor(R, T_map_lidar.translation, source.points[i], match);
          const Eigen::Vector3d r = s - q;  // [Eq 13]
          const Eigen::Matrix3d J = select_horizontal(point_jacobian(s));
          sum.add<3>(J, r, lorentzian_weight(r.norm(), config.kernel_scale));  // [Eq 18]
        }
        return sum;
      });
}

Twist full_horizontal_update(const Eigen::Vector3d& delta_H) {
  Twist delta;  // [Eq 17]
  delta << delta_H[0], delta_H[1], 0.0, 0.0, 0.0, delta_H[2];
  return delta;
}

}  // namespace surefoot
