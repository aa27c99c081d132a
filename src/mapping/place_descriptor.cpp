// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_descriptor.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace surefoot::mapping {

namespace {

constexpr int kRings = PlaceDescriptor::kRings;
constexpr int kSectors = PlaceDescriptor::kSectors;
constexpr double kInner = 1.5;   // of the first ring's outer edge [m]
constexpr double kOuter = 45.0;  // of the last ring
constexpr double kLowest = 0.3;  // above the ground [m]
constexpr double kSlice = 0.5;   // [m], 16 of them
constexpr double kAside = 2.0;   // [m]

}  // namespace

PlaceDescriptor describe_place(const Submap& submap, const Eigen::Vector2d& centre) {
  std::array<std::uint16_t, static_cast<std::size_t>(kRings) * kSectors> slices{};
  const double rings_per_e = (kRings - 1) / std::log(kOuter / kInner);
  const Eigen::Matrix3f to_slope = submap.to_slope.toRotationMatrix().cast<float>();
  for (const Eigen::Vector3f& from : submap.points) {
    const Eigen::Vector3f point = to_slope * from;
    const double x = point.x() - centre.x();
    const double y = point.y() - centre.y();
    const double height = point.z() - submap.slope_ground - kLowest;
    const double range = std::hypot(x, y);
    if (height < 0.0 || range >= kOuter) continue;
    const int ring =
        range < kInner ? 0 : 1 + static_cast<int>(rings_per_e * std::log(range / kInner));
    const double turns = (std::atan2(y, x) + std::numbers::pi) / (2.0 * std::numbers::pi);
    const int sector = std::min(static_cast<int>(turns * kSectors), kSectors - 1);
    const int slice = std::min(static_cast<int>(height / kSlice), 15);
    const auto bin = static_cast<std::size_t>(std::min(ring, kRings - 1) * kSectors + sector);
    slices[bin] = static_cast<std::uint16_t>(slices[bin] | 1U << slice);
  }
  PlaceDescriptor result;
  for (int ring = 0; ring < kRings; ++ring) {
    int occupied = 0;
    for (int sector = 0; sector < kSectors; ++sector) {
      const int count = std::popcount(slices[static_cast<std::size_t>(ring * kSectors + sector)]);
      result.bins(ring, sector) = static_cast<float>(count);
      occupied += count > 0 ? 1 : 0;
    }
    result.key[ring] = static_cast<float>(occupied) / static_cast<float>(kSectors);
  }
  return result;
}

std::vector<OffsetDescriptor> describe_with_offsets(const Submap& submap) {
  std::vector<OffsetDescriptor> result;
  for (const double x : {0.0, -kAside, kAside}) {
    for (const double y : {0.0, -kAside, kAside}) {
      const Eigen::Vector2d centre(x, y);
      result.push_back({centre, describe_place(submap, centre)});
    }
  }
  return result;
}

double DescriptorDistance::yaw() const {
  return std::remainder(shift * 2.0 * std::numbers::pi / kSectors, 2.0 * std::numbers::pi);
}

DescriptorDistance distance_between(const PlaceDescriptor& first, const PlaceDescriptor& second) {
  using Row = Eigen::Matrix<float, 1, kSectors>;
  const Row norms1 = first.bins.colwise().norm();
  const Row norms2 = second.bins.colwise().norm();
  DescriptorDistance best;
  for (int shift = 0; shift < kSectors; ++shift) {
    double likeness = 0.0;
    int compared = 0;
    for (int column = 0; column < kSectors; ++column) {
      const int turned = (column - shift + kSectors) % kSectors;
      if (norms1[column] == 0.0F && norms2[turned] == 0.0F) continue;  // nothing on either side
      ++compared;
      if (norms1[column] == 0.0F || norms2[turned] == 0.0F) continue;
      likeness +=
          first.bins.col(column).dot(second.bins.col(turned)) / (norms1[column] * norms2[turned]);
    }
    const double distance = compared > 0 ? 1.0 - likeness / compared : 1.0;
    if (distance < best.distance) best = {distance, shift};
  }
  return best;
}

double key_distance(const PlaceDescriptor& first, const PlaceDescriptor& second) {
  return (first.key - second.key).cwiseAbs().sum();
}

}  // namespace surefoot::mapping
