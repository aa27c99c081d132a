// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/vertical.hpp"

#include <cmath>

#include "methods/paper/observability.hpp"

namespace surefoot {

namespace {

/// J^V S_V: the columns of z, roll and pitch, eqs. (25)-(26); so too of J^p.
template <int Rows>
Eigen::Matrix<double, Rows, 3> select_vertical(const Eigen::Matrix<double, Rows, 6>& J) {
  return J.template middleCols<3>(2);  // [Eq 25] and [Eq 26]
}

}  // namespace

bool valid_vertical(const Surface& surface, double distance,
                    const PaperParameters::Vertical& config) {
  return surface.neighbours >= config.min_neighbours &&
         std::abs(surface.normal.z()) >= config.min_normal_z && distance <= config.max_range;
}

VerticalEquations vertical_equations(Source& source, const LocalMap& map, const Pose& T_map_lidar,
                                     const PaperParameters::Vertical& config,
                                     const Workers& workers) {
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  const Eigen::Vector3d& sensor = T_map_lidar.translation;
  return workers.sum<VerticalEquations>(
      source.points.size(), [&](std::size_t begin, std::size_t end) {
        VerticalEquations sum;
        for (std::size_t i = begin; i < end; ++i) {
          const Match& match = source.matches[i];
          if (!match.found) continue;
          const auto [s, q] = about_sensor(R, sensor, source.points[i], match);
          const double d = s.norm();
          const Surface& surface = surface_at(map, s + sensor, source.surfaces[i]);
          if (!valid_vertical(surface, d, config)) continue;
          const Eigen::Vector3d& n = surface.normal;
          const double omega = observability(d, n, config);
          sum.observability += omega;
          if (config.residual == Residual::point_to_point) {
            const Eigen::Vector3d r = s - q;
            const double w = robust_term(d, r.norm(), config) * omega;
            sum.add<3>(select_vertical(point_jacobian(s)), r, w);
            continue;
          }
          const Eigen::Matrix<double, 1, 1> r(n.dot(s - q));        // [Eq 23]
          const double w = robust_term(d, r[0], config) * omega;    // [Eq 32]
          sum.add<1>(select_vertical(plane_jacobian(s, n)), r, w);  // [Eq 33]
        }
        return sum;
      });
}

Eigen::Vector3d limit_to_trust_region(const Eigen::Vector3d& delta_V, double trust_region) {
  const double norm = delta_V.norm();
  return norm <= trust_region ? delta_V : trust_region / norm * delta_V;  // [Eq 34]
}

Twist full_vertical_update(const Eigen::Vector3d& delta_V) {
  Twist delta;  // [Eq 27]
  delta << 0.0, 0.0, delta_V[0], delta_V[1], delta_V[2], 0.0;
  return delta;
}

}  // namespace surefoot
