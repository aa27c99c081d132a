// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Clouds of planes and poles, and the surfels that a map makes of them.
#pragma once

#include <vector>

#include "methods/knots/surfel_map.hpp"
#include "support/random.hpp"

namespace surefoot::test {

using Points = std::vector<Eigen::Vector3d>;

inline const Eigen::Vector3d kSensor(2.0, 5.0,
                                     7.0);  // sees the tests' level and upright planes aslant

/// The values that the tests' geometry relies on.
inline Config::Knots knots_config() {
  Config::Knots config = Config().knots;
  config.finest_voxel = 0.4;
  config.levels = 4;
  config.divided_at = 0;
  config.points_per_voxel = 200;
  config.min_points = 6;
  config.breadth = 0.1;
  config.flatness = 0.06;
  config.slenderness = 0.1;
  config.edge_on = 0.03;
  config.cloud_weight = 0.0;  // planes and poles alone
  return config;
}

inline SurfelMap map_of(const Points& points, const Config::Knots& config = knots_config(),
                        const Eigen::Vector3d& sensor = kSensor) {
  SurfelMap map(config, 100.0);
  map.insert({sensor, points});
  return map;
}

inline const Surfel* find(const SurfelMap& map, const Eigen::Vector3d& place, int finest = 0,
                          const Eigen::Vector3d& sensor = kSensor) {
  return map.find(place, place - sensor, finest);
}

/// The answer for a point of which `last` remembers the one before.
inline const Surfel* find_again(const SurfelMap& map, const Eigen::Vector3d& place,
                                const Eigen::Vector3d& ray, int finest, SurfelMap::Place& last) {
  const SurfelMap::Question question{place, ray, &last};
  map.find_all({&question, 1}, finest);
  return last.surfel;
}

inline int level_found(const SurfelMap& map, const Eigen::Vector3d& place, int finest = 0) {
  SurfelMap::Place fresh;
  (void)find_again(map, place, place - kSensor, finest, fresh);
  return fresh.level;
}

/// All that is far is dropped after so many calls.
inline void remove_all_far(SurfelMap& map, const Eigen::Vector3d& sensor) {
  for (std::size_t i = 0; i < SurfelMap::kRound; ++i) map.remove_far(sensor);
}

/// Points about `centre`, spread evenly by +-half along each of the columns of `axes`, with noise.
inline Points cloud(Random& random, int count, const Eigen::Vector3d& centre,
                    const Eigen::Matrix3d& axes, const Eigen::Vector3d& half, double noise = 0.0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d share = random.vector(1.0);
    const Eigen::Vector3d off(random.normal(noise), random.normal(noise), random.normal(noise));
    points.emplace_back(centre + axes * share.cwiseProduct(half) + off);
  }
  return points;
}

inline const Eigen::Vector3d kCentre(0.2, 0.2, 0.2);  // of the finest voxel at the origin

}  // namespace surefoot::test
