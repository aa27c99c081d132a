// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "surefoot/config.hpp"

namespace surefoot {

/// What a voxel's points lie on: a plane (one direction across it), a pole (two), or neither: a
/// cloud (three) of leaves, grass or stones. Begins a cache line, which holds what is asked first.
struct alignas(64) Surfel {
  int directions = 0;                              ///< 0: too few points
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< map frame [m]
  double extent = 0.0;                             ///< variance of the points, all ways [m^2]
  Eigen::Vector3d across[3] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                               Eigen::Vector3d::Zero()};  ///< unit; a plane's: to who sees it
  double variance[3] = {0.0, 0.0, 0.0};  ///< along them [m^2]: the points', a cloud's widened
  double worth[3] = {1.0, 1.0, 1.0};     ///< share of what residuals along them claim to tell

  [[nodiscard]] bool cloud() const { return directions == 3; }

  /// Whether a ray (of any length, from the sensor) meets a plane's back.
  [[nodiscard]] bool from_behind(const Eigen::Vector3d& ray) const {
    if (directions != 1) return false;
    const double along = across[0].dot(ray);
    return along > 0.0 && along * along > kGrazing * kGrazing * ray.squaredNorm();
  }

  /// Who sees a plane at a smaller angle than this (sine) may be on either side of it.
  static constexpr double kGrazing = 0.05;
};

/// Sums over a voxel's points, and over the rays that measured them.
class SurfelMoments {
 public:
  /// `point`: from the voxel's corner [m]; `ray`: unit vector from the sensor, `range` [m] away.
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& ray, double range) {
    ++count_;
    sum_ += point;
    add_products(point, products_);
    ray_sum_ += ray;
    add_products(ray, rays_);
    squared_ranges_ += range * range;
  }

  [[nodiscard]] int count() const { return count_; }
  /// Of at least one point, from the voxel's corner [m].
  [[nodiscard]] Eigen::Vector3d mean() const { return sum_ / count_; }
  /// `corner` [m, map frame] of a voxel of side `size` [m].
  [[nodiscard]] Surfel fit(const Eigen::Vector3d& corner, double size,
                           const Config::Knots& config) const;

 private:
  /// The upper triangle of a sum of v v^T, row by row.
  using Products = Eigen::Matrix<double, 6, 1>;

  /// One by one: put together first, they would go through memory.
  static void add_products(const Eigen::Vector3d& v, Products& sum) {
    sum[0] += v.x() * v.x();
    sum[1] += v.x() * v.y();
    sum[2] += v.x() * v.z();
    sum[3] += v.y() * v.y();
    sum[4] += v.y() * v.z();
    sum[5] += v.z() * v.z();
  }
  [[nodiscard]] static Eigen::Matrix3d matrix_of(const Products& p);
  /// What the rings leave unseen between them, as a covariance [m^2].
  [[nodiscard]] Eigen::Matrix3d unseen(double ring_gap) const;
  /// 1 if one ring saw the points, 0 if rings did all over the gap between two.
  [[nodiscard]] double of_one_ring(double ring_gap) const;
  void weigh(Surfel& cloud, double size, const Config::Knots& config) const;

  // In an order that leaves no gaps: Eigen aligns the products.
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  double squared_ranges_ = 0.0;
  Products products_ = Products::Zero();
  Products rays_ = Products::Zero();
  Eigen::Vector3d ray_sum_ = Eigen::Vector3d::Zero();
  int count_ = 0;
};

}  // namespace surefoot
