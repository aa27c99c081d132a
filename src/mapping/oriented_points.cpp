// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/oriented_points.hpp"

#include <cmath>

#include "geometry/decompositions.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kLeastNear = 6;
constexpr int kFits = 4;
constexpr double kThickness = 0.15;    // what lies farther from a plane does not lie on it [m]
constexpr double kLeastSupport = 0.3;  // three planes meet in a corner: each has a third
constexpr double kLeastExtent = 0.2;   // standard deviation along, in radii: a pole has less across
constexpr double kGrazing = 0.03;      // cosine; seen more flatly, the side is not told

/// Which of the eight: directions that differ more belong to two sides of a thing, or to two walls.
std::uint64_t octant_of(const Eigen::Vector3d& direction) {
  return (direction.x() > 0.0 ? 1U : 0U) | (direction.y() > 0.0 ? 2U : 0U) |
         (direction.z() > 0.0 ? 4U : 0U);
}

/// Tukey's biweight: 1 at 0, and none from `reach` on.
double biweight(double distance2, double reach) {
  const double left = 1.0 - distance2 / (reach * reach);
  return left > 0.0 ? left * left : 0.0;
}

}  // namespace

PointOrientation::PointOrientation(double cube, double radius) : cube_(cube), radius_(radius) {}

void PointOrientation::add(const Eigen::Vector3d& place, const Eigen::Vector3d& eye) {
  const Eigen::Vector3d to_eye = (eye - place).normalized();
  // Twice as many cubes along each axis have room for eight sides.
  VoxelIndex index = 2 * voxel_index(place, 1.0 / cube_);
  const std::uint64_t octant = octant_of(to_eye);
  for (int axis = 0; axis < 3; ++axis) index[axis] += octant >> axis & 1U ? 1 : 0;
  const auto next = static_cast<std::uint32_t>(seen_.size());
  const auto [found, fresh] = cubes_.find_or_insert(voxel_key(index), next);
  if (fresh) seen_.emplace_back();
  seen_[found].place += place;
  seen_[found].to_eye += to_eye;
  ++seen_[found].count;
}

void PointOrientation::gather(const Seen& point) {
  near_.clear();
  const VoxelIndex middle = voxel_index(point.place, 1.0 / radius_);
  for (int k = 0; k < 27; ++k) {
    const VoxelIndex offset(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1);
    const std::uint32_t bucket = buckets_.find(voxel_key(middle + offset));
    if (bucket == VoxelTable::kNone) continue;
    for (const std::uint32_t i : in_bucket_[bucket]) {
      const Eigen::Vector3d from_point = seen_[i].place - point.place;
      const double weight = biweight(from_point.squaredNorm(), radius_);
      if (weight > 0.0) near_.push_back({from_point, seen_[i].to_eye, weight});
    }
  }
}

/// Of what lies near, weighted by how near it is, and how near to the plane that was found before,
/// on the side of the point: an edge is not rounded, and a wall's other face does not count.
PointOrientation::Plane PointOrientation::fit(const Eigen::Vector3d& to_eye,
                                              const Plane& before) const {
  const double side = before.normal.dot(to_eye);  // 0 at first
  double all = 0.0;
  double sum = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Near& near : near_) {
    if (side * before.normal.dot(near.to_eye) < 0.0) continue;
    const double off = before.normal.dot(near.from_point - before.mean);
    const double weight = near.weight * biweight(off * off, kThickness);
    all += near.weight;
    sum += weight;
    mean += weight * near.from_point;
    squares += weight * near.from_point * near.from_point.transpose();
  }
  Plane plane;
  if (sum <= 0.0) return plane;
  plane.mean = mean / sum;
  const auto [values, axes] =
      symmetric_eigen_direct(squares / sum - plane.mean * plane.mean.transpose());
  plane.normal = axes.col(0);
  plane.support = sum / all;
  plane.extended = values[1] > kLeastExtent * radius_ * kLeastExtent * radius_;
  return plane;
}

PointOrientation::Plane PointOrientation::surface_at(const Seen& point) {
  gather(point);
  Plane plane;
  if (near_.size() < kLeastNear) return plane;
  for (int k = 0; k < kFits; ++k) {
    plane = fit(point.to_eye, plane);
    // Through the point at first: it is asked what it lies on, not what is most about it.
    if (k == 0) plane.mean.setZero();
  }
  return plane;
}

std::vector<OrientedPoint> PointOrientation::oriented() {
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    Seen& point = seen_[i];
    point.place /= static_cast<double>(point.count);
    point.to_eye /= static_cast<double>(point.count);
    const auto next = static_cast<std::uint32_t>(in_bucket_.size());
    const std::uint64_t key = voxel_key(voxel_index(point.place, 1.0 / radius_));
    const auto [bucket, fresh] = buckets_.find_or_insert(key, next);
    if (fresh) in_bucket_.emplace_back();
    in_bucket_[bucket].push_back(i);
  }
  std::vector<OrientedPoint> result;
  for (const Seen& point : seen_) {
    const Plane plane = surface_at(point);
    const double side = plane.normal.dot(point.to_eye);
    if (!plane.extended || plane.support < kLeastSupport || std::abs(side) < kGrazing) continue;
    const Eigen::Vector3d onto = point.place + plane.normal.dot(plane.mean) * plane.normal;
    result.push_back({onto, side > 0.0 ? plane.normal : Eigen::Vector3d(-plane.normal)});
  }
  return result;
}

}  // namespace surefoot::mapping
