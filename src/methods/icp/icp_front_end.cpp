// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/icp/icp_front_end.hpp"

#include <cmath>

#include "config/method.hpp"
#include "methods/icp/icp.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {

VoxelMap::Options map_options(const IcpParameters& config, double radius) {
  const double spacing = config.voxel_size / std::sqrt(config.max_points_per_voxel);
  return {config.voxel_size, config.max_points_per_voxel, spacing, radius};
}

}  // namespace

IcpFrontEnd::IcpFrontEnd(const Session& session)
    : BaselineFrontEnd(session),
      icp_(own_parameters<IcpParameters>(session.config)),
      map_(map_options(icp_, session.config.preprocess.max_range)) {}

Estimate IcpFrontEnd::add(const PreparedScan& scan) {
  begin_step(Step::search);
  keep_scan(scan.points, scan);
  const std::vector<Eigen::Vector3d> points = deskew_to(0.5, scan, Twist::Zero(), workers());
  if (!started()) {
    last_pose_ = first_pose(scan.points);
    set_target(points, last_pose_);
    return report_first(constant_velocity_through(last_pose_, 0.5, Twist::Zero(), scan));
  }
  const NearestTarget nearest = [this](const Eigen::Vector3d& point, double max_distance) {
    return icp_.target == IcpTarget::map ? map_.nearest(point, max_distance)
                                         : last_scan_.nearest(point, max_distance);
  };
  const Pose initial_guess = icp_.constant_velocity ? last_pose_ * last_delta_ : last_pose_;
  const Alignment alignment = icp(points, nearest, initial_guess, icp_, workers());

  begin_step(Step::map);
  last_delta_ = last_pose_.inverse() * alignment.T_map_lidar;
  last_pose_ = alignment.T_map_lidar;
  set_target(points, last_pose_);
  return report(alignment, constant_velocity_through(last_pose_, 0.5, Twist::Zero(), scan));
}

void IcpFrontEnd::set_target(const std::vector<Eigen::Vector3d>& points, const Pose& T_map_lidar) {
  std::vector<Eigen::Vector3d> placed = transformed(T_map_lidar, points);
  if (icp_.target == IcpTarget::scan) {
    last_scan_ = KdTree(std::move(placed));
    return;
  }
  for (const Eigen::Vector3d& point : placed) map_.insert(point);
  map_.remove_far(T_map_lidar.translation);
}

std::vector<Eigen::Vector3d> IcpFrontEnd::local_map() const {
  return icp_.target == IcpTarget::map ? map_.points() : last_scan_.points();
}

}  // namespace surefoot
