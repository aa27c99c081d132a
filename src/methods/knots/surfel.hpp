// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "surefoot/config.hpp"

namespace surefoot {

/// What a voxel's points lie on: a plane (one direction across it), a pole (two), or neither: a
/// cloud (three) of leaves, grass or stones. Begins a cache line, which holds all that is asked of
/// a plane; for that, what is small is in single precision.
struct alignas(64) Surfel {
  struct Direction {
    Eigen::Vector3f across = Eigen::Vector3f::Zero();  ///< unit; a plane's: to who sees it
    float variance = 0.0F;  ///< along it [m^2]: the points', a cloud's widened
    float worth = 1.0F;     ///< share of what residuals along it claim to tell
  };

  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< map frame [m]
  int directions = 0;                              ///< 0: too few points
  float extent = 0.0F;                             ///< variance of the points, all ways [m^2]
  Direction along[3];

  [[nodiscard]] Eigen::Vector3d across(int i) const { return along[i].across.cast<double>(); }
  [[nodiscard]] double variance(int i) const { return static_cast<double>(along[i].variance); }
  [[nodiscard]] double worth(int i) const { return static_cast<double>(along[i].worth); }

  [[nodiscard]] bool pole() const { return directions == 2; }
  [[nodiscard]] bool cloud() const { return directions == 3; }
  /// Unit, of a pole.
  [[nodiscard]] Eigen::Vector3d axis() const { return across(0).cross(across(1)); }

  /// Whether a ray (of any length, from the sensor) meets a plane's back.
  [[nodiscard]] bool from_behind(const Eigen::Vector3d& ray) const {
    if (directions != 1) return false;
    const double onward = across(0).dot(ray);
    return onward > 0.0 && onward * onward > kGrazing * kGrazing * ray.squaredNorm();
  }

  /// Who sees a plane at a smaller angle than this (sine) may be on either side of it.
  static constexpr double kGrazing = 0.05;
};

/// Sums over a voxel's points, and over the rays that measured them. In single precision, which
/// rounds by micrometres where the LiDAR errs by millimetres: each point lies within the voxel.
class SurfelMoments {
 public:
  /// `point`: from the voxel's middle [m]; `ray`: unit vector from the sensor, `range` [m] away.
  void add(const Eigen::Vector3f& point, const Eigen::Vector3f& ray, float range) {
    ++count_;
    sum_ += point;
    add_products(point, products_);
    ray_sum_ += ray;
    add_products(ray, rays_);
    squared_ranges_ += range * range;
  }

  [[nodiscard]] int count() const { return count_; }
  /// Of at least one point, from the voxel's middle [m].
  [[nodiscard]] Eigen::Vector3d mean() const { return sum_.cast<double>() / count_; }
  /// Whether what looks like a pole may be one.
  enum class Poles { some, none };
  /// `middle` [m, map frame] of a voxel of side `size` [m].
  [[nodiscard]] Surfel fit(const Eigen::Vector3d& middle, double size, const Config::Knots& config,
                           Poles poles = Poles::some) const;

 private:
  /// The upper triangle of a sum of v v^T, row by row.
  struct Products {
    float xx = 0.0F, xy = 0.0F, xz = 0.0F, yy = 0.0F, yz = 0.0F, zz = 0.0F;
  };

  static void add_products(const Eigen::Vector3f& v, Products& sum) {
    sum.xx += v.x() * v.x();
    sum.xy += v.x() * v.y();
    sum.xz += v.x() * v.z();
    sum.yy += v.y() * v.y();
    sum.yz += v.y() * v.z();
    sum.zz += v.z() * v.z();
  }
  [[nodiscard]] static Eigen::Matrix3d matrix_of(const Products& p);
  [[nodiscard]] bool is_wide(const Eigen::Matrix3d& C, const Eigen::Vector3d& axis) const;
  /// How the rays lie about their mean.
  struct RaySpread {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< unit
    Eigen::Vector3d across[2];                       ///< unit; they spread the less along the first
    /// Of each: 0 if they are spread over all that a voxel, or the gap of two rings, has room for;
    /// 1 if they are not spread at all.
    double left_out[2] = {0.0, 0.0};
  };
  [[nodiscard]] RaySpread ray_spread(double size, double ring_gap) const;
  /// `next_ring`: variance of what may lie up to the next ring, on either side [m^2].
  [[nodiscard]] static Eigen::Matrix3d unseen(const RaySpread& rays, double next_ring);
  static void weigh(Surfel& cloud, const RaySpread& rays, double next_ring, double size,
                    const Config::Knots& config);

  int count_ = 0;
  Eigen::Vector3f sum_ = Eigen::Vector3f::Zero();
  Products products_;
  Eigen::Vector3f ray_sum_ = Eigen::Vector3f::Zero();
  Products rays_;
  float squared_ranges_ = 0.0F;
};

}  // namespace surefoot
