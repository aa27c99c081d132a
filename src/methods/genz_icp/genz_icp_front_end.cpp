// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/genz_icp/genz_icp_front_end.hpp"

#include "config/method.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {
constexpr double kMovedThresholds = 5.0;  // farther than so many min_motion_th: away from the start
}

GenzIcpFrontEnd::GenzIcpFrontEnd(const Session& session)
    : BaselineFrontEnd(session),
      genz_(own_parameters<GenzIcpParameters>(session.config)),
      map_({genz_.voxel_size, genz_.max_points_per_voxel, 0.0, genz_.map_cleanup_radius,
            cell_rounding(genz_)}),
      threshold_(genz_),
      voxel_size_(genz_.voxel_size) {}

Estimate GenzIcpFrontEnd::add(const PreparedScan& scan) {
  begin_step(Step::deskew);
  const bool moving = genz_.deskew && !scan.taus.empty() && poses_ > 2;
  const Twist motion = moving ? se3_log(last_delta_) : Twist::Zero();
  const std::vector<Eigen::Vector3d> at_mid = deskew_to(0.5, scan, motion, workers());
  keep_scan(to_float(at_mid), scan);
  if (!started()) last_pose_ = first_pose_ = first_pose(deskewed_scan().points);

  begin_step(Step::downsample);
  const GenzClouds clouds =
      adaptive_voxelize(crop(at_mid, genz_.min_range, genz_.max_range), voxel_size_, genz_);
  voxel_size_ = clouds.voxel_size;

  begin_step(Step::search);
  const double sigma = threshold_.threshold(has_moved());
  const Pose initial_guess = last_pose_ * last_delta_;
  const bool first = map_.empty();
  Alignment alignment;
  alignment.T_map_lidar = initial_guess;
  if (!first) {
    alignment = align_genz(clouds.source, map_, initial_guess, sigma, genz_, workers());
  }
  const Pose& new_pose = alignment.T_map_lidar;

  begin_step(Step::map);
  threshold_.set_deviation(initial_guess.inverse() * new_pose);
  update_map(clouds.frame_downsample, new_pose);
  last_delta_ = last_pose_.inverse() * new_pose;
  last_pose_ = new_pose;
  ++poses_;
  const ScanTrajectory trajectory = constant_velocity_through(new_pose, 0.5, motion, scan);
  return first ? report_first(trajectory) : report(alignment, trajectory);
}

bool GenzIcpFrontEnd::has_moved() const {
  const double distance = (last_pose_.translation - first_pose_.translation).norm();
  return distance > kMovedThresholds * genz_.min_motion_th;
}

void GenzIcpFrontEnd::update_map(const std::vector<Eigen::Vector3d>& points,
                                 const Pose& T_map_lidar) {
  for (const Eigen::Vector3d& point : transformed(T_map_lidar, points)) map_.insert(point);
  map_.remove_far(T_map_lidar.translation);
}

}  // namespace surefoot
