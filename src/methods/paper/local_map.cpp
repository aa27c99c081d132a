// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/local_map.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/decompositions.hpp"
#include "geometry/float_sums.hpp"

namespace surefoot {

namespace {

constexpr std::size_t kLanes = 4;  // points compared at once: one SSE or NEON vector
constexpr float kFarAway = 1e15F;  // unused places: farther than anything, and its square finite
using Lanes = Eigen::Array<float, kLanes, 1>;

// What is far is let go of when the sensor went this share of the radius, not at every scan.
constexpr double kCleaningShare = 0.05;

// A strip as narrow as this, RMS, is noise about a line, such as one ring on a wall, not a plane
// [m].
constexpr double kNarrow = 0.05;

/// Squared distances from a place to the voxels around its own, axis by axis.
class AxisGaps {
 public:
  /// `local`: the place, from its voxel's corner [m]; `reach`: voxels each way.
  AxisGaps(const Eigen::Vector3f& local, float size, int reach) : reach_(reach) {
    for (int axis = 0; axis < 3; ++axis) {
      float* const gaps = &gaps_[axis][reach];
      gaps[0] = 0.0F;
      for (int steps = 1; steps <= reach; ++steps) {
        const float ahead = static_cast<float>(steps) * size - local[axis];
        const float behind = static_cast<float>(steps - 1) * size + local[axis];
        gaps[steps] = ahead * ahead;
        gaps[-steps] = behind * behind;
      }
    }
  }

  [[nodiscard]] float squared(const VoxelIndex& offset) const {
    return gaps_[0][reach_ + offset.x()] + gaps_[1][reach_ + offset.y()] +
           gaps_[2][reach_ + offset.z()];
  }

 private:
  int reach_;
  float gaps_[3][2 * LocalMap::kMaxReach + 1];
};

}  // namespace

void LocalMap::Moments::add(const Eigen::Vector3d& p) {
  count += 1.0;
  sum += p;
  products += p * p.transpose();
}

void LocalMap::Moments::add(const Moments& other, const Eigen::Vector3d& offset) {
  // sum (p + o)(p + o)^T = sum p p^T + s o^T + o s^T + n o o^T
  const Eigen::Matrix3d cross = other.sum * offset.transpose();
  products +=
      other.products + cross + cross.transpose() + other.count * (offset * offset.transpose());
  sum += other.sum + other.count * offset;
  count += other.count;
}

LocalMap::LocalMap(const PaperParameters::Map& config, double max_radius)
    : size_(config.voxel_size),
      inverse_size_(1.0 / config.voxel_size),
      min_spacing2_(static_cast<float>(config.min_spacing * config.min_spacing)),
      capacity_(static_cast<std::uint32_t>(config.points_per_voxel)),
      stride_((capacity_ + kLanes - 1) / kLanes * kLanes),
      reach_(std::min(static_cast<int>(std::ceil(max_radius * inverse_size_)), kMaxReach)) {
  for (int x = -reach_; x <= reach_; ++x) {
    for (int y = -reach_; y <= reach_; ++y) {
      for (int z = -reach_; z <= reach_; ++z) {
        const Eigen::Array3i between = Eigen::Array3i(x, y, z).abs() - 1;
        const double gap2 = (between.max(0).cast<double>() * size_).square().sum();
        if (gap2 < max_radius * max_radius) {
          neighbours_.push_back({{x, y, z}, static_cast<float>(gap2)});
        }
      }
    }
  }
  // Nearest first; among equal gaps the middle voxel, then faces, edges, corners.
  const auto rank = [](const Neighbour& n) {
    return std::make_tuple(n.squared_gap, n.offset.squaredNorm(), n.offset.x(), n.offset.y(),
                           n.offset.z());
  };
  std::sort(neighbours_.begin(), neighbours_.end(),
            [&](const Neighbour& a, const Neighbour& b) { return rank(a) < rank(b); });
}

std::uint32_t LocalMap::voxel_at(const VoxelIndex& index) {
  const auto next = static_cast<std::uint32_t>(voxels_.size());
  const auto [voxel, inserted] = table_.find_or_insert(voxel_key(index), next);
  if (inserted) {
    voxels_.push_back({index, {}});
    counts_.push_back(0);
    coordinates_.resize(coordinates_.size() + 3 * stride_, kFarAway);
  }
  return voxel;
}

bool LocalMap::crowded(std::uint32_t voxel, const Eigen::Vector3f& local) const {
  const float* const x = block(voxel);
  for (std::size_t i = 0; i < counts_[voxel]; ++i) {
    const Eigen::Vector3f other(x[i], x[stride_ + i], x[2 * stride_ + i]);
    if (squared_norm(other - local) < min_spacing2_) return true;
  }
  return false;
}

void LocalMap::insert(const Eigen::Vector3d& point) {
  const VoxelIndex index = voxel_of(point);
  const std::uint32_t voxel = voxel_at(index);
  std::uint8_t& count = counts_[voxel];
  if (count == capacity_) return;
  const Eigen::Vector3f local = (point - corner(index)).cast<float>();
  if (crowded(voxel, local)) return;
  float* const place = block(voxel) + count;
  place[0] = local.x();
  place[stride_] = local.y();
  place[2 * stride_] = local.z();
  ++count;
  voxels_[voxel].moments.add(local.cast<double>());
}

void LocalMap::remove_far(const Eigen::Vector3d& sensor, double radius) {
  if (!cleaned_at_) cleaned_at_ = sensor;
  if ((sensor - *cleaned_at_).norm() < kCleaningShare * radius) return;
  cleaned_at_ = sensor;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * size_);
  std::uint32_t kept = 0;
  table_.clear();
  for (std::uint32_t voxel = 0; voxel < voxels_.size(); ++voxel) {
    if ((corner(voxels_[voxel].index) + half - sensor).norm() > radius) continue;
    if (kept != voxel) {
      voxels_[kept] = voxels_[voxel];
      counts_[kept] = counts_[voxel];
      std::copy_n(block(voxel), 3 * stride_, block(kept));
    }
    table_.find_or_insert(voxel_key(voxels_[kept].index), kept);
    ++kept;
  }
  voxels_.resize(kept);
  counts_.resize(kept);
  coordinates_.resize(3 * stride_ * kept);
}

void LocalMap::clear() {
  voxels_.clear();
  counts_.clear();
  coordinates_.clear();
  table_.clear();
  cleaned_at_.reset();
}

/// The nearest points seen so far, sorted by distance.
class LocalMap::NearestList {
 public:
  explicit NearestList(float radius) : limit_(radius * radius) {}

  /// Points at least this far away need not be offered [m^2].
  [[nodiscard]] float limit() const { return limit_; }

  /// A point nearer than the limit.
  void offer(float squared_distance, const Eigen::Vector3f& offset) {
    int place = count_ < Nearby::kMost ? count_++ : Nearby::kMost - 1;
    for (; place > 0 && squared_[place - 1] > squared_distance; --place) {
      squared_[place] = squared_[place - 1];
      offsets_[place] = offsets_[place - 1];
    }
    squared_[place] = squared_distance;
    offsets_[place] = offset;
    if (count_ == Nearby::kMost) limit_ = squared_[Nearby::kMost - 1];
  }

  [[nodiscard]] Nearby result() const { return {count_, offsets_, std::sqrt(limit_)}; }

 private:
  float limit_;
  int count_ = 0;
  std::array<float, Nearby::kMost> squared_;
  std::array<Eigen::Vector3f, Nearby::kMost> offsets_;
};

void LocalMap::search_voxel(std::uint32_t voxel, const Eigen::Vector3f& place,
                            NearestList& list) const {
  const float* const x = block(voxel);
  const float* const y = x + stride_;
  const float* const z = y + stride_;
  const std::uint32_t used = counts_[voxel];
  for (std::uint32_t i = 0; i < used; i += kLanes) {
    const Lanes dx = Eigen::Map<const Lanes>(x + i) - place.x();
    const Lanes dy = Eigen::Map<const Lanes>(y + i) - place.y();
    const Lanes dz = Eigen::Map<const Lanes>(z + i) - place.z();
    const Lanes squared = dx.square() + dy.square() + dz.square();
    if (squared.minCoeff() >= list.limit()) continue;
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      if (squared[lane] < list.limit()) list.offer(squared[lane], {dx[lane], dy[lane], dz[lane]});
    }
  }
}

Nearby LocalMap::nearby(const Eigen::Vector3d& place, double radius) const {
  const VoxelIndex middle = voxel_of(place);
  const Eigen::Vector3f local = (place - corner(middle)).cast<float>();
  const AxisGaps gaps(local, static_cast<float>(size_), reach_);
  NearestList list(static_cast<float>(std::min(radius, reach_ * size_)));
  for (const auto& [offset, least_gap] : neighbours_) {
    if (least_gap >= list.limit()) break;
    if (gaps.squared(offset) >= list.limit()) continue;
    const std::uint32_t voxel = find(middle + offset);
    if (voxel == VoxelTable::kNone) continue;
    search_voxel(voxel, local - offset.cast<float>() * static_cast<float>(size_), list);
  }
  return list.result();
}

Surface LocalMap::surface(const VoxelIndex& voxel) const {
  Moments around;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const VoxelIndex offset(x, y, z);
        const std::uint32_t at = find(voxel + offset);
        if (at != VoxelTable::kNone) {
          around.add(voxels_[at].moments, offset.cast<double>() * size_);
        }
      }
    }
  }
  Surface surface;
  surface.neighbours = static_cast<int>(around.count);
  if (surface.neighbours < 3) return surface;
  const Eigen::Vector3d mean = around.sum / around.count;
  const Eigen::Matrix3d C = around.products / around.count - mean * mean.transpose();  // [Eq 21]
  const SymmetricEigen<3> eigen = symmetric_eigen_direct(C);
  surface.normal = eigen.vectors.col(0);  // [Eq 22]
  const Eigen::Vector3d& spread = eigen.values;
  const double thickness = std::max(spread[0], 0.0);  // rounding may leave it below zero
  if (spread[2] > 0.0) surface.planarity = std::max(0.0, (spread[1] - thickness) / spread[2]);
  surface.flatness = std::max(0.0, (spread[1] - thickness) / (spread[1] + kNarrow * kNarrow));
  return surface;
}

std::vector<Eigen::Vector3d> LocalMap::points() const {
  std::vector<Eigen::Vector3d> result;
  for (std::uint32_t at = 0; at < voxels_.size(); ++at) {
    for (std::uint32_t i = 0; i < counts_[at]; ++i) {
      const float* const x = block(at) + i;
      result.push_back(corner(voxels_[at].index) +
                       Eigen::Vector3d(x[0], x[stride_], x[2 * stride_]));
    }
  }
  return result;
}

}  // namespace surefoot
