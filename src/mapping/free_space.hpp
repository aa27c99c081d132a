// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a submap saw that there is nothing. A wall of another one that would stand there shows that
// the two are not one place, however much else fits; or, where they are one, that something moved.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

/// How finely beams are followed.
struct BeamFineness {
  double cube;        ///< [m]
  float longest;      ///< [m] farther away beams lie too far apart
  float before_end;   ///< [m] the end of a beam is not empty
  std::size_t beams;  ///< at most so many, evenly picked
};
inline constexpr std::uint8_t kEnoughBeams = 3;  // to call a cube empty

/// The cubes that a submap's beams went through, beam by beam.
template <typename Visit>
void follow_beams(const Submap& submap, const BeamFineness& fineness, Visit&& visit) {
  const auto step = static_cast<float>(0.9 * fineness.cube);
  const double inverse_cube = 1.0 / fineness.cube;
  const std::size_t every = submap.points.size() / fineness.beams + 1;
  for (std::size_t i = 0; i < submap.points.size(); i += every) {
    const Eigen::Vector3f beam = submap.points[i] - submap.eyes[i];
    const float length = beam.norm();
    const float end = std::min(length - fineness.before_end, fineness.longest);
    const Eigen::Vector3f along = beam / std::max(length, 1e-3F);
    VoxelIndex last = VoxelIndex::Constant(std::numeric_limits<int>::max());
    for (float way = 0.3F; way < end; way += step) {
      const Eigen::Vector3f at = submap.eyes[i] + way * along;
      const VoxelIndex cube = voxel_index(at.cast<double>(), inverse_cube);
      if (cube == last) continue;
      visit(cube);
      last = cube;
    }
  }
}

class FreeSpace {
 public:
  explicit FreeSpace(const Submap& submap);

  enum class Sight {
    unknown,
    occupied,  ///< something was seen here or in a neighbouring cube
    empty      ///< beams went through, and nothing was seen near
  };
  [[nodiscard]] Sight at(const Eigen::Vector3d& place) const;

 private:
  [[nodiscard]] bool occupied_about(const Eigen::Vector3i& index) const;

  VoxelTable occupied_;
  VoxelTable passed_;                 // index into passes_
  std::vector<std::uint8_t> passes_;  // beams, to 255
};

}  // namespace surefoot::mapping
