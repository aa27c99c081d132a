// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "moment.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "simulated_walk.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

/// Adds the scans before the moment. Returns the last one's estimate.
Estimate warm_up(Odometry& odometry) {
  Estimate last;
  for (std::size_t i = 0; i < kWarmUp; ++i) last = odometry.add_scan(campus_scans()[i]);
  if (last.status != Status::ok) {
    throw std::runtime_error("the walk's scan " + std::to_string(kWarmUp - 1) + " is " +
                             std::string(to_string(last.status)) + ", not ok: " + last.message);
  }
  return last;
}

}  // namespace

const std::vector<Scan>& campus_scans() {
  static const std::vector<Scan> scans = [] {
    SimulatedWalk walk(campus(), {.scans = kWarmUp + kMeasured});
    std::vector<Scan> all;
    while (auto scan = walk.next()) all.push_back(std::move(*scan));
    return all;
  }();
  return scans;
}

Moment::Moment()
    : map(paper.map, max_search_radius(paper.registration)), scan(campus_scans()[kWarmUp]) {
  Odometry odometry(config);
  const Estimate last = warm_up(odometry);
  for (const Eigen::Vector3d& point : odometry.local_map()) map.insert(point);

  prepared = preprocess(scan, config.preprocess);
  const LastMotion motion{{last.stamp_ns, last.T_world_lidar}, last.twist};
  prior = predict_motion(motion, prepared.start_ns, prepared.end_ns,
                         config.motion_prior.max_extrapolation);
  predicted = predict_trajectory(prior, prepared.start_ns, prepared.end_ns, paper.deskew);
  deskewed = deskew(prepared, predicted, workers);
  thinned = thin_scan(deskewed, paper.downsample);
  source.points = thinned.source_points;
  registration = register_scan(source, map, predicted.at(0.5), paper, config.health.min_matches,
                               workers, [](Step) {});
}

const Moment& moment() {
  static const Moment only;
  return only;
}

}  // namespace surefoot::benchmarks
