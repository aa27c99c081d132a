// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/known_front_end.hpp"

#include <utility>

#include "core/deskew.hpp"
#include "core/information.hpp"

namespace surefoot {

KnownFrontEnd::KnownFrontEnd(const Session& session, std::shared_ptr<const KnownAnswers> known)
    : session_(session),
      known_(std::move(known)),
      map_(session.config.knots, session.config.map.radius),
      choice_(map_choice(session.config.knots)) {}

Estimate KnownFrontEnd::add(const PreparedScan& scan) {
  const std::vector<Estimate>& all = known_->estimates;
  const std::int64_t mid_ns = scan.mid_ns();
  while (next_ < all.size() && all[next_].trajectory.mid_ns() < mid_ns) ++next_;
  emptied_.centres.clear();
  if (next_ == all.size() || all[next_].trajectory.mid_ns() != mid_ns) {
    Estimate unknown;
    unknown.message = "none of the scans that are known";
    unknown.covariance = unregistered_covariance(session_.config.health);
    unknown.trajectory = ScanTrajectory(last_pose_.value_or(StampedPose{}).pose, mid_ns);
    last_scan_ = {scan.points, scan.intensities};
    return unknown;
  }
  const Estimate& estimate = all[next_++];
  const Pose middle = estimate.trajectory.at(0.5);
  if (estimate.segment != std::exchange(segment_, estimate.segment)) map_.clear();
  last_scan_ = {deskew(scan, estimate.trajectory, session_.workers), scan.intensities};
  velocity_ = estimate.twist;
  if (!estimate.trusted()) return estimate;
  last_pose_ = StampedPose{mid_ns, middle};
  map(scan, middle);
  return estimate;
}

/// As the odometry maps what it has registered.
void KnownFrontEnd::map(const PreparedScan& scan, const Pose& middle) {
  std::vector<Eigen::Vector3d> points;
  for (const std::uint32_t i : choice_.choose(scan, session_.workers)) {
    points.push_back(middle * last_scan_.points[i].cast<double>());
  }
  map_.remove_far(middle.translation);
  emptied_ = map_.insert({middle.translation, std::move(points)}, session_.workers);
}

}  // namespace surefoot
