// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/assessment.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "core/information.hpp"
#include "geometry/triangular_solves.hpp"
#include "methods/paper/robust_weight.hpp"

namespace surefoot {

namespace {

// Directions around the LiDAR, measured one after the other: points of one sector share the error
// of one instant's deskewing.
constexpr int kSectors = 16;

int sector_of(const Eigen::Vector3f& point) {
  const double turn = std::atan2(static_cast<double>(point.y()), static_cast<double>(point.x())) /
                          (2.0 * std::numbers::pi) +
                      0.5;
  return std::min(static_cast<int>(turn * kSectors), kSectors - 1);
}

struct PlaneSum {
  NormalEquations<6> equations;
  Eigen::Matrix<double, 6, kSectors> sector_g = Eigen::Matrix<double, 6, kSectors>::Zero();
  double squared_distance = 0.0;  // weighted sum of |s|^2
  PlaneSum& operator+=(const PlaneSum& other) {
    equations += other.equations;
    sector_g += other.sector_g;
    squared_distance += other.squared_distance;
    return *this;
  }
};

PlaneSum sum_planes(Source& source, const LocalMap& map, const Pose& T_map_lidar,
                    const PaperParameters::Vertical& config, const Workers& workers) {
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  const Eigen::Vector3d& sensor = T_map_lidar.translation;
  return workers.sum<PlaneSum>(source.points.size(), [&](std::size_t begin, std::size_t end) {
    PlaneSum sum;
    for (std::size_t i = begin; i < end; ++i) {
      const Match& match = source.matches[i];
      if (!match.found) continue;
      const auto [s, q] = about_sensor(R, sensor, source.points[i], match);
      const Surface& surface = surface_at(map, s + sensor, source.surfaces[i]);
      if (surface.neighbours < config.min_neighbours) continue;
      const Eigen::Matrix<double, 1, 1> r(surface.normal.dot(s - q));
      const double w = surface.planarity * lorentzian_weight(std::abs(r[0]), config.kernel_scale);
      const Eigen::Matrix<double, 1, 6> J = plane_jacobian(s, surface.normal);
      sum.equations.add<1>(J, r, w);
      sum.sector_g.col(sector_of(source.points[i])) += w * r[0] * J.transpose();
      sum.squared_distance += w * s.squaredNorm();
    }
    return sum;
  });
}

/// Covariance of the pose, from normal equations and residuals. Residuals are not independent: a
/// wrong deskewing turns or shifts a whole sector of the scan. So to the usual s^2 H^-1 come
/// - the sectors' gradients, each as one observation (the cluster-robust "sandwich"), and
/// - how far these equations would still move the pose, since the stages, which minimise other
///   residuals too, ended elsewhere.
/// The prior that a pose stays within what a registration may correct keeps all of it finite where
/// no surface speaks.
Matrix6 pose_covariance(const PlaneSum& sum, const Config::Health& config) {
  const double variance = std::max(sum.equations.rms() * sum.equations.rms(), 1e-8);
  const Matrix6 prior = unregistered_covariance(config).inverse();
  const Matrix6 independent = inverse(Eigen::LLT<Matrix6>(sum.equations.H / variance + prior));
  const Eigen::Matrix<double, 6, kSectors> sectors = independent * sum.sector_g / variance;
  const Twist disagreement = sectors.rowwise().sum();
  return independent + Matrix6(sectors.lazyProduct(sectors.transpose())) +
         disagreement * disagreement.transpose();
}

}  // namespace

void assess(Source& source, const LocalMap& map, const Pose& T_map_lidar,
            const PaperParameters::Vertical& config, const Config::Health& health,
            const Workers& workers, Estimate& estimate) {
  const PlaneSum sum = sum_planes(source, map, T_map_lidar, config, workers);
  estimate.covariance = pose_covariance(sum, health);
  report_weak_directions(sum.equations, sum.squared_distance, T_map_lidar, health, estimate);
}

}  // namespace surefoot
