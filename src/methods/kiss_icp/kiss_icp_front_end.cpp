// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/kiss_icp/kiss_icp_front_end.hpp"

#include <cmath>

#include "config/method.hpp"
#include "methods/kiss_icp/kiss_icp.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {

/// So many points of this spacing fill a voxel's face.
double map_resolution(const KissIcpParameters& config) {
  return std::sqrt(config.voxel_size * config.voxel_size / config.max_points_per_voxel);
}

}  // namespace

KissIcpFrontEnd::KissIcpFrontEnd(const Session& session)
    : BaselineFrontEnd(session),
      kiss_(own_parameters<KissIcpParameters>(session.config)),
      map_({kiss_.voxel_size, kiss_.max_points_per_voxel, map_resolution(kiss_), kiss_.max_range}),
      adaptive_threshold_(kiss_.initial_threshold, kiss_.min_motion_th, kiss_.max_range) {}

Estimate KissIcpFrontEnd::add(const PreparedScan& scan) {
  begin_step(Step::deskew);
  const bool moving = kiss_.deskew && !scan.taus.empty();
  const Twist motion = moving ? se3_log(last_delta_) : Twist::Zero();
  const std::vector<Eigen::Vector3d> at_end = deskew_to(1.0, scan, motion, workers());
  const Pose T_mid_end = se3_exp(0.5 * motion);
  keep_scan(to_float(transformed(T_mid_end, at_end)), scan);
  if (!started()) last_pose_ = first_pose(deskewed_scan().points);

  begin_step(Step::downsample);
  const auto [frame_downsample, source] =
      voxelize(crop(at_end, kiss_.min_range, kiss_.max_range), kiss_.voxel_size);

  begin_step(Step::search);
  const Pose initial_guess = last_pose_ * last_delta_;
  const bool first = map_.empty();
  Alignment alignment;
  alignment.T_map_lidar = initial_guess;
  if (!first) {
    alignment = align_points_to_map(source, map_, initial_guess, adaptive_threshold_.threshold(),
                                    kiss_, workers());
  }
  const Pose& new_pose = alignment.T_map_lidar;

  begin_step(Step::map);
  adaptive_threshold_.add(initial_guess.inverse() * new_pose);
  update_map(frame_downsample, new_pose);
  last_delta_ = last_pose_.inverse() * new_pose;
  last_pose_ = new_pose;
  const ScanTrajectory trajectory = constant_velocity_through(new_pose, 1.0, motion, scan);
  return first ? report_first(trajectory) : report(alignment, trajectory);
}

void KissIcpFrontEnd::update_map(const std::vector<Eigen::Vector3d>& points,
                                 const Pose& T_map_end) {
  for (const Eigen::Vector3d& point : transformed(T_map_end, points)) map_.insert(point);
  map_.remove_far(T_map_end.translation);
}

}  // namespace surefoot
