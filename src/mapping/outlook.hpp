// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is seen of a submap from one of its eyes, direction by direction. A house that another one
// shows in free sight of that eye would have been seen: where there is only sky instead, no beam
// comes back, and so FreeSpace knows nothing about it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapping/submap.hpp"

namespace surefoot::mapping {

class Outlook {
 public:
  /// From the submap's eye that is nearest to a place.
  Outlook(const Submap& submap, const Eigen::Vector3d& near);

  enum class Sight {
    unknown,  ///< hidden by something nearer, too far away, or where no beam goes
    seen,     ///< something is there
    missing   ///< nothing is there, nor before it
  };
  [[nodiscard]] Sight at(const Eigen::Vector3d& place) const;
  [[nodiscard]] const Eigen::Vector3d& eye() const { return eye_; }

 private:
  struct Direction {
    std::size_t azimuth;
    std::size_t elevation;
    double steepness;  // elevation [rad]
    double distance;   // [m]
  };
  [[nodiscard]] Direction direction_of(const Eigen::Vector3d& place) const;

  Eigen::Vector3d eye_;
  double lowest_ = 0.0;               // beam [rad]
  double highest_ = 0.0;              // beam [rad]
  std::vector<std::uint64_t> rings_;  // by direction: of distance, those in which something is
};

}  // namespace surefoot::mapping
