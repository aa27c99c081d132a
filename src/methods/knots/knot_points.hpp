// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "methods/knots/knot_window.hpp"
#include "methods/knots/surfel_map.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// A scan's points to be registered, sorted by the segment of the window that they fall into.
struct KnotPoints {
  struct Point {
    Eigen::Vector3d position;  ///< LiDAR frame, as measured [m]
    double share;              ///< u: 0 at the segment's first knot, 1 at its last
    SurfelMap::Place place;    ///< where its surfel was last
  };
  std::vector<Point> points;
  std::vector<std::size_t> begins;  ///< per segment its first point; then the number of points
};

/// Chooses about as many points of every scan, evenly spread over what it sees: the cubes that it
/// thins them to follow the scene's scale from scan to scan.
class PointChoice {
 public:
  /// The cubes' sizes [m].
  struct Cubes {
    double finest, first, coarsest;
  };
  PointChoice(int points, const Cubes& cubes)
      : points_(points), cubes_(cubes), voxel_(cubes.first) {}

  /// `candidates` and the result are indices into the scan's points.
  [[nodiscard]] std::vector<std::uint32_t> choose(const PreparedScan& scan,
                                                  const std::vector<std::uint32_t>& candidates,
                                                  const Workers& workers);
  /// Likewise, of all points.
  [[nodiscard]] std::vector<std::uint32_t> choose(const PreparedScan& scan, const Workers& workers);

 private:
  std::vector<std::uint32_t> thin(const std::vector<Eigen::Vector3f>& places,
                                  const Workers& workers);

  int points_;
  Cubes cubes_;
  double voxel_;  // [m] for the next scan
};

/// Of the points to be mapped: every voxel that was seen takes one at least.
[[nodiscard]] PointChoice map_choice(const Config::Knots& config);

/// By the segment that each point's instant falls into; without times, the scan's middle.
[[nodiscard]] KnotPoints sort_points(const PreparedScan& scan,
                                     const std::vector<std::uint32_t>& chosen,
                                     const KnotWindow& window);

}  // namespace surefoot
