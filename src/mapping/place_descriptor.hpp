// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a place looks like from above, in rings and sectors about it, so that turning it shifts its
// columns: after Kim and Kim, "Scan Context" (IROS 2018). Here a bin holds how much stands in it
// (occupied slices of height) rather than the highest point, since a ceiling would hide all else
// indoors; and rings widen outwards, so that one radius serves corridors and squares.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapping/submap.hpp"

namespace surefoot::mapping {

struct PlaceDescriptor {
  static constexpr int kRings = 20;
  static constexpr int kSectors = 60;
  Eigen::Matrix<float, kRings, kSectors> bins;  ///< occupied slices of height, at most 16
  /// Share of a ring's sectors where something stands, ring by ring: turning does not change it.
  Eigen::Matrix<float, kRings, 1> key;
};

/// Seen from `centre` [m, the submap's axes on its slope].
[[nodiscard]] PlaceDescriptor describe_place(const Submap& submap,
                                             const Eigen::Vector2d& centre = {0.0, 0.0});

/// A place again, but seen from some metres aside: the way back may not be the way there.
struct OffsetDescriptor {
  Eigen::Vector2d centre;
  PlaceDescriptor descriptor;
};
[[nodiscard]] std::vector<OffsetDescriptor> describe_with_offsets(const Submap& submap);

/// How unlike two places are, 0 to 1, turned against each other as suits best.
struct DescriptorDistance {
  double distance = 1.0;
  int shift = 0;  ///< sectors by which the second must be turned (counter-clockwise)
  [[nodiscard]] double yaw() const;  ///< [rad] R_first_second
};
/// A place to be compared with many: its columns, each of length 1, twice round, so that any turn
/// of them is one run of numbers.
class TurnedPlace {
 public:
  explicit TurnedPlace(const PlaceDescriptor& place);
  [[nodiscard]] DescriptorDistance distance_from(const PlaceDescriptor& first) const;

 private:
  static constexpr int kBins = PlaceDescriptor::kRings * PlaceDescriptor::kSectors;
  Eigen::Matrix<float, 2 * kBins, 1> columns_;
  std::uint64_t occupied_ = 0;  // a bit a column: something stands in it
};
[[nodiscard]] DescriptorDistance distance_between(const PlaceDescriptor& first,
                                                  const PlaceDescriptor& second);
[[nodiscard]] double key_distance(const PlaceDescriptor& first, const PlaceDescriptor& second);

}  // namespace surefoot::mapping
