// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_front_end.hpp"

#include <algorithm>

#include "config/method.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {

constexpr int kRigidScans = 2;  // the first ones, whose motion nothing tells

std::string refusal(const CtIcpResult& result, const CtIcpChange& change) {
  if (!result.success) {
    return std::to_string(result.residuals) + " of " + std::to_string(result.keypoints) +
           " keypoints have a plane in the map; the prediction stands, where the original ends";
  }
  return "moved " + std::to_string(change.distance) + " m and turned " +
         std::to_string(std::max(change.ego_orientation, change.relative_orientation)) +
         " deg in one scan; the prediction stands, where the original ends";
}

}  // namespace

CtIcpFrontEnd::CtIcpFrontEnd(const Session& session)
    : BaselineFrontEnd(session),
      ct_(own_parameters<CtIcpParameters>(session.config)),
      sampler_(ct_),
      map_({ct_.resolution, ct_.max_num_points, ct_.min_distance_between_points, ct_.max_distance,
            cell_rounding(ct_)}),
      neighbours_(map_, ct_.default_radius, static_cast<std::size_t>(ct_.max_num_neighbors)),
      caution_(ct_) {}

Estimate CtIcpFrontEnd::add(const PreparedScan& scan) {
  if (!started()) last_.begin = last_.end = first_pose(scan.points);
  begin_step(Step::downsample);
  const std::vector<CtIcpPoint> points =
      sampler_.thin(scan, scans_ < kRigidScans, starting() ? ct_.init_voxel_size : ct_.voxel_size);

  begin_step(Step::search);
  CtIcpFrame frame = predict();
  const bool first = map_.empty();
  Registered registered;
  if (!first) registered = register_scan(points, frame);
  const bool used = first || ct_.robust_registration || registered.plausible;
  if (!first && used) frame = registered.result.frame;

  begin_step(Step::map);
  if (used) update_map(points, frame, first || admit(registered));
  second_ = last_;
  last_ = frame;
  ++scans_;

  begin_step(Step::deskew);
  const ScanTrajectory trajectory = finish(scan, frame);
  if (first) return report_first(trajectory);
  const CtIcpResult& result = registered.result;
  Alignment alignment;
  alignment.T_map_lidar = trajectory.at(0.5);
  alignment.points = ct_.max_num_residuals > 0 ? std::min(ct_.max_num_residuals, result.keypoints)
                                               : result.keypoints;
  alignment.iterations = result.iterations;
  alignment.converged = result.converged;
  alignment.equations = result.equations;
  if (!used) alignment.refusal = refusal(result, registered.change);
  return report(alignment, trajectory);
}

/// Constant velocity of the first and of the last poses each, or where the scan before ended.
CtIcpFrame CtIcpFrontEnd::predict() const {
  if (scans_ < kRigidScans) return {last_.end, last_.end};
  const bool third = scans_ == kRigidScans;  // the scan before was rigid
  if (ct_.initialization == CtIcpInitialization::none) {
    const Pose& pose = third ? last_.begin : last_.end;
    return {pose, pose};
  }
  const Pose end = last_.end * second_.end.inverse() * last_.end;
  if (third) return {last_.end, end};
  return {last_.begin * second_.begin.inverse() * last_.begin, end};
}

CtIcpFrontEnd::Registered CtIcpFrontEnd::register_scan(const std::vector<CtIcpPoint>& points,
                                                       const CtIcpFrame& prediction) {
  const int most = ct_.robust_registration ? ct_.robust_num_attempts : 1;
  CtIcpEffort effort = first_effort(ct_, starting(), caution_.level());
  Registered registered;
  while (true) {
    const std::vector<CtIcpPoint> keypoints =
        sampler_.keypoints(points, effort.sample_voxel_size, !starting());
    registered.result =
        register_ct_icp(keypoints, neighbours_, prediction, last_, effort.config, workers());
    registered.change = change_of(last_, registered.result.frame);
    // The original does not tell its judgement the level, and so tries all when a scan turns fast.
    const int level = ct_.robust_bookkeeping ? effort.level : 0;
    registered.plausible = is_plausible(registered.result, registered.change, level, ct_);
    ++registered.attempts;
    if (registered.plausible || registered.attempts >= most) return registered;
    effort.increase();
  }
}

/// Whether a scan may enter the map.
bool CtIcpFrontEnd::admit(const Registered& registered) {
  if (ct_.robust_registration) {
    return caution_.admit(registered.result, registered.change, registered.attempts);
  }
  return registered.change.ego_orientation <= ct_.insertion_ego_rotation_threshold ||
         skipped_ > ct_.insertion_threshold_frames_skipped;
}

void CtIcpFrontEnd::update_map(const std::vector<CtIcpPoint>& points, const CtIcpFrame& frame,
                               bool admitted) {
  map_.remove_far(frame.end.translation);
  skipped_ = admitted ? 0 : skipped_ + 1;
  if (!admitted) return;
  const CtIcpMotion motion(frame);
  for (const CtIcpPoint& point : points) map_.insert(motion.place(point.alpha, point.point));
}

/// The scan's trajectory, after keeping its points at mid-scan. A scan without times has one pose.
ScanTrajectory CtIcpFrontEnd::finish(const PreparedScan& scan, const CtIcpFrame& frame) {
  const CtIcpMotion motion(scan.taus.empty() ? CtIcpFrame{frame.end, frame.end} : frame);
  const Pose mid = motion.at(0.5);
  const Pose to_mid = mid.inverse();
  std::vector<Eigen::Vector3d> points(scan.points.size());
  workers().for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double alpha = scan.taus.empty() ? 0.5 : static_cast<double>(scan.taus[i]);
      points[i] = to_mid * motion.place(alpha, scan.points[i].cast<double>());
    }
  });
  keep_scan(to_float(points), scan);
  return ScanTrajectory({motion.at(0.0), mid, motion.at(1.0)}, scan.start_ns, scan.end_ns);
}

}  // namespace surefoot
