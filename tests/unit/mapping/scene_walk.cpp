// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "unit/mapping/scene_walk.hpp"

#include <cmath>
#include <numbers>

#include "geometry/se3.hpp"
#include "simulation/ground_path.hpp"
#include "simulation/random.hpp"
#include "simulation/ray_caster.hpp"

namespace surefoot::test {

namespace {

constexpr int kRings = 16;
constexpr int kColumns = 900;
constexpr double kEyeHeight = 0.5;  // [m]
constexpr double kNoise = 0.01;

DeskewedScan look_from(const Pose& pose, const simulation::RayCaster& rays,
                       const simulation::CounterRandom& random, std::uint64_t number) {
  std::vector<simulation::Ray> beams;
  std::vector<Eigen::Vector3d> directions;
  for (int column = 0; column < kColumns; ++column) {
    // A little turned from scan to scan, as real ones are.
    const double azimuth = 2.0 * std::numbers::pi * (column + random.uniform(number)) / kColumns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation = (2.0 * ring - 15.0) * std::numbers::pi / 180.0;
      directions.emplace_back(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      beams.push_back({pose.translation.cast<float>(),
                       (pose.rotation * directions.back()).cast<float>(), 0.0F});
    }
  }
  std::vector<simulation::Hit> hits(beams.size());
  rays.cast(beams, 80.0F, hits);
  DeskewedScan scan;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i].valid() || hits[i].distance < 0.5F) continue;
    const double noise = kNoise * random.normal(number * 100'000 + i);
    scan.points.emplace_back(((hits[i].distance + noise) * directions[i]).cast<float>());
  }
  return scan;
}

}  // namespace

SceneWalk walk_through(const std::string& name, std::uint64_t seed, const WalkOptions& options) {
  const simulation::SceneSeeds seeds{seed, options.things == 0 ? seed : options.things};
  const simulation::Scene scene = simulation::build_scene(name, seeds);
  const simulation::RayCaster rays(scene);
  const simulation::GroundPath path(scene, rays, {}, options.from + options.length);
  const simulation::CounterRandom random(seed, 77);
  SceneWalk walk;
  Pose odometry;
  for (std::uint64_t i = 0; static_cast<double>(i) * options.step < options.length; ++i) {
    const simulation::PoseAngles at = path.at(options.from + static_cast<double>(i) * options.step);
    Pose pose;
    pose.rotation = from_roll_pitch_yaw(at.tail<3>());
    pose.translation = at.head<3>() + Eigen::Vector3d(0.0, 0.0, kEyeHeight);
    if (i == 0) {
      // Level all the same, as the odometry's world is.
      odometry = options.unknown_start ? upright(pose).inverse() * pose : pose;
    } else {
      const Twist drift =
          options.step *
          (Twist() << 0.0, 0.0, options.rise, 0.0, 0.0, options.yaw_drift).finished();
      odometry = odometry * (walk.truth.back().inverse() * pose) * se3_exp(drift);
    }
    mapping::PlacedScan scan;
    scan.stamp_ns = static_cast<std::int64_t>(i) * 500'000'000;
    scan.T_world_lidar = odometry;
    scan.covariance = 1e-6 * Matrix6::Identity();
    walk.scans.push_back(scan);
    walk.points.push_back(look_from(pose, rays, random, i));
    walk.truth.push_back(pose);
  }
  return walk;
}

}  // namespace surefoot::test
