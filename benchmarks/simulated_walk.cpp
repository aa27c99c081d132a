// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulated_walk.hpp"

#include <utility>

#include "simulation/body_motion.hpp"
#include "simulation/gait.hpp"
#include "simulation/lidar_model.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr std::uint64_t kSeed = 1;
const Pose kMount{Eigen::Quaterniond::Identity(), {0.10, 0.0, 0.16}};  // T_body_lidar

simulation::Motion make_walk(const simulation::Scene& scene, const simulation::RayCaster& rays,
                             const simulation::LidarModel& lidar, const WalkOptions& options) {
  simulation::GaitModel gait = simulation::gait_model(scene.robot);
  if (options.speed > 0.0) gait.speed = options.speed;
  // One turn more than is scanned: the last scan's last firing lies beyond its nominal end.
  const double duration = 1e-9 * lidar.turn_ns * static_cast<double>(options.scans + 1);
  return simulation::make_motion(scene, rays, gait, duration, kSeed, kMount);
}

simulation::Scanner make_scanner(const simulation::Scene& scene, simulation::RayCaster& rays,
                                 const WalkOptions& options) {
  const simulation::LidarModel lidar = simulation::lidar_model("vlp16");
  simulation::ScannerOptions scanning;
  scanning.seed = kSeed;
  scanning.footprint = options.footprint;
  return {rays, lidar, make_walk(scene, rays, lidar, options), scanning};
}

}  // namespace

SimulatedWalk::SimulatedWalk(simulation::Scene scene, const WalkOptions& options)
    : scene_(std::move(scene)),
      scans_(options.scans),
      rays_(scene_),
      scanner_(make_scanner(scene_, rays_, options)) {}

std::optional<Scan> SimulatedWalk::next() {
  if (done_ == scans_) return std::nullopt;
  return scanner_.scan(done_++).scan;
}

Pose SimulatedWalk::T_map_lidar(std::int64_t instant_ns) const {
  const std::int64_t since_start_ns = instant_ns - scanner_.options().start_ns;
  return scanner_.motion().T_map_lidar(seconds(since_start_ns));
}

simulation::Scene campus() { return simulation::build_scene("campus", kSeed); }

}  // namespace surefoot::benchmarks
