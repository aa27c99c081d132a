// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "methods/knots/beams.hpp"

namespace surefoot {

/// Where a view's points lie from its sensor.
struct Sighting {
  Sighting(const Eigen::Vector3d& sensor, const std::vector<Eigen::Vector3d>& points,
           const Workers& workers)
      : rays(points.size()), ranges(points.size()) {
    workers.for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector3d ray = points[i] - sensor;
        ranges[i] = ray.norm();
        rays[i] = ray / ranges[i];
      }
    });
  }

  std::vector<Eigen::Vector3d> rays;  ///< unit vectors [map frame]
  std::vector<double> ranges;         ///< [m]
};

/// What a scan saw, from where it is taken to be [m, map frame].
struct View {
  View(const Eigen::Vector3d& from, std::vector<Eigen::Vector3d> seen,
       const Workers& workers = Workers(1))
      : sensor(from),
        points(std::move(seen)),
        sighting(sensor, points, workers),
        beams(sensor, sighting.rays, sighting.ranges) {}

  Eigen::Vector3d sensor;
  std::vector<Eigen::Vector3d> points;
  Sighting sighting;
  Beams beams;
};

}  // namespace surefoot
