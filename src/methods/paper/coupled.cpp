// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/coupled.hpp"

#include <cmath>

#include "methods/paper/robust_weight.hpp"

namespace surefoot {

NormalEquations<6> coupled_equations(Source& source, const LocalMap& map, const Pose& T_map_lidar,
                                     const PaperParameters& config, const Workers& workers) {
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  const Eigen::Vector3d& sensor = T_map_lidar.translation;
  const bool planes = config.registration.coupled_residual == Residual::point_to_plane;
  const double kappa = config.horizontal.kernel_scale;
  return workers.sum<NormalEquations<6>>(source.points.size(), [&](std::size_t begin,
                                                                   std::size_t end) {
    NormalEquations<6> sum;  // [Eq 4]
    for (std::size_t i = begin; i < end; ++i) {
      const Match& match = source.matches[i];
      if (!match.found) continue;
      const auto [s, q] = about_sensor(R, sensor, source.points[i], match);
      if (!planes) {
        const Eigen::Vector3d r = s - q;
        sum.add<3>(point_jacobian(s), r, lorentzian_weight(r.norm(), kappa));
        continue;
      }
      const Surface& surface = surface_at(map, s + sensor, source.surfaces[i]);
      if (surface.neighbours < config.vertical.min_neighbours) continue;
      const Eigen::Matrix<double, 1, 1> r(surface.normal.dot(s - q));
      sum.add<1>(plane_jacobian(s, surface.normal), r, lorentzian_weight(std::abs(r[0]), kappa));
    }
    return sum;
  });
}

}  // namespace surefoot
