// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/gaussian_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kLeastPoints = 4;
constexpr double kThin = 0.15;  // standard deviation across, in cubes' sides
constexpr double kCloudWeight = 0.1;
constexpr double kTilt = 0.02;  // submaps may lie askew by so much [rad]
constexpr double kNormalSigmas = 3.0;
constexpr double kLevelNormal = 0.85;  // z of a lying plane's normal

struct Moments {
  std::uint64_t key = 0;
  std::size_t count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d to_eyes = Eigen::Vector3d::Zero();
};

Gaussian fit(const Moments& moments, double size) {
  const double n = static_cast<double>(moments.count);
  Gaussian result;
  result.mean = moments.sum / n;
  result.facing = moments.to_eyes / n;
  const Eigen::Matrix3d covariance = moments.squares / n - result.mean * result.mean.transpose();
  const auto [values, axes] = symmetric_eigen_direct(covariance);
  const double thin = kThin * size * kThin * size;
  const double weight = values[0] < thin ? 1.0 : std::sqrt(kCloudWeight);
  for (int i = 0; i < 3; ++i) result.across[static_cast<std::size_t>(i)] = weight * axes.col(i);
  result.counted = values[0] >= thin ? 3 : values[1] < thin ? 2 : 1;
  // A floor is seen from a dog's height at a few degrees, some metres away: a constant that is safe
  // for a plane of four points would tell the sides of hardly any floor.
  result.grazing = kTilt + kNormalSigmas * std::sqrt(std::max(values[0], 0.0) / (n * values[1]));
  result.level = values[0] < thin && values[1] >= thin && std::abs(axes(2, 0)) > kLevelNormal;
  return result;
}

}  // namespace

GaussianGrid::GaussianGrid(const std::vector<Eigen::Vector3f>& points,
                           const std::vector<Eigen::Vector3f>& eyes, double size)
    : size_(size), inverse_size_(1.0 / size) {
  VoxelTable cubes;
  std::vector<Moments> moments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d at = points[i].cast<double>();
    const std::uint64_t key = voxel_key(voxel_index(at, inverse_size_));
    const auto [index, fresh] =
        cubes.find_or_insert(key, static_cast<std::uint32_t>(moments.size()));
    if (fresh) moments.push_back({.key = key});
    Moments& cube = moments[index];
    ++cube.count;
    cube.sum += at;
    cube.squares += at * at.transpose();
    cube.to_eyes += (eyes[i].cast<double>() - at).normalized();
  }
  for (const Moments& cube : moments) {
    if (cube.count < kLeastPoints) continue;
    table_.find_or_insert(cube.key, static_cast<std::uint32_t>(gaussians_.size()));
    gaussians_.push_back(fit(cube, size));
  }
}

const Gaussian* GaussianGrid::at(const VoxelIndex& index) const {
  const std::uint32_t found = table_.find(voxel_key(index));
  return found == VoxelTable::kNone ? nullptr : &gaussians_[found];
}

const Gaussian* GaussianGrid::inside(const Eigen::Vector3d& place) const {
  return at(voxel_index(place, inverse_size_));
}

const Gaussian* GaussianGrid::find(const Eigen::Vector3d& place) const {
  const VoxelIndex middle = voxel_index(place, inverse_size_);
  const Gaussian* nearest = at(middle);
  double nearest2 = nearest == nullptr ? 1e300 : (nearest->mean - place).squaredNorm();
  const Eigen::Vector3d within = place - size_ * middle.cast<double>();
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {1, -1}) {
      // A mean lies in its cube, no nearer than the face between.
      const double face = side > 0 ? size_ - within[axis] : within[axis];
      if (face * face >= nearest2) continue;
      VoxelIndex beside = middle;
      beside[axis] += side;
      const Gaussian* gaussian = at(beside);
      if (gaussian == nullptr) continue;
      const double distance2 = (gaussian->mean - place).squaredNorm();
      if (distance2 >= nearest2) continue;
      nearest = gaussian;
      nearest2 = distance2;
    }
  }
  return nearest;
}

}  // namespace surefoot::mapping
