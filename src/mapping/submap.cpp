// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/submap.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::mapping {

namespace {

/// The ground about the middle: a low quantile, since a few points lie below it.
double ground_height(const std::vector<Eigen::Vector3f>& points) {
  constexpr float kAbout = 6.0F;  // [m]
  std::vector<float> heights;
  for (const Eigen::Vector3f& point : points) {
    if (point.head<2>().squaredNorm() < kAbout * kAbout && point.z() < 1.0F) {
      heights.push_back(point.z());
    }
  }
  return quantile(std::move(heights), 0.1);
}

/// Heights of the lowest points about the middle, one a square of a metre.
std::vector<Eigen::Vector3d> lowest_points(const std::vector<Eigen::Vector3f>& points) {
  constexpr int kHalf = 8;  // squares each way
  constexpr std::size_t kSquares = 4 * kHalf * kHalf;
  std::array<const Eigen::Vector3f*, kSquares> lowest{};
  for (const Eigen::Vector3f& point : points) {
    const auto x = static_cast<int>(std::floor(point.x())) + kHalf;
    const auto y = static_cast<int>(std::floor(point.y())) + kHalf;
    if (x < 0 || y < 0 || x >= 2 * kHalf || y >= 2 * kHalf) continue;
    const Eigen::Vector3f*& known = lowest[static_cast<std::size_t>(x * 2 * kHalf + y)];
    if (known == nullptr || point.z() < known->z()) known = &point;
  }
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector3f* point : lowest) {
    if (point != nullptr) result.push_back(point->cast<double>());
  }
  return result;
}

/// The turn that makes the ground about the middle level; none where most of it lies in no plane.
Eigen::Quaterniond levelled_ground(const std::vector<Eigen::Vector3f>& points, double ground) {
  constexpr std::size_t kLeast = 30;
  constexpr double kWide = 1.5, kNarrow = 0.25;  // [m] of what counts, at first and at last
  constexpr double kShare = 0.5;
  constexpr double kSteepest = 0.6;  // [rad]
  const std::vector<Eigen::Vector3d> low = lowest_points(points);
  if (low.size() < kLeast) return Eigen::Quaterniond::Identity();
  Eigen::Vector3d plane(0.0, 0.0, ground);  // z = plane . (x, y, 1)
  double counted = 0.0;
  for (double kernel = kWide; kernel > 0.5 * kNarrow; kernel *= 0.75) {
    Eigen::Matrix3d H = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    counted = 0.0;
    for (const Eigen::Vector3d& point : low) {
      const Eigen::Vector3d row(point.x(), point.y(), 1.0);
      const double off = (point.z() - plane.dot(row)) / kernel;
      const double weight = 1.0 / ((1.0 + off * off) * (1.0 + off * off));
      H += weight * row * row.transpose();
      b += weight * point.z() * row;
      counted += std::abs(off) < 1.0 ? 1.0 : 0.0;
    }
    plane = H.ldlt().solve(b);
  }
  const Eigen::Vector3d normal = Eigen::Vector3d(-plane.x(), -plane.y(), 1.0).normalized();
  if (counted < kShare * static_cast<double>(low.size()) || normal.z() < std::cos(kSteepest)) {
    return Eigen::Quaterniond::Identity();
  }
  return Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
}

std::vector<Eigen::Vector3f> rotated(const std::vector<Eigen::Vector3f>& points,
                                     const Eigen::Quaterniond& by) {
  const Eigen::Matrix3f R = by.toRotationMatrix().cast<float>();
  std::vector<Eigen::Vector3f> result;
  result.reserve(points.size());
  for (const Eigen::Vector3f& point : points) result.emplace_back(R * point);
  return result;
}

/// Whether there is something above most of the ground about the middle, at a ceiling's height.
bool has_ceiling(const std::vector<Eigen::Vector3f>& points, double ground) {
  constexpr int kHalf = 6;  // columns of 1 m each way
  constexpr double kLow = 1.9;
  constexpr double kHigh = 8.0;
  constexpr double kShare = 0.4;
  std::array<std::uint8_t, 4 * kHalf * kHalf> columns{};  // bit 0: ground, bit 1: ceiling
  for (const Eigen::Vector3f& point : points) {
    const auto x = static_cast<int>(std::floor(point.x())) + kHalf;
    const auto y = static_cast<int>(std::floor(point.y())) + kHalf;
    if (x < 0 || y < 0 || x >= 2 * kHalf || y >= 2 * kHalf) continue;
    const double height = point.z() - ground;
    std::uint8_t& column = columns[static_cast<std::size_t>(x * 2 * kHalf + y)];
    if (height < 0.4) column |= 1U;
    if (height > kLow && height < kHigh) column |= 2U;
  }
  const auto grounds = std::count_if(columns.begin(), columns.end(),
                                     [](std::uint8_t column) { return (column & 1U) != 0; });
  const auto roofed = std::count(columns.begin(), columns.end(), std::uint8_t{3});
  return static_cast<double>(roofed) > kShare * static_cast<double>(std::max<long>(grounds, 12));
}

void add(const Piece& piece, const Pose& T_submap_piece, double voxel, VoxelTable& table,
         Submap& submap) {
  const Eigen::Matrix3f R = T_submap_piece.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_submap_piece.translation.cast<float>();
  const double inverse = 1.0 / voxel;
  const Matrix6 covariance = turned(piece.covariance, T_submap_piece.rotation.inverse());
  if (spread(covariance) > spread(submap.covariance)) submap.covariance = covariance;
  const auto seen = cloud_of(piece);
  for (std::size_t i = 0; i < seen->points.size(); ++i) {
    const Eigen::Vector3f at = R * seen->points[i] + t;
    const auto key = voxel_key(voxel_index(at.cast<double>(), inverse));
    const auto next = static_cast<std::uint32_t>(submap.points.size());
    if (!table.find_or_insert(key, next).second) continue;
    submap.points.push_back(at);
    submap.eyes.emplace_back(R * seen->eyes[seen->seen_from[i]] + t);
  }
}

void finish(Submap& submap) {
  submap.ground = ground_height(submap.points);
  submap.covered = has_ceiling(submap.points, submap.ground);
  submap.to_slope = levelled_ground(submap.points, submap.ground);
  submap.slope_ground = ground_height(rotated(submap.points, submap.to_slope));
}

}  // namespace

Submap make_submap(const std::vector<Piece>& pieces, std::size_t index, std::size_t reach,
                   double voxel) {
  std::size_t first = index;
  while (first > 0 && index - first < reach && !pieces[first].restarted &&
         is_sure(pieces[first - 1].covariance)) {
    --first;
  }
  std::size_t last = index;
  while (last + 1 < pieces.size() && last - index < reach && !pieces[last + 1].restarted &&
         is_sure(pieces[last + 1].covariance)) {
    ++last;
  }
  Submap submap;
  VoxelTable table;
  // The middle first: where pieces overlap, its points stay.
  add(pieces[index], Pose{}, voxel, table, submap);
  const Pose T_middle_world = pieces[index].T_world_piece.inverse();
  for (std::size_t i = first; i <= last; ++i) {
    if (i != index) add(pieces[i], T_middle_world * pieces[i].T_world_piece, voxel, table, submap);
  }
  finish(submap);
  return submap;
}

Submap make_submap(const Piece& piece) {
  Submap submap;
  const auto seen = cloud_of(piece);
  submap.points = seen->points;
  submap.covariance = piece.covariance;
  for (const std::uint16_t eye : seen->seen_from) submap.eyes.push_back(seen->eyes[eye]);
  finish(submap);
  return submap;
}

}  // namespace surefoot::mapping
