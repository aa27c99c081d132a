// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_track.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "core/deskew.hpp"
#include "core/health.hpp"
#include "core/information.hpp"
#include "geometry/se3.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// [m] of the cubes that choose the points to be registered: of the first scan, before anything is
// known of the scene's scale, and at most, about the voxels of the map's coarsest grid.
constexpr double kFirstCube = 1.0, kCoarsestCube = 3.0;

// A scan tells of another mean velocity unless so many times more speaks against it than leaves
// doubt: a car that speeds up is a little doubtful until its mean is known, and who leaps is more.
constexpr double kSpeedsUp = 3.0;

// What has not settled after so many iterations is hardly a place that is believed.
constexpr int kMostIterations = 40;

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

}  // namespace

KnotTrack::KnotTrack(const Session& session)
    : session_(session),
      map_(session),
      model_(config().knots),
      choice_(config().knots.points, {config().knots.map_voxel, kFirstCube, kCoarsestCube}),
      errors_(config().knots) {}

void KnotTrack::take_over(const KnotTrack& lost) {
  model_ = lost.model_;
  choice_ = lost.choice_;
  end_ = lost.end_;
  last_pose_ = lost.last_pose_;
  last_end_ns_ = lost.last_end_ns_;
  velocity_ = lost.velocity_;
  errors_ = lost.errors_;
}

void KnotTrack::begin(const ScanPart& first, const Pose& T_map_lidar, bool is_levelled) {
  const PreparedScan& scan = first.scan;
  const ScanTrajectory trajectory({T_map_lidar, T_map_lidar}, scan.start_ns, scan.end_ns);
  end_.step = usual_step(scan, config().knots.segments);
  end_.stamp_ns = scan.end_ns;
  end_.prior = at_rest(T_map_lidar, end_.step);
  velocity_ = Twist::Zero();
  agreed_ = 1;
  usual_ = {};
  walked_unseen_ = false;
  map_alone(look(first, trajectory));
  last_pose_ = StampedPose{trajectory.mid_ns(), T_map_lidar};
  last_end_ns_ = scan.end_ns;
  mount_ = mount_of(T_map_lidar);
  way_.begin(carrier_of(T_map_lidar, mount_), is_levelled);
}

void KnotTrack::accept(const RegisteredScan& registered, double right, View view) {
  const Config::Knots& knots = config().knots;
  const KnotRegistration& found = registered.found;
  const bool is_second = agreed_++ == 1;
  errors_.learn(found, registered.trajectory, agreed_);
  usual_.learn(found, is_second ? 1.0 : knots.usual_rate, knots);
  bend_.learn(registered.bent);
  model_.learn(found.window, found.covariance, registered.begin.prior.means[1].rotation,
               !is_doubtful((1.0 - right) / kSpeedsUp));
  finish(found.window, found.last_two);
  session_.begin_step(Step::map);
  integrate(std::move(view));
  const ScanTrajectory& trajectory = registered.trajectory;
  last_pose_ = StampedPose{trajectory.mid_ns(), trajectory.at(0.5)};
  last_end_ns_ = found.window.end_ns;
  way_.add(carrier_of(last_pose_->pose, mount_));
}

void KnotTrack::miss(const RegisteredScan& registered) {
  finish(registered.predicted, registered.begin.prior.information);
}

/// Of equal bays none fits better than the next, but for what was not seen of it yet: nobody who
/// walked ahead is farther back, and who stayed where he was sees nothing new.
RegisteredScan KnotTrack::register_next(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  RegisteredScan here = register_scan(thinned, beginning_of(scan, end_, model_, config()));
  if (!whereabouts().is_after_short_hole(scan)) return here;
  std::optional<RegisteredScan> there = register_ahead(thinned);
  if (!there || !there->estimate.trusted()) return here;
  const bool better_here = here.estimate.trusted() &&
                           !whereabouts().is_farther_back(here.trajectory.at(0.5), scan) &&
                           kClearlyBetter * disagreement_of(here) < disagreement_of(*there) &&
                           !sees_more_new(here.found.unseen, there->found.unseen);
  return better_here ? std::move(here) : std::move(*there);
}

RegisteredScan KnotTrack::register_scan(const ScanPart& thinned, const KnotEnd& begin) {
  RegisteredScan result{begin, predict_knots(thinned.scan, begin, model_, config().knots)};
  KnotPoints points = sort_points(thinned.scan, choose(thinned), result.predicted);
  result.found = register_in_attempts(points, problem(begin), result.predicted, usual_);
  session_.begin_step(Step::assess);
  conclude(thinned.scan, points.points.size(), result);
  return result;
}

/// From far away it takes its time: whether it settles is told by a second one, from where the
/// first ended.
std::optional<RegisteredScan> KnotTrack::register_from(
    const KnotEnd& begin, const KnotWindow& predicted, const KnotWindow& start,
    const PreparedScan& scan, const std::vector<std::uint32_t>& chosen) const {
  RegisteredScan here{begin, predicted};
  KnotPoints points = sort_points(scan, chosen, predicted);
  Config::Knots knots = config().knots;
  knots.max_iterations = std::min(knots.max_iterations, kMostIterations);
  const KnotProblem problem{map_.surfels(), begin.prior,      model_,
                            knots,          session_.workers, session_.begin_step};
  here.found = register_in_attempts(points, problem, start, usual_);
  if (here.found.solved && !has_settled(here.found.converged, here.found.settling, false)) {
    here.found = register_knots(points, problem, here.found.window, usual_annealing(knots));
  }
  if (!here.found.solved) return std::nullopt;
  conclude(scan, points.points.size(), here);
  return here;
}

std::optional<RegisteredScan> KnotTrack::register_at(
    const PlaceStart& start, const PreparedScan& scan,
    const std::vector<std::uint32_t>& chosen) const {
  const KnotEnd begin = begin_at(start.place, scan, config().knots);
  const KnotWindow predicted =
      predict_knots(scan, begin, model_, config().knots).at_velocity(start.velocity);
  return register_from(begin, predicted, predicted, scan, chosen);
}

/// A scan where it would be had it walked straight on, unseen: as high as the ground of its way
/// goes on there, or as it climbed of late.
std::optional<RegisteredScan> KnotTrack::register_ahead(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  const Pose level = whereabouts().going_straight_on(scan.start_ns);
  const Pose climbing = whereabouts().climbing_on(scan.start_ns);
  const Twist going = model_.mean(level.rotation);
  const auto chosen = choose(thinned);
  std::optional<RegisteredScan> best = register_at({level, going}, scan, chosen);
  auto other = register_at({climbing, going}, scan, chosen);
  const bool better =
      other && other->estimate.trusted() &&
      (!best || !best->estimate.trusted() || disagreement_of(*other) < disagreement_of(*best));
  return better ? std::move(other) : std::move(best);
}

/// Takes what bends the map out of a registration, and says how sure it is and what it is worth.
void KnotTrack::conclude(const PreparedScan& scan, std::size_t points,
                         RegisteredScan& registered) const {
  registered.bent = registered.found.window;
  registered.found.window = bend_.straightened(registered.bent);
  const KnotRegistration& found = registered.found;
  registered.trajectory = found.window.trajectory(scan.start_ns, scan.end_ns);
  const ScanTrajectory& trajectory = registered.trajectory;
  Estimate& estimate = registered.estimate;
  estimate.converged = found.converged;
  estimate.stages = StageReport{"registration", found.iterations, found.matches, found.rigid.rms()};
  estimate.registered_points = static_cast<int>(points);
  const Pose T_map_lidar = trajectory.at(0.5);
  const Pose T_0 = registered.predicted.trajectory().at_time(trajectory.mid_ns());
  Judgement judgement =
      judge_registration({T_0, T_map_lidar, found.matches, points}, config().health);
  if (!found.solved && judgement.status == Status::ok) {
    judgement = {Status::diverged, "the knots' normal equations gave no finite solution"};
  }
  estimate.status = judgement.status;
  estimate.message = std::move(judgement.message);
  if (judgement.status != Status::ok) return;
  registered.told = errors_.tell(found, trajectory, model_);
  estimate.covariance = registered.told.covariance;
  NormalEquations<6> held = found.rigid;
  held.H -= found.doubtful;
  report_weak_directions(held, found.squared_distance, T_map_lidar, config().health, estimate);
}

std::vector<std::uint32_t> KnotTrack::choose(const ScanPart& thinned) {
  return choice_.choose(thinned.scan, thinned.points, session_.workers);
}

std::vector<std::uint32_t> KnotTrack::chosen_in_passing(const ScanPart& thinned) const {
  PointChoice choice = choice_;
  return choice.choose(thinned.scan, thinned.points, session_.workers);
}

View KnotTrack::look(const ScanPart& thinned, const ScanTrajectory& trajectory) const {
  const PreparedScan& scan = thinned.scan;
  const Pose middle = trajectory.at(0.5);
  const Deskewing deskewing(trajectory);
  std::vector<Eigen::Vector3d> points(thinned.points.size());
  session_.workers.for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      const std::uint32_t i = thinned.points[at];
      const Eigen::Vector3f& point = scan.points[i];
      points[at] =
          middle * (scan.taus.empty() ? point : deskewing(point, scan.taus[i])).cast<double>();
    }
  });
  return {middle.translation, std::move(points), session_.workers};
}

KnotProblem KnotTrack::problem(const KnotEnd& begin) const {
  return {map_.surfels(), begin.prior,      model_,
          config().knots, session_.workers, session_.begin_step};
}

double KnotTrack::disagreement_of(const RegisteredScan& registered) const {
  return registered.found.disagreement(config().knots.unseen_weight);
}

Whereabouts KnotTrack::whereabouts() const {
  return {end_.prior.means[1],
          mount_,
          last_pose_->stamp_ns,
          last_end_ns_,
          model_,
          way_,
          config().motion_prior.max_extrapolation,
          walked_unseen_};
}

KnotEnd KnotTrack::end_of(const RegisteredScan& registered) const {
  return end_of(registered.found.window, registered.found.last_two);
}

/// The last two knots are where the next scan begins; not all that is known of them is relied on.
KnotEnd KnotTrack::end_of(const KnotWindow& window, const Matrix12& information) const {
  const std::size_t last = window.knots.size() - 1;
  // [K9]
  return {{{window.knots[last - 1], window.knots[last]}, config().knots.memory * information},
          window.end_ns,
          window.duration(last - 1)};
}

void KnotTrack::finish(const KnotWindow& window, const Matrix12& information) {
  end_ = end_of(window, information);
  velocity_ = rotated(window.knots.back().rotation.conjugate(), window.mean_velocity());
}

void KnotTrack::begin_otherwise(const KnotEnd& end, const VelocityModel& model, View first) {
  end_ = end;
  model_ = model;
  map_alone(std::move(first));
}

void KnotTrack::map_alone(View view) {
  map_.clear();
  bend_.clear();
  integrate(std::move(view));
}

void KnotTrack::integrate(View view) {
  way_.remove_far(view.sensor, config().map.radius);
  map_.add(std::move(view));
}

}  // namespace surefoot
