// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan through the paper's front-end: Algorithm 1 from top to bottom, in State::process.
#include "surefoot/odometry.hpp"

#include <utility>

#include "odometry/deskew.hpp"
#include "odometry/downsample.hpp"
#include "odometry/health.hpp"
#include "odometry/information.hpp"
#include "odometry/level.hpp"
#include "odometry/local_map.hpp"
#include "odometry/motion_prior.hpp"
#include "odometry/parallel.hpp"
#include "odometry/prediction_error.hpp"
#include "odometry/preprocess.hpp"
#include "odometry/registration.hpp"

namespace surefoot {

namespace {

const Config& validated(const Config& config) {
  validate(config);
  return config;
}

}  // namespace

/// Everything that outlives a scan.
struct Odometry::State {
  State(const Config& configuration, int threads, const Pose& T_world_start)
      : config(validated(configuration)),
        workers(threads),
        T_world_map(T_world_start),
        map(config.map, max_search_radius(config.registration)) {}

  const Config config;
  Workers workers;
  Pose T_world_map;
  StepObserver begin_step = [](Step) {};

  LocalMap map;
  Motion motion;
  LevelReport level;
  DeskewedScan last_scan;
  PredictionError prediction_error;
  bool started = false;
  int lost_in_a_row = 0;

  [[nodiscard]] std::string objection(const PreparedScan& scan) const;
  [[nodiscard]] Estimate reject(const PreparedScan& scan, std::string reason) const;
  Estimate process(const PreparedScan& scan);
  [[nodiscard]] ScanTrajectory predict(const PreparedScan& scan) const;
  [[nodiscard]] Estimate conclude(const Registration& registration, const Pose& T_0,
                                  Source& source) const;
  Estimate begin_map(const std::vector<Eigen::Vector3f>& points, const ScanTrajectory& predicted);
  Estimate lose(const std::vector<Eigen::Vector3f>& points, const ScanTrajectory& predicted,
                Estimate estimate);
  void integrate(const std::vector<Eigen::Vector3f>& points, const Pose& T_map_lidar);
  [[nodiscard]] Estimate publish(const ScanTrajectory& trajectory, Estimate estimate) const;
};

namespace {

Source make_source(ThinnedScan thinned) { return {std::move(thinned.source_points), {}, {}, {}}; }

/// The predicted motion, moved rigidly so that it passes through `T_map_lidar` at mid-scan.
ScanTrajectory through_pose(const ScanTrajectory& predicted, const Pose& T_map_lidar) {
  return predicted.moved(T_map_lidar * predicted.at(0.5).inverse());
}

}  // namespace

Odometry::Odometry(const Config& config, int threads, const Pose& T_world_start)
    : state_(std::make_unique<State>(config, threads, T_world_start)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

Estimate Odometry::add_scan(const Scan& scan) {
  state_->begin_step(Step::preprocess);
  const PreparedScan prepared = preprocess(scan, state_->config.preprocess);
  const int points = static_cast<int>(prepared.points.size());
  std::string objection = state_->objection(prepared);
  Estimate estimate = objection.empty() ? state_->process(prepared)
                                        : state_->reject(prepared, std::move(objection));
  estimate.points = points;
  state_->begin_step(Step::idle);
  return estimate;
}

/// Algorithm 1. Computes first; what outlives the scan changes in the last lines.
Estimate Odometry::State::process(const PreparedScan& scan) {
  begin_step(Step::deskew);
  const ScanTrajectory predicted = predict(scan);                                   // lines 1-6
  last_scan = {deskew(scan, predicted, config.deskew, workers), scan.intensities};  // line 7
  begin_step(Step::downsample);
  ThinnedScan thinned = thin_scan(last_scan.points, config.downsample);
  if (map.empty()) return begin_map(thinned.map_points, predicted);

  Source source = make_source(thinned);
  const Pose T_0 = predicted.at(0.5);  // line 8
  const Registration registration =
      register_scan(source, map, T_0, config, workers, begin_step);  // lines 9-30
  begin_step(Step::assess);
  Estimate estimate = conclude(registration, T_0, source);
  begin_step(Step::map);
  if (!estimate.trusted()) {
    return lose(thinned.map_points, predicted, std::move(estimate));
  }
  lost_in_a_row = 0;
  prediction_error.add(T_0, registration.T_map_lidar);
  estimate.covariance += prediction_error.deskew_covariance();
  const ScanTrajectory trajectory = through_pose(predicted, registration.T_map_lidar);
  motion = next_motion(motion, {trajectory.mid_ns(), registration.T_map_lidar});
  integrate(thinned.map_points, registration.T_map_lidar);  // line 31
  return publish(trajectory, std::move(estimate));          // line 32
}

/// Lines 1-6.
ScanTrajectory Odometry::State::predict(const PreparedScan& scan) const {
  const MotionPrior prior =
      predict_motion(motion, scan.start_ns, scan.end_ns, config.motion_prior.max_extrapolation);
  return predict_trajectory(prior, scan.start_ns, scan.end_ns, config.deskew);
}

/// What a registration that started at T_0 is worth.
Estimate Odometry::State::conclude(const Registration& registration, const Pose& T_0,
                                   Source& source) const {
  Estimate estimate;
  estimate.converged = registration.converged;
  estimate.horizontal = registration.horizontal;
  estimate.vertical = registration.vertical;
  estimate.registered_points = static_cast<int>(source.points.size());
  Verdict verdict = judge_registration(registration, T_0, source.points.size(), config.health);
  estimate.status = verdict.status;
  estimate.message = std::move(verdict.message);
  if (verdict.status == Status::ok) {
    assess(source, map, registration.T_map_lidar, config, workers, estimate);
  }
  return estimate;
}

std::string Odometry::State::objection(const PreparedScan& scan) const {
  if (!scan.rejection.empty()) return scan.rejection;
  const std::int64_t mid_ns = scan.start_ns + (scan.end_ns - scan.start_ns) / 2;
  if (!started || mid_ns > motion.last.stamp_ns) return {};
  return "scan's mid-scan stamp " + std::to_string(mid_ns) + " ns is not after the last pose's " +
         std::to_string(motion.last.stamp_ns) + " ns";
}

/// The last pose again, as something that is not known.
Estimate Odometry::State::reject(const PreparedScan& scan, std::string reason) const {
  Estimate estimate;
  estimate.status = Status::rejected;
  estimate.message = std::move(reason);
  estimate.covariance = unregistered_covariance(config.health);
  const std::int64_t mid_ns = scan.start_ns + (scan.end_ns - scan.start_ns) / 2;
  return publish(ScanTrajectory(motion.last.pose, mid_ns), std::move(estimate));
}

/// The first scan, or the first after too many lost ones: the map begins with it.
Estimate Odometry::State::begin_map(const std::vector<Eigen::Vector3f>& points,
                                    const ScanTrajectory& predicted) {
  begin_step(Step::map);
  const Pose T_map_lidar = started ? predicted.at(0.5) : level_pose(points, config.level, level);
  const ScanTrajectory trajectory = through_pose(predicted, T_map_lidar);
  Estimate estimate;
  estimate.status = Status::first_scan;
  estimate.message = started ? "the map begins anew at the predicted pose" : level.message;
  started = true;
  lost_in_a_row = 0;
  motion = {{trajectory.mid_ns(), T_map_lidar}, Twist::Zero()};
  integrate(points, T_map_lidar);
  return publish(trajectory, std::move(estimate));
}

/// A scan that could not be registered: the pose is the prediction and the map stays, until too
/// many in a row show that the map is no longer what the sensor sees.
Estimate Odometry::State::lose(const std::vector<Eigen::Vector3f>& points,
                               const ScanTrajectory& predicted, Estimate estimate) {
  if (++lost_in_a_row > config.health.restart_after) {
    map.clear();
    return begin_map(points, predicted);
  }
  estimate.covariance = unregistered_covariance(config.health);
  return publish(predicted, std::move(estimate));
}

void Odometry::State::integrate(const std::vector<Eigen::Vector3f>& points,
                                const Pose& T_map_lidar) {
  map.remove_far(T_map_lidar.translation);
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  for (const Eigen::Vector3f& point : points) {
    map.insert(R * point.cast<double>() + T_map_lidar.translation);
  }
}

/// The estimate in the caller's world.
Estimate Odometry::State::publish(const ScanTrajectory& trajectory, Estimate estimate) const {
  estimate.stamp_ns = trajectory.mid_ns();
  estimate.trajectory = trajectory.moved(T_world_map);
  estimate.T_map_lidar = estimate.trajectory.at(0.5);
  estimate.twist = motion.velocity;
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
      T_world_map.rotation.toRotationMatrix();
  estimate.covariance = turn * estimate.covariance * turn.transpose();
  for (DegenerateDirection& weak : estimate.degenerate) weak.direction = turn * weak.direction;
  return estimate;
}

const Config& Odometry::config() const { return state_->config; }

const LevelReport& Odometry::level() const { return state_->level; }

const DeskewedScan& Odometry::deskewed_scan() const { return state_->last_scan; }

std::vector<Eigen::Vector3d> Odometry::local_map() const {
  std::vector<Eigen::Vector3d> points = state_->map.points();
  for (Eigen::Vector3d& point : points) point = state_->T_world_map * point;
  return points;
}

void Odometry::set_step_observer(std::function<void(Step)> observer) {
  state_->begin_step = observer ? std::move(observer) : [](Step) {};
}

}  // namespace surefoot
