// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_descriptor.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace surefoot::mapping {

namespace {

constexpr int kRings = PlaceDescriptor::kRings;
constexpr int kSectors = PlaceDescriptor::kSectors;
constexpr float kLowest = 0.3F;  // above the ground [m]
constexpr float kSlice = 0.5F;   // [m], 16 of them
constexpr double kAside = 2.0;   // [m]

/// Squares of the rings' outer edges [m^2], evenly in their logarithm, from 1.5 m to 45 m.
constexpr std::array<float, kRings> kEdges = [] {
  constexpr double kWider = 1.4304953415973;  // (45 / 1.5)^(2 / 19)
  std::array<float, kRings> edges{};
  double edge = 1.5 * 1.5;
  for (float& each : edges) {
    each = static_cast<float>(edge);
    edge *= kWider;
  }
  edges.back() = 45.0F * 45.0F;
  return edges;
}();

/// What stands above the ground, in axes on the place's slope [m], and a bit for its slice of
/// height.
struct Standing {
  std::vector<float> x, y;
  std::vector<std::uint16_t> slices;
};

Standing standing_of(const Submap& submap) {
  Standing result;
  const Eigen::Matrix3f to_slope = submap.to_slope.toRotationMatrix().cast<float>();
  const float lowest = static_cast<float>(submap.slope_ground) + kLowest;
  for (const Eigen::Vector3f& from : submap.points) {
    const Eigen::Vector3f point = to_slope * from;
    const float height = point.z() - lowest;
    if (!(height >= 0.0F)) continue;
    result.x.push_back(point.x());
    result.y.push_back(point.y());
    const int slice = static_cast<int>(std::min(height / kSlice, 15.0F));
    result.slices.push_back(static_cast<std::uint16_t>(1U << slice));
  }
  return result;
}

/// In which sector a direction lies, counter-clockwise from -x. The arctangent is a polynomial
/// (Abramowitz and Stegun, 4.4.49: to 1e-5 rad), which a loop does several at once, and the same
/// bits everywhere.
int sector_of(float x, float y) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float across = std::abs(x), along = std::abs(y);
  const float larger = std::max(across, along), smaller = std::min(across, along);
  const float ratio = smaller / (larger + 1e-12F);
  const float r2 = ratio * ratio;
  const float octant =
      ratio *
      (0.9998660F + r2 * (-0.3302995F + r2 * (0.1801410F + r2 * (-0.0851330F + r2 * 0.0208351F))));
  // Which eighth of a turn it is, in numbers rather than branches.
  const float quadrant = (along > across ? 0.5F * kPi : 0.0F) + (along > across ? -octant : octant);
  const float half = (x < 0.0F ? kPi : 0.0F) + (x < 0.0F ? -quadrant : quadrant);
  const float angle = y < 0.0F ? -half : half;
  const int sector = static_cast<int>((angle + kPi) * (kSectors / (2.0F * kPi)));
  return std::min(sector, kSectors - 1);
}

/// Beyond how many edges a point lies; without a loop, so that one over points does several at
/// once.
template <std::size_t... edge>
int ring_of(float range2, std::index_sequence<edge...>) {
  return ((range2 >= kEdges[edge] ? 1 : 0) + ...);
}

/// The bin of each point, seen from a centre; those that lie too far are all in one behind the
/// last.
std::vector<std::int32_t> bins_of(const Standing& standing, const Eigen::Vector2f& centre) {
  std::vector<std::int32_t> bins(standing.x.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const float x = standing.x[i] - centre.x();
    const float y = standing.y[i] - centre.y();
    const int ring = ring_of(x * x + y * y, std::make_index_sequence<kRings>());
    bins[i] = ring * kSectors + sector_of(x, y);
  }
  return bins;
}

PlaceDescriptor describe(const Standing& standing, const Eigen::Vector2d& centre) {
  std::array<std::uint16_t, static_cast<std::size_t>(kRings + 1) * kSectors> slices{};
  const std::vector<std::int32_t> bins = bins_of(standing, centre.cast<float>());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    std::uint16_t& bin = slices[static_cast<std::size_t>(bins[i])];
    bin = static_cast<std::uint16_t>(bin | standing.slices[i]);
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

}  // namespace

PlaceDescriptor describe_place(const Submap& submap, const Eigen::Vector2d& centre) {
  return describe(standing_of(submap), centre);
}

std::vector<OffsetDescriptor> describe_with_offsets(const Submap& submap) {
  const Standing standing = standing_of(submap);
  std::vector<OffsetDescriptor> result;
  for (const double x : {0.0, -kAside, kAside}) {
    for (const double y : {0.0, -kAside, kAside}) {
      const Eigen::Vector2d centre(x, y);
      result.push_back({centre, describe(standing, centre)});
    }
  }
  return result;
}

double DescriptorDistance::yaw() const {
  return std::remainder(shift * 2.0 * std::numbers::pi / kSectors, 2.0 * std::numbers::pi);
}

namespace {

/// Columns, each of length 1, and which of them hold anything.
std::uint64_t unit_columns(const PlaceDescriptor& place, Eigen::Ref<Eigen::VectorXf> columns) {
  std::uint64_t occupied = 0;
  for (int column = 0; column < kSectors; ++column) {
    const float norm = place.bins.col(column).norm();
    columns.segment<kRings>(Eigen::Index{kRings} * column) =
        place.bins.col(column) / std::max(norm, 1e-6F);
    if (norm > 0.0F) occupied |= std::uint64_t{1} << column;
  }
  return occupied;
}

/// Of all columns; in a fixed order, many at once.
double dot_of_rounds(const float* first, const float* second) {
  constexpr int kLanes = 16;
  std::array<float, kLanes> sums{};
  for (int i = 0; i < kRings * kSectors; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      sums[static_cast<std::size_t>(lane)] += first[i + lane] * second[i + lane];
    }
  }
  double sum = 0.0;
  for (const float part : sums) sum += static_cast<double>(part);
  return sum;
}

}  // namespace

TurnedPlace::TurnedPlace(const PlaceDescriptor& place)
    : occupied_(unit_columns(place, columns_.head<kBins>())) {
  columns_.tail<kBins>() = columns_.head<kBins>();
}

DescriptorDistance TurnedPlace::distance_from(const PlaceDescriptor& first) const {
  constexpr std::uint64_t kAll = (std::uint64_t{1} << kSectors) - 1;
  Eigen::Matrix<float, kBins, 1> columns;
  const std::uint64_t occupied = unit_columns(first, columns);
  DescriptorDistance best;
  for (int shift = 0; shift < kSectors; ++shift) {
    const std::uint64_t turned = (occupied_ << shift | occupied_ >> (kSectors - shift)) & kAll;
    const int compared = std::popcount(occupied | turned);  // where nothing is on either side: not
    const float* second = columns_.data() + Eigen::Index{kRings} * (kSectors - shift);
    const double likeness = dot_of_rounds(columns.data(), second);
    const double distance = compared > 0 ? 1.0 - likeness / compared : 1.0;
    if (distance < best.distance) best = {distance, shift};
  }
  return best;
}

DescriptorDistance distance_between(const PlaceDescriptor& first, const PlaceDescriptor& second) {
  return TurnedPlace(second).distance_from(first);
}

double key_distance(const PlaceDescriptor& first, const PlaceDescriptor& second) {
  return (first.key - second.key).cwiseAbs().sum();
}

}  // namespace surefoot::mapping
