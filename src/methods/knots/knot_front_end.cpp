// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan through Surefoot's own method, in add: predict the knots, register them, learn from
// them, map what they deskewed.
#include "methods/knots/knot_front_end.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/deskew.hpp"
#include "core/health.hpp"
#include "core/information.hpp"
#include "core/level.hpp"
#include "methods/knots/calibration.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// The fluctuation that lets the second scan's velocity be anything, up to a car's.
const Twist kAnyFluctuation = (Twist() << 10.0, 10.0, 2.0, 0.5, 0.5, 2.0).finished();
constexpr double kWalking = 2.0;  // [m/s] what is slower, a registration from rest finds

// [m] of the cubes that choose the points to be registered: of the first scan, before anything is
// known of the scene's scale, and at most, about the voxels of the map's coarsest grid.
constexpr double kFirstCube = 1.0, kCoarsestCube = 3.0;

/// Of those that choose the points to be mapped: a voxel takes several points of a scan.
PointChoice::Cubes cubes_of_map(const Config::Knots& config) {
  const double coarsest = 0.5 * config.finest_voxel;
  return {config.map_voxel, coarsest, coarsest};
}

/// The residuals' variance as a share of the one that was assumed (reduced chi squared).
double residual_variance(const KnotRegistration& found, const Config::Knots& config) {
  return found.rigid.weighted_squares / (config.independence * std::max(found.rigid.count, 1));
}

// What the evidence is counted from: [m], [s]; and [m/s] of who does not stand.
constexpr double kKnown = 0.01, kUsualPeriod = 0.1, kWalks = 0.2;

/// By which a scan that was seen before is known again, byte by byte.
std::uint64_t fingerprint(const std::vector<Eigen::Vector3f>& points) {
  std::uint64_t hash = points.size();
  for (const Eigen::Vector3f& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      hash = (hash ^ std::bit_cast<std::uint32_t>(p[axis])) * 0x100000001b3ULL;
    }
  }
  return hash;
}

}  // namespace

KnotFrontEnd::KnotFrontEnd(const Session& session)
    : session_(session),
      config_(session.config),
      map_(config_.knots, config_.map.radius),
      model_(config_.knots),
      map_choice_(config_.knots.map_points, cubes_of_map(config_.knots)),
      choice_(config_.knots.points, {config_.knots.map_voxel, kFirstCube, kCoarsestCube}),
      dependence_(1.0 / config_.knots.independence) {}

Estimate KnotFrontEnd::add(const PreparedScan& scan) {
  emptied_.centres.clear();
  const std::uint64_t print = fingerprint(scan.points);
  seen_again_ = print == std::exchange(last_print_, print);
  session_.begin_step(Step::downsample);
  const auto thinned = map_choice_.choose(scan, session_.workers);
  if (map_.empty()) return begin_map(scan, thinned);

  if (first_scan_) begin_motion(scan, thinned);
  const KnotEnd begin = beginning_of(scan, end_, model_, config_);
  const KnotWindow predicted = predict_knots(scan, begin, model_, config_.knots);
  KnotPoints points = sort_points(scan, choice_.choose(scan, thinned, session_.workers), predicted);
  const KnotRegistration found = register_in_attempts(points, problem(begin), predicted, usual_);
  session_.begin_step(Step::assess);
  const ScanTrajectory trajectory = found.window.trajectory(scan.start_ns, scan.end_ns);
  const Pose T_0 = predicted.trajectory().at_time(trajectory.mid_ns());
  Estimate estimate = conclude(found, trajectory, T_0, points.points.size());
  if (!estimate.trusted()) return lose(scan, thinned, predicted, begin, std::move(estimate));

  View view = look(scan, thinned, trajectory);
  judge(scan, found, begin, view, estimate);
  learn(found, begin);
  session_.begin_step(Step::map);
  if (first_scan_) {
    const DeskewedScan this_scan = std::exchange(last_scan_, {});
    map_first_scan(found.window.mean_velocity());
    last_scan_ = this_scan;
  }
  first_scan_.reset();
  integrate(std::move(view));
  last_pose_ = StampedPose{trajectory.mid_ns(), trajectory.at(0.5)};
  return publish(trajectory, std::move(estimate));
}

KnotProblem KnotFrontEnd::problem(const KnotEnd& begin) const {
  return {map_, begin.prior, model_, config_.knots, session_.workers, session_.begin_step};
}

/// What speaks against a registration, and how probably it is wrong.
void KnotFrontEnd::judge(const PreparedScan& scan, const KnotRegistration& found,
                         const KnotEnd& begin, const View& view, Estimate& estimate) {
  const Signs signs{found.misfit_of_seen(), found.unseen, views_.contradiction(view),
                    begin.prior.surprise(found.window)};
  Evidence& evidence = estimate.evidence = usual_signs_.compare(signs);
  const double sigma = std::sqrt(estimate.covariance.diagonal().head<3>().maxCoeff());
  evidence.uncertainty = strength(sigma / kKnown);
  const std::int64_t mid_ns = scan.start_ns + (scan.end_ns - scan.start_ns) / 2;
  evidence.gap = strength(seconds(mid_ns - last_pose_->stamp_ns) / kUsualPeriod);
  evidence.unconverged = found.converged ? 0.0 : 1.0;
  const double speed = model_.mean(Eigen::Quaterniond::Identity()).head<3>().norm();
  evidence.frozen = seen_again_ ? std::min(speed / kWalks, 1.0) : 0.0;

  const double hazard_now = hazard(evidence);
  estimate.wrong_probability = verdict_.add(hazard_now);
  usual_signs_.learn(signs, 1.0 - hazard_now, config_.knots.usual_rate);
}

/// What a trusted registration tells for the next scan.
void KnotFrontEnd::learn(const KnotRegistration& found, const KnotEnd& begin) {
  const Config::Knots& knots = config_.knots;
  lost_in_a_row_ = 0;
  dependence_ += knots.usual_rate * (found.dependence - dependence_);
  usual_.learn(found, first_scan_ ? 1.0 : knots.usual_rate, knots);
  model_.learn(found.window, found.covariance, begin.prior.means[1].rotation);
  finish(found.window, found.last_two);
}

Estimate KnotFrontEnd::conclude(const KnotRegistration& found, const ScanTrajectory& trajectory,
                                const Pose& T_0, std::size_t points) const {
  Estimate estimate;
  estimate.converged = found.converged;
  estimate.stages = StageReport{"registration", found.iterations, found.matches, found.rigid.rms()};
  estimate.registered_points = static_cast<int>(points);
  const Pose T_map_lidar = trajectory.at(0.5);
  Judgement judgement = judge_registration({T_0, T_map_lidar, found.matches, points},
                                           config_.knots.min_match_ratio, config_.health);
  if (!found.solved && judgement.status == Status::ok) {
    judgement = {Status::diverged, "the knots' normal equations gave no finite solution"};
  }
  const double misfit = found.misfit_of_seen();
  const double most = usual_.most_misfit_of_seen(config_.knots);
  if (misfit > most && judgement.status == Status::ok) {
    judgement = {Status::diverged, "the misfit to what the map has seen is " +
                                       std::to_string(misfit) + "; expected at most " +
                                       std::to_string(most) + ", from the last scans"};
  }
  estimate.status = judgement.status;
  estimate.message = std::move(judgement.message);
  if (judgement.status != Status::ok) return estimate;
  // The weights assumed a share of independent residuals; the covariance goes by the measured one.
  // [K22]
  const double scale = config_.knots.independence * config_.knots.covariance_scale * dependence_ *
                       residual_variance(found, config_.knots);
  estimate.covariance = calibrated(scale * found.covariance_at(trajectory.mid_ns()),
                                   found.window.mean_velocity(), model_.fluctuation());
  report_weak_directions(found.rigid, found.squared_distance, T_map_lidar, config_.health,
                         estimate);
  return estimate;
}

/// The first scan, or the first after too many lost ones: the map begins with it.
Estimate KnotFrontEnd::begin_map(const PreparedScan& scan,
                                 const std::vector<std::uint32_t>& thinned) {
  session_.begin_step(Step::map);
  Estimate estimate;
  estimate.status = Status::first_scan;
  const Pose T_map_lidar =
      last_pose_ ? end_.prior.means[1] : level_pose(scan.points, config_.level, level_);
  estimate.message = last_pose_ ? "the map begins anew at the predicted pose" : level_.message;
  if (last_pose_) ++segment_;
  if (last_pose_) estimate.covariance = unregistered_covariance(config_.health);
  const ScanTrajectory trajectory({T_map_lidar, T_map_lidar}, scan.start_ns, scan.end_ns);
  const double duration = seconds(scan.end_ns - scan.start_ns);
  end_.step = std::max(duration, kInstant) / config_.knots.segments;
  end_.stamp_ns = scan.end_ns;
  end_.prior = at_rest(T_map_lidar, end_.step);
  velocity_ = Twist::Zero();
  lost_in_a_row_ = 0;
  first_scan_ = FirstScan{scan, thinned};
  usual_ = {};
  views_.clear();
  usual_signs_ = {};
  verdict_.clear();
  integrate(look(scan, thinned, trajectory));
  last_pose_ = StampedPose{trajectory.mid_ns(), T_map_lidar};
  return publish(trajectory, std::move(estimate));
}

/// The velocity that the second scan of a map shows: both scans as measured, distorted alike, as
/// rigid bodies, from standstill to a car's speed. Zero where that cannot be told. Map axes.
Twist KnotFrontEnd::first_velocity(const PreparedScan& scan,
                                   const std::vector<std::uint32_t>& thinned) {
  const Pose& middle = last_pose_->pose;
  const std::int64_t mid_ns = scan.start_ns + (scan.end_ns - scan.start_ns) / 2;
  const double elapsed = seconds(mid_ns - last_pose_->stamp_ns);
  const KnotWindow standing{
      {middle, middle, middle}, elapsed, elapsed, last_pose_->stamp_ns, mid_ns};
  KnotPoints points;
  for (const std::uint32_t i : choice_.choose(scan, thinned, session_.workers)) {
    points.points.push_back({scan.points[i].cast<double>(), 1.0, {}});
  }
  points.begins = {0, points.points.size()};
  const KnotPrior anywhere = at_rest(middle, elapsed);
  const VelocityModel any_speed(config_.knots, kAnyFluctuation);
  const KnotProblem two_scans{map_,          anywhere,         any_speed,
                              config_.knots, session_.workers, session_.begin_step};
  const KnotRegistration found =
      register_knots(points, two_scans, standing, patient_annealing(config_.knots));
  if (!found.solved || found.matches < config_.health.min_matches) return Twist::Zero();
  return found.window.mean_velocity();
}

/// At the second scan of a map. A walker's velocity is found by the registration from rest; what is
/// faster has to be known before, and so has the first scan's distortion by it.
void KnotFrontEnd::begin_motion(const PreparedScan& scan,
                                const std::vector<std::uint32_t>& thinned) {
  const Twist velocity = first_velocity(scan, thinned);
  if (velocity.head<3>().norm() < kWalking) return;
  const Pose middle = last_pose_->pose;
  const double since = seconds(end_.stamp_ns - last_pose_->stamp_ns);
  end_.prior.means[0] = displaced(middle, (since - end_.step) * velocity);
  end_.prior.means[1] = displaced(middle, since * velocity);
  model_.begin(velocity, middle.rotation);
  map_first_scan(velocity);
}

/// The map of the first scan alone, which was made as if the sensor had stood.
void KnotFrontEnd::map_first_scan(const Twist& velocity) {
  const auto& [first, thinned] = *first_scan_;
  const double half = 0.5 * seconds(first.end_ns - first.start_ns);
  const ScanTrajectory moving(
      {displaced(last_pose_->pose, -half * velocity), displaced(last_pose_->pose, half * velocity)},
      first.start_ns, first.end_ns);
  map_.clear();
  views_.clear();
  integrate(look(first, thinned, moving));
}

/// A scan that could not be registered: the pose is the prediction and the map stays, until too
/// many in a row show that the map is no longer what the sensor sees.
Estimate KnotFrontEnd::lose(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                            const KnotWindow& predicted, const KnotEnd& begin, Estimate estimate) {
  finish(predicted, begin.prior.information);
  if (++lost_in_a_row_ > config_.health.restart_after) {
    map_.clear();
    return begin_map(scan, thinned);
  }
  estimate.covariance = unregistered_covariance(config_.health);
  const ScanTrajectory trajectory = predicted.trajectory(scan.start_ns, scan.end_ns);
  last_scan_ = {deskew(scan, trajectory, session_.workers), scan.intensities};
  return publish(trajectory, std::move(estimate));
}

/// The last two knots are where the next scan begins; not all that is known of them is relied on.
void KnotFrontEnd::finish(const KnotWindow& window, const Matrix12& information) {
  const std::size_t last = window.knots.size() - 1;
  // [K9]
  end_ = {{{window.knots[last - 1], window.knots[last]}, config_.knots.memory * information},
          window.end_ns,
          window.duration(last - 1)};
  velocity_ = rotated(window.knots[last].rotation.conjugate(), window.mean_velocity());
}

/// Deskews a scan, and puts what it saw into the map's frame.
View KnotFrontEnd::look(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                        const ScanTrajectory& trajectory) {
  const Pose middle = trajectory.at(0.5);
  last_scan_ = {deskew(scan, trajectory, session_.workers), scan.intensities};
  std::vector<Eigen::Vector3d> points;
  points.reserve(thinned.size());
  for (const std::uint32_t i : thinned) {
    points.push_back(middle * last_scan_.points[i].cast<double>());
  }
  return {middle.translation, std::move(points)};
}

void KnotFrontEnd::integrate(View view) {
  map_.remove_far(view.sensor);
  emptied_ = {config_.knots.finest_voxel,
              map_.insert(view.points, view.sensor, session_.workers, &view.beams)};
  views_.add(std::move(view));
}

Estimate KnotFrontEnd::publish(const ScanTrajectory& trajectory, Estimate estimate) const {
  estimate.trajectory = trajectory;
  estimate.twist = velocity_;
  estimate.segment = segment_;
  return estimate;
}

}  // namespace surefoot
