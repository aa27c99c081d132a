// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan through the paper's front-end: Algorithm 1 from top to bottom, in add.
#include "methods/paper/paper_front_end.hpp"

#include <utility>

#include "config/method.hpp"
#include "core/deskew.hpp"
#include "core/health.hpp"
#include "core/information.hpp"
#include "core/level.hpp"
#include "methods/paper/assessment.hpp"
#include "methods/paper/thin_scan.hpp"

namespace surefoot {

namespace {

Source make_source(ThinnedScan thinned) { return {std::move(thinned.source_points), {}, {}, {}}; }

/// The predicted motion, moved rigidly so that it passes through `T_map_lidar` at mid-scan.
ScanTrajectory through_pose(const ScanTrajectory& predicted, const Pose& T_map_lidar) {
  return predicted.moved(T_map_lidar * predicted.at(0.5).inverse());
}

}  // namespace

PaperFrontEnd::PaperFrontEnd(const Session& session)
    : session_(session),
      config_(session.config),
      paper_(own_parameters<PaperParameters>(session.config)),
      workers_(session.workers),
      map_(paper_.map, max_search_radius(paper_.registration)) {}

/// Algorithm 1. Computes first; what outlives the scan changes in the last lines.
Estimate PaperFrontEnd::add(const PreparedScan& scan) {
  session_.begin_step(Step::deskew);
  const ScanTrajectory predicted = predict(scan);                 // lines 1-6
  last_scan_ = {at_mid_scan(scan, predicted), scan.intensities};  // line 7
  session_.begin_step(Step::downsample);
  ThinnedScan thinned = thin_scan(last_scan_.points, paper_.downsample, session_.workers);
  if (map_.empty()) return begin_map(thinned.map_points, predicted);

  Source source = make_source(thinned);
  const Pose T_0 = predicted.at(0.5);  // line 8
  const Registration registration =
      register_scan(source, map_, T_0, paper_, config_.health.min_matches, workers_,
                    session_.begin_step);  // lines 9-30
  session_.begin_step(Step::assess);
  Estimate estimate = conclude(registration, T_0, source);
  session_.begin_step(Step::map);
  if (!estimate.trusted()) {
    return lose(thinned.map_points, predicted, std::move(estimate));
  }
  lost_in_a_row_ = 0;
  prediction_error_.add(T_0, registration.T_map_lidar);
  estimate.covariance += prediction_error_.deskew_covariance();
  const ScanTrajectory trajectory = through_pose(predicted, registration.T_map_lidar);
  motion_ = next_motion(motion_, {trajectory.mid_ns(), registration.T_map_lidar});
  integrate(thinned.map_points, registration.T_map_lidar);  // line 31
  return publish(trajectory, std::move(estimate));          // line 32
}

/// Lines 1-6.
ScanTrajectory PaperFrontEnd::predict(const PreparedScan& scan) const {
  const MotionPrior prior =
      predict_motion(motion_, scan.start_ns, scan.end_ns, config_.motion_prior.max_extrapolation);
  return predict_trajectory(prior, scan.start_ns, scan.end_ns, paper_.deskew);
}

/// Line 7.
std::vector<Eigen::Vector3f> PaperFrontEnd::at_mid_scan(const PreparedScan& scan,
                                                        const ScanTrajectory& predicted) const {
  if (paper_.deskew.mode == DeskewMode::none) return scan.points;
  return deskew(scan, predicted, workers_);
}

/// What a registration that started at T_0 is worth.
Estimate PaperFrontEnd::conclude(const Registration& registration, const Pose& T_0,
                                 Source& source) const {
  Estimate estimate;
  estimate.converged = registration.converged;
  estimate.stages = registration.stages(paper_.registration.mode);
  estimate.registered_points = static_cast<int>(source.points.size());
  Judgement judgement = judge_with_share(
      {T_0, registration.T_map_lidar, registration.matches, source.points.size()}, config_.health);
  estimate.status = judgement.status;
  estimate.message = std::move(judgement.message);
  if (judgement.status == Status::ok) {
    assess(source, map_, registration.T_map_lidar, paper_.vertical, config_.health, workers_,
           estimate);
  }
  return estimate;
}

/// The first scan, or the first after too many lost ones: the map begins with it.
Estimate PaperFrontEnd::begin_map(const std::vector<Eigen::Vector3f>& points,
                                  const ScanTrajectory& predicted) {
  session_.begin_step(Step::map);
  const Pose T_map_lidar = started_ ? predicted.at(0.5) : level_pose(points, config_.level, level_);
  const ScanTrajectory trajectory = through_pose(predicted, T_map_lidar);
  Estimate estimate;
  estimate.status = Status::first_scan;
  estimate.message = started_ ? "the map begins anew at the predicted pose" : level_.message;
  if (started_) {
    ++segment_;
    estimate.covariance = unregistered_covariance(config_.health);
  }
  started_ = true;
  lost_in_a_row_ = 0;
  motion_ = {{trajectory.mid_ns(), T_map_lidar}, Twist::Zero()};
  integrate(points, T_map_lidar);
  return publish(trajectory, std::move(estimate));
}

/// A scan that could not be registered: the pose is the prediction and the map stays, until too
/// many in a row show that the map is no longer what the sensor sees.
Estimate PaperFrontEnd::lose(const std::vector<Eigen::Vector3f>& points,
                             const ScanTrajectory& predicted, Estimate estimate) {
  if (++lost_in_a_row_ > config_.health.restart_after) {
    map_.clear();
    return begin_map(points, predicted);
  }
  estimate.covariance = unregistered_covariance(config_.health);
  return publish(predicted, std::move(estimate));
}

void PaperFrontEnd::integrate(const std::vector<Eigen::Vector3f>& points, const Pose& T_map_lidar) {
  map_.remove_far(T_map_lidar.translation, config_.map.radius);
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  for (const Eigen::Vector3f& point : points) {
    map_.insert(R * point.cast<double>() + T_map_lidar.translation);
  }
}

std::optional<StampedPose> PaperFrontEnd::last_pose() const {
  if (!started_) return std::nullopt;
  return motion_.last;
}

/// The estimate of a pose within this scan.
Estimate PaperFrontEnd::publish(const ScanTrajectory& trajectory, Estimate estimate) const {
  estimate.trajectory = trajectory;
  estimate.twist = motion_.velocity;
  estimate.segment = segment_;
  return estimate;
}

}  // namespace surefoot
