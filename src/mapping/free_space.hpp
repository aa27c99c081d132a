// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a submap saw that there is nothing. A wall of another one that would stand there shows that
// the two are not one place, however much else fits; or, where they are one, that something moved.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

class FreeSpace {
 public:
  /// How finely beams are followed.
  struct Fineness {
    double cube;        ///< [m]
    float longest;      ///< [m] farther away beams lie too far apart
    float before_end;   ///< [m] the end of a beam is not empty
    std::size_t beams;  ///< at most so many, evenly picked
  };
  /// Of places that are compared: more beams say the same, and are as wide as a cube far away.
  static constexpr Fineness kOfPlaces{0.4, 25.0F, 0.8F, 15000};
  /// Of a single thing.
  static constexpr Fineness kOfThings{0.3, 15.0F, 0.6F, std::numeric_limits<std::size_t>::max()};

  /// `stands`: whether a point [m, the submap's frame] is something; the others only end beams.
  explicit FreeSpace(
      const Submap& submap, const Fineness& fineness = kOfPlaces,
      const std::function<bool(const Eigen::Vector3f& point)>& stands = [](const auto&) {
        return true;
      });

  enum class Sight {
    unknown,
    occupied,  ///< something was seen here or in a neighbouring cube
    empty      ///< beams went through, and nothing was seen near
  };
  [[nodiscard]] Sight at(const Eigen::Vector3d& place) const;

 private:
  [[nodiscard]] bool occupied_about(const Eigen::Vector3i& index) const;

  double inverse_cube_;  // [1/m]
  VoxelTable occupied_;
  VoxelTable passed_;                 // index into passes_
  std::vector<std::uint8_t> passes_;  // beams, to 255
};

}  // namespace surefoot::mapping
