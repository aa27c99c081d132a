// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "geometry/float_sums.hpp"

namespace surefoot {

namespace {

// A pole stands: its axis is within 45 deg of the map's z axis. A lying line is one ring of the
// LiDAR on a wall or floor, whose place along that surface says nothing.
constexpr double kStanding = 0.7;

// Variance of a pole's points across the rays at least, as a share of that along them.
constexpr double kWide = 0.25;

}  // namespace

Eigen::Matrix3d SurfelMoments::matrix_of(const Products& p) {
  return (Eigen::Matrix3d() << p.xx, p.xy, p.xz, p.xy, p.yy, p.yz, p.xz, p.yz, p.zz).finished();
}

/// What lies in the plane across the mean ray is told apart by how far the rays spread there: along
/// a ring as far as the voxel lets them, from ring to ring not at all, or by the gap.
SurfelMoments::RaySpread SurfelMoments::ray_spread(double size, double ring_gap) const {
  const Eigen::Vector3d mean = ray_sum_.cast<double>() / count_;
  RaySpread spread;
  spread.mean = mean.normalized();
  const Eigen::Vector3d u = spread.mean.unitOrthogonal(), v = spread.mean.cross(u);
  const Eigen::Matrix3d C = matrix_of(rays_) / count_ - mean * mean.transpose();
  const auto [values, axes] = symmetric_eigen_direct(u.dot(C * u), u.dot(C * v), v.dot(C * v));
  spread.across[1] = axes(0, 1) * u + axes(1, 1) * v;
  spread.across[0] = spread.mean.cross(spread.across[1]);
  const double mean_squared_range = static_cast<double>(squared_ranges_) / count_;
  const double reach = std::min(ring_gap, size / std::sqrt(mean_squared_range));
  const double evenly = std::max(reach * reach / 12.0, 1e-12);
  for (int i = 0; i < 2; ++i) spread.left_out[i] = std::clamp(1.0 - values[i] / evenly, 0.0, 1.0);
  return spread;
}

/// What the rings leave unseen between them [m^2].
Eigen::Matrix3d SurfelMoments::unseen(const RaySpread& rays, double next_ring) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 2; ++i) {
    sum += rays.left_out[i] * next_ring * rays.across[i] * rays.across[i].transpose();
  }
  return sum;  // [K24]
}

/// What a cloud's residuals are worth, other than that they are small. Of a surface that only one
/// ring met, nobody knows where along the rays the next one would: on a floor, metres farther on.
/// And points that fill a voxel from end to end have no place in it, wherever the sensor goes.
void SurfelMoments::weigh(Surfel& cloud, const RaySpread& rays, double next_ring, double size,
                          const Config::Knots& config) {
  const double slope = 1.0 / std::max(config.edge_on, Surfel::kGrazing);
  const double along = rays.left_out[0] * next_ring * slope * slope;
  const double filled = size * size / 12.0;  // variance of what is spread evenly
  for (Surfel::Direction& direction : cloud.along) {
    const double claimed = static_cast<double>(direction.variance) + config.noise * config.noise;
    const double cosine = direction.across.cast<double>().dot(rays.mean);
    const double known = claimed + along * cosine * cosine;
    direction.worth =
        static_cast<float>(claimed / known * std::max(1.0 - known / filled, 0.0));  // [K31]
  }
}

/// Whether points about an axis spread across the rays as a pole's do. One firing on a wall, seen
/// at a grazing angle, is an upright line as well, noisy along the rays and as thin as its beams.
bool SurfelMoments::is_wide(const Eigen::Matrix3d& C, const Eigen::Vector3d& axis) const {
  const Eigen::Vector3d aside = axis.cross(ray_sum_.cast<double>()).normalized();
  const Eigen::Vector3d onward = aside.cross(axis);
  return aside.dot(C * aside) >= kWide * onward.dot(C * onward);  // [K41]
}

Surfel SurfelMoments::fit(const Eigen::Vector3d& middle, double size, const Config::Knots& config,
                          Poles poles) const {
  Surfel surfel;
  const Eigen::Vector3d offset = mean();
  const Eigen::Matrix3d C = matrix_of(products_) / count_ - offset * offset.transpose();
  surfel.mean = middle + offset;
  surfel.extent = static_cast<float>(C.trace());
  if (count_ < config.min_points) return surfel;
  SymmetricEigen<3> eigen = symmetric_eigen_direct(C);
  const Eigen::Vector3d spread = eigen.values.cwiseMax(0.0);
  const double broad = config.breadth * config.breadth * size * size;
  // A ring that passes through foliage, or whose ranges are noisy, spreads along its rays: its
  // points lie on the plane that the rays sweep, which goes with the sensor.
  const Eigen::Vector3d normal = eigen.vectors.col(0);
  const double facing = normal.dot(matrix_of(rays_) * normal) / count_;  // [K18]
  // [K17]
  const bool plane = spread[1] >= broad && spread[0] <= config.flatness * spread[1] &&
                     facing >= config.edge_on * config.edge_on;
  const bool pole = poles == Poles::some && !plane && count_ >= 2 * config.min_points &&
                    spread[2] >= broad && spread[1] <= config.slenderness * spread[2] &&
                    std::abs(eigen.vectors(2, 2)) >= kStanding && is_wide(C, eigen.vectors.col(2));
  surfel.directions = plane ? 1 : pole ? 2 : config.cloud_weight > 0.0 ? 3 : 0;
  const RaySpread rays = surfel.cloud() ? ray_spread(size, config.ring_gap) : RaySpread{};
  const double next_ring = config.ring_gap * config.ring_gap * squared_ranges_ / (3.0 * count_);
  if (surfel.cloud()) eigen = symmetric_eigen_direct(C + unseen(rays, next_ring));
  for (int i = 0; i < std::max(surfel.directions, 2); ++i) {
    surfel.along[i].across = eigen.vectors.col(i).cast<float>();
    surfel.along[i].variance = static_cast<float>(std::max(eigen.values[i], 0.0));
  }
  if (surfel.cloud()) weigh(surfel, rays, next_ring, size, config);
  if (dot(surfel.along[0].across, ray_sum_) > 0.0F) surfel.along[0].across *= -1.0F;
  return surfel;
}

}  // namespace surefoot
