// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the front-end does with a map's first two scans, of whose motion nothing is known yet.
// docs/method.md, "The second scan".
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/health.hpp"
#include "core/information.hpp"
#include "core/level.hpp"
#include "geometry/se3.hpp"
#include "methods/knots/knot_attempts.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// The fluctuation that lets the second scan's velocity be anything, up to a car's.
const Twist kAnyFluctuation = (Twist() << 10.0, 10.0, 2.0, 0.5, 0.5, 2.0).finished();
constexpr double kWalking = 2.0;  // [m/s] what is slower, a registration from rest finds

// A faster start than a walker's is believed if so many times less disagrees. Over open ground,
// where a direction is not held, any speed fits about as well: 1.12 times at most, of 47 starts on
// playgrounds. Where all are held, false ones of walkers fitted 1.04 times as well at most, one of
// who leaps 1.07, and true ones 1.09 (a corridor) and 1.33 times (KITTI).
constexpr double kClearlyFaster = 1.2, kFasterAndHeld = 1.08;

// [rad/s] Who turns slower is found from rest as well; from there a faster turn is held back by
// half, and with it what is mapped first bends. A turn is believed that disagrees as much, as long
// as planes and poles hold the scan. Among clouds it fits nearly as well some degrees off: on
// hilltops, in forests and over a foyer 0.94 to 1.01 times, where a bent first scan left no planes
// 0.36 to 0.63 times; there it has to be clearly better.
constexpr double kTurning = 0.1;
constexpr double kAsGood = 1.1;
constexpr int kTurnRounds = 3;  // the two scans' turns approach the truth step by step

constexpr double kVague = 0.3;  // [s] the first scan's place is as vague as after walking so long

// A LiDAR that is tilted less is taken to be upright: the ground where it begins may slope.
constexpr double kUpright = 10.0 * std::numbers::pi / 180.0;

/// R_lidar_carrier of who begins on level ground.
Eigen::Quaterniond mount_of(const Pose& T_map_lidar) {
  const Eigen::Quaterniond& R = T_map_lidar.rotation;
  const Eigen::Quaterniond level(
      Eigen::AngleAxisd(roll_pitch_yaw(R).z(), Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond mount = R.conjugate() * level;
  const double tilt = mount.angularDistance(Eigen::Quaterniond::Identity());
  return tilt < kUpright ? Eigen::Quaterniond::Identity() : mount;
}

double speed(const Twist& velocity) { return velocity.head<3>().norm(); }

}  // namespace

/// Where a map begins. After a search in vain its tilt is anyone's guess, and it is made level
/// again.
Pose KnotFrontEnd::beginning_pose(const PreparedScan& scan) {
  if (!last_pose_) return level_pose(scan.points, config_.level, level_);
  const Pose& predicted = end_.prior.means[1];
  if (!search_ || config_.level.mode == LevelMode::none) return predicted;
  LevelReport again;
  const Pose level = level_pose(scan.points, config_.level, again);
  return {upright(predicted).rotation * upright(level).rotation.inverse() * level.rotation,
          predicted.translation};
}

/// The first scan, or the first after too many lost ones: the map begins with it.
Estimate KnotFrontEnd::begin_map(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  session_.begin_step(Step::map);
  Estimate estimate;
  estimate.status = Status::first_scan;
  const Pose T_map_lidar = beginning_pose(scan);
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
  agreed_ = 1;
  search_.reset();
  clear_map();
  first_scan_ = FirstScan{scan, thinned.points};
  usual_ = {};
  usual_signs_ = {};
  sweep_direction_.begin(sweep_axis(scan));
  forget_verdicts();
  integrate(look(thinned, trajectory));
  last_pose_ = StampedPose{trajectory.mid_ns(), T_map_lidar};
  mount_ = mount_of(T_map_lidar);
  weak_of_late_.clear();
  way_.clear();
  way_.add(carrier_of(T_map_lidar, mount_));
  held_ns_ = trajectory.mid_ns();
  return publish(trajectory, std::move(estimate));
}

/// The velocity that the second scan of a map shows: both scans as measured, distorted alike, as
/// rigid bodies, from standstill to a car's speed. Zero where that cannot be told. Map axes.
Twist KnotFrontEnd::first_velocity(const ScanPart& thinned) {
  const Pose& middle = last_pose_->pose;
  const std::int64_t mid_ns = thinned.scan.mid_ns();
  const double elapsed = seconds(mid_ns - last_pose_->stamp_ns);
  const KnotWindow standing{
      {middle, middle, middle}, elapsed, elapsed, last_pose_->stamp_ns, mid_ns};
  KnotPoints points;
  for (const std::uint32_t i : choose(thinned)) {
    points.points.push_back({thinned.scan.points[i].cast<double>(), 1.0, {}});
  }
  points.begins = {0, points.points.size()};
  const KnotPrior anywhere = at_rest(middle, elapsed);
  const VelocityModel any_speed(config_.knots, kAnyFluctuation);
  const KnotProblem two_scans{map_.surfels(), anywhere,         any_speed,
                              config_.knots,  session_.workers, session_.begin_step};
  const KnotRegistration found =
      register_knots(points, two_scans, standing, patient_annealing(config_.knots));
  if (!found.solved || found.matches < config_.health.min_matches) return Twist::Zero();
  return found.window.mean_velocity();
}

/// The first scan at a velocity, about where it was taken to be.
KnotFrontEnd::Beginning KnotFrontEnd::beginning_at(const Twist& velocity) const {
  const Pose& middle = last_pose_->pose;
  const double half = 0.5 * seconds(first_scan_->scan.end_ns - first_scan_->scan.start_ns);
  Beginning beginning{{{displaced(middle, -half * velocity), displaced(middle, half * velocity)},
                       first_scan_->scan.start_ns,
                       first_scan_->scan.end_ns},
                      end_,
                      model_,
                      {}};
  if (velocity.isZero()) return beginning;
  const double since = seconds(end_.stamp_ns - last_pose_->stamp_ns);
  beginning.end.prior.means[0] = displaced(middle, (since - end_.step) * velocity);
  beginning.end.prior.means[1] = displaced(middle, since * velocity);
  beginning.model.begin(velocity, middle.rotation);
  return beginning;
}

/// The second scan of a map: from rest, which finds a walker's velocity, or turning, or from a
/// faster start, if it fits as well or clearly better there.
KnotFrontEnd::Registered KnotFrontEnd::register_second(const ScanPart& thinned) {
  const Twist fast = first_velocity(thinned);
  Beginning best = registered_on(beginning_at(Twist::Zero()), 1, thinned);
  if (std::abs(fast[5]) >= kTurning) {
    const double times_less = firmness(best.second.found) > 0.0 ? 1.0 / kAsGood : kClearlyFaster;
    const Twist turn = fast[5] * Twist::Unit(5);
    Beginning turning = registered_on(beginning_at(turn), kTurnRounds, thinned);
    if (is_better(turning.second, best.second, times_less)) best = std::move(turning);
  }
  if (speed(fast) >= kWalking) {
    const bool walks = speed(best.second.found.window.mean_velocity()) < kWalking;
    Beginning faster = registered_on(beginning_at(fast), 1, thinned);
    const bool held = faster.second.estimate.degenerate.empty();
    const double times_less = !walks ? 1.0 : held ? kFasterAndHeld : kClearlyFaster;
    if (is_better(faster.second, best.second, times_less)) best = std::move(faster);
  }
  take(best);
  return std::move(best.second);
}

/// Whether one start led to a registration of which so many times less disagrees than of another's.
bool KnotFrontEnd::is_better(const Registered& one, const Registered& other,
                             double times_less) const {
  if (!one.estimate.trusted() || !other.estimate.trusted()) return one.estimate.trusted();
  return times_less * disagreement_of(one) < disagreement_of(other);
}

/// The second scan on a map of the first, then the first on a map of the second, and the second
/// again, `rounds` times: a gait swings, and what the one scan was bent by the other was not.
KnotFrontEnd::Beginning KnotFrontEnd::registered_on(Beginning beginning, int rounds,
                                                    const ScanPart& thinned) {
  take(beginning);
  beginning.second = register_next(thinned);
  for (int round = 0; round < rounds && beginning.second.estimate.trusted(); ++round) {
    std::optional<Beginning> turn = turned(beginning, thinned);
    if (!turn) break;
    take(*turn);
    turn->second = register_next(thinned);
    if (!turn->second.estimate.trusted()) break;
    beginning = std::move(*turn);
  }
  return beginning;
}

/// The first scan's motion as a map of the second shows it. Its middle stays where it is; a gait's
/// swing in the second is not the first one's.
std::optional<KnotFrontEnd::Beginning> KnotFrontEnd::turned(const Beginning& beginning,
                                                            const ScanPart& thinned) {
  clear_map();
  integrate(look(thinned, beginning.second.trajectory));
  Twist velocity = beginning.second.found.window.mean_velocity();
  velocity.segment<2>(3).setZero();
  const PreparedScan& first = first_scan_->scan;
  const Pose from = beginning_at(velocity).first.at(0.0);
  const KnotEnd begin{{{displaced(from, -end_.step * velocity), from},
                       at_rest(from, end_.step, kVague).information},
                      std::min(first.start_ns, first.end_ns - kInstantNs),
                      end_.step};
  const KnotWindow predicted =
      predict_knots(first, begin, model_, config_.knots).at_velocity(velocity);
  KnotPoints points = sort_points(first, choose(first_scan_->thinned()), predicted);
  const KnotRegistration found =
      register_knots(points, problem(begin), predicted, usual_annealing(config_.knots));
  if (!found.solved || found.matches < config_.health.min_matches) return std::nullopt;

  const ScanTrajectory motion = found.window.trajectory(first.start_ns, first.end_ns);
  const Pose fix = last_pose_->pose * motion.at(0.5).inverse();
  Beginning result{motion.moved(fix), end_, model_, {}};
  const std::size_t last = found.window.knots.size() - 1;
  result.end.prior = at_rest(fix * found.window.knots[last], end_.step);
  result.end.prior.means[0] = fix * found.window.knots[last - 1];
  return result;
}

/// Goes on from a beginning: with a map of the first scan alone.
void KnotFrontEnd::take(const Beginning& beginning) {
  end_ = beginning.end;
  model_ = beginning.model;
  clear_map();
  integrate(look(first_scan_->thinned(), beginning.first));
}

}  // namespace surefoot
