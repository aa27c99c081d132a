// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "methods/knots/beams.hpp"

namespace surefoot {

/// Where a view's points lie from its sensor.
struct Sighting {
  Sighting(const Eigen::Vector3d& sensor, const std::vector<Eigen::Vector3d>& points) {
    rays.reserve(points.size());
    ranges.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
      const Eigen::Vector3d ray = point - sensor;
      ranges.push_back(ray.norm());
      rays.emplace_back(ray / ranges.back());
    }
  }

  std::vector<Eigen::Vector3d> rays;  ///< unit vectors [map frame]
  std::vector<double> ranges;         ///< [m]
};

/// What a scan saw, from where it is taken to be [m, map frame].
struct View {
  View(const Eigen::Vector3d& from, std::vector<Eigen::Vector3d> seen)
      : sensor(from),
        points(std::move(seen)),
        sighting(sensor, points),
        beams(sensor, sighting.rays, sighting.ranges) {}

  Eigen::Vector3d sensor;
  std::vector<Eigen::Vector3d> points;
  Sighting sighting;
  Beams beams;
};

}  // namespace surefoot
