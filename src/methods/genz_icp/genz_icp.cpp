// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/genz_icp/genz_icp.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"
#include "methods/paper/matches.hpp"
#include "methods/shared/adaptive_threshold.hpp"
#include "methods/shared/cell_downsample.hpp"

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr double kSearchThresholds = 3.0;    // correspondence distance, in thresholds
constexpr double kKernelSigmas = 1.0 / 3.0;  // kernel scale, in thresholds
constexpr int kMinNeighbours = 5;            // for a normal
constexpr double kFinestVoxel = 0.02;        // [m] limits of the adapted thinning
constexpr double kCoarsestVoxel = 2.0;       // [m]
constexpr double kMapThinning = 0.5;         // thinning of what enters the map

/// The hash of the original's thinning: decides in which order the thinned points come.
std::uint32_t genz_hash(const VoxelIndex& cell) {
  constexpr std::uint32_t kBits = (1U << 20) - 1;
  return kBits & ((static_cast<std::uint32_t>(cell.x()) * 73856093U) ^
                  (static_cast<std::uint32_t>(cell.y()) * 19349663U) ^
                  (static_cast<std::uint32_t>(cell.z()) * 83492791U));
}

/// A cell's planarity, kept while a point stays in the cell: the map does not change meanwhile.
struct KnownPlanarity {
  bool known = false;
  VoxelIndex cell;
  Planarity planarity;
};

struct GenzSum {
  NormalEquations<6> planar;
  PointToPointSum non_planar;
  GenzSum& operator+=(const GenzSum& other) {
    planar += other.planar;
    non_planar += other.non_planar;
    return *this;
  }
  /// alpha planar + (1 - alpha) non-planar, alpha the share of planar matches.
  [[nodiscard]] NormalEquations<6> equations() const {
    const NormalEquations<6> points = non_planar.equations();
    const int count = planar.count + points.count;
    const double alpha = static_cast<double>(planar.count) / std::max(count, 1);
    NormalEquations<6> sum;
    sum.H = alpha * planar.H + (1.0 - alpha) * points.H;
    sum.g = alpha * planar.g + (1.0 - alpha) * points.g;
    sum.weight = alpha * planar.weight + (1.0 - alpha) * points.weight;
    sum.weighted_squares =
        alpha * planar.weighted_squares + (1.0 - alpha) * points.weighted_squares;
    sum.count = count;
    return sum;
  }
};

/// One point's residual and weight into the sums.
void add_match(const Eigen::Vector3d& point, const Eigen::Vector3d& target,
               const Planarity& surface, double kernel, GenzSum& sum) {
  if (!surface.planar) {
    const double w = geman_mcclure_weight((point - target).squaredNorm(), kernel);
    sum.non_planar.add(point, target, w);
    return;
  }
  const Eigen::Matrix<double, 1, 1> r((point - target).dot(surface.normal));
  const Eigen::Matrix<double, 1, 6> J = plane_jacobian(point, surface.normal);
  sum.planar.add<1>(J, r, geman_mcclure_weight(r.squaredNorm(), kernel));
}

}  // namespace

double GenzThreshold::threshold(bool moved) {
  if (!moved) return config_.initial_threshold;
  const double error = model_error(deviation_, config_.max_range);
  if (error > config_.min_motion_th) {
    squares_ += error * error;
    ++samples_;
  }
  return samples_ < 1 ? config_.initial_threshold : std::sqrt(squares_ / samples_);
}

CellRounding cell_rounding(const GenzIcpParameters& config) {
  return config.floor_voxels ? CellRounding::down : CellRounding::to_zero;
}

GenzClouds adaptive_voxelize(const std::vector<Eigen::Vector3d>& points, double voxel_size,
                             const GenzIcpParameters& config) {
  const auto thin = [&](const std::vector<Eigen::Vector3d>& cloud, double size) {
    return cell_downsample(cloud, size, cell_rounding(config), genz_hash);
  };
  const double ratio = static_cast<double>(thin(points, voxel_size).size()) /
                       static_cast<double>(config.desired_num_voxelized_points);
  GenzClouds clouds;
  clouds.voxel_size = std::clamp(voxel_size * ratio, kFinestVoxel, kCoarsestVoxel);
  clouds.frame_downsample = thin(points, std::max(kMapThinning * clouds.voxel_size, kFinestVoxel));
  clouds.source = thin(clouds.frame_downsample, clouds.voxel_size);
  return clouds;
}

Planarity planarity(const VoxelMap& map, const VoxelIndex& cell, double planarity_threshold) {
  int count = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const VoxelIndex& shift : neighbour_shifts()) {
    for (const Eigen::Vector3d& point : map.cell(cell + shift)) {
      centre += point;
      covariance.noalias() += point * point.transpose();
      ++count;
    }
  }
  if (count < kMinNeighbours) return {};
  centre /= count;
  covariance = covariance / count - centre * centre.transpose();
  const SymmetricEigen<3> eigen = symmetric_eigen(covariance);
  const bool planar = eigen.values[0] / eigen.values.sum() < planarity_threshold;
  return {planar, eigen.vectors.col(0)};
}

Alignment align_genz(const std::vector<Eigen::Vector3d>& source, const VoxelMap& map,
                     const Pose& initial_guess, double sigma, const GenzIcpParameters& config,
                     const Workers& workers) {
  std::vector<KnownPlanarity> known(source.size());
  const auto surface_of = [&](std::size_t i, const VoxelIndex& cell) -> const Planarity& {
    if (!known[i].known || known[i].cell != cell) {
      known[i] = {true, cell, planarity(map, cell, config.planarity_threshold)};
    }
    return known[i].planarity;
  };
  const auto build = [&](std::vector<Eigen::Vector3d>& moved, const Pose& update) {
    const Eigen::Matrix3d R = update.rotation.toRotationMatrix();
    const auto sum = [&](std::size_t begin, std::size_t end) {
      GenzSum part;
      for (std::size_t i = begin; i < end; ++i) {
        moved[i] = R * moved[i] + update.translation;
        const Eigen::Vector3d* target = map.nearest(moved[i], kSearchThresholds * sigma);
        if (!target) continue;
        add_match(moved[i], *target, surface_of(i, map.index_of(moved[i])), kKernelSigmas * sigma,
                  part);
      }
      return part;
    };
    return workers.sum<GenzSum>(moved.size(), sum).equations();
  };
  return align(source, initial_guess, config.max_num_iterations, config.convergence_criterion,
               build);
}

}  // namespace surefoot
