// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What all methods share: scans are checked on the way in, estimates brought to the caller's world
// on the way out.
#include "surefoot/odometry.hpp"

#include <utility>

#include "core/front_end.hpp"
#include "core/information.hpp"
#include "core/preprocess.hpp"
#include "core/scan_clock.hpp"
#include "geometry/se3.hpp"

namespace surefoot {

namespace {

const Config& validated(const Config& config) {
  validate(config);
  return config;
}

}  // namespace

struct Odometry::State {
  State(const Config& config, int threads, Pose T_world_start, const MakeFrontEnd& make)
      : session{validated(config), Workers(threads)},
        T_world_map(std::move(T_world_start)),
        front_end(make(session)) {}

  Session session;
  Pose T_world_map;
  std::unique_ptr<FrontEnd> front_end;
  PreparedScan accepted;  // the last one, kept for the front-end
  int segment = 0;        // of the last estimate
  ScanClock clock;

  Estimate answer(PreparedScan&& scan);
  Estimate accept(PreparedScan&& scan);
  [[nodiscard]] Estimate reject(const PreparedScan& scan, std::string reason) const;
  [[nodiscard]] Estimate in_world(Estimate estimate) const;
};

Odometry::Odometry(const Config& config, int threads, const Pose& T_world_start)
    : state_(std::make_unique<State>(config, threads, T_world_start, [](const Session& session) {
        return make_front_end(session);
      })) {}
Odometry::Odometry(const Config& config, int threads, const MakeFrontEnd& make_front_end)
    : state_(std::make_unique<State>(config, threads, Pose{}, make_front_end)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

Estimate Odometry::add_scan(const Scan& scan) {
  const Session& session = state_->session;
  session.begin_step(Step::preprocess);
  PreparedScan prepared = preprocess(scan, session.config.preprocess);
  const auto points = static_cast<int>(prepared.points.size());
  Estimate estimate = state_->answer(std::move(prepared));
  estimate.points = points;
  session.begin_step(Step::idle);
  return state_->in_world(std::move(estimate));
}

Estimate Odometry::State::answer(PreparedScan&& scan) {
  if (!scan.rejection.empty()) return reject(scan, scan.rejection);
  std::string objection = clock.objection(scan.mid_ns(), scan.end_ns);
  if (objection.empty()) return accept(std::move(scan));
  clock.refuse(scan.mid_ns());
  return reject(scan, std::move(objection));
}

/// What the front-end is told goes on where the clock was set back.
Estimate Odometry::State::accept(PreparedScan&& scan) {
  const std::int64_t ahead_ns = clock.follow(scan.mid_ns());
  accepted = std::move(scan);
  accepted.start_ns += ahead_ns;
  accepted.end_ns += ahead_ns;
  Estimate estimate = front_end->add(accepted);
  clock.used(estimate.trajectory.mid_ns());
  segment = estimate.segment;
  estimate.trajectory = estimate.trajectory.delayed(-ahead_ns);
  return estimate;
}

/// The last pose again, as something that is not known.
Estimate Odometry::State::reject(const PreparedScan& scan, std::string reason) const {
  Estimate estimate;
  estimate.status = Status::rejected;
  estimate.message = std::move(reason);
  estimate.covariance = unregistered_covariance(session.config.health);
  estimate.twist = front_end->velocity();
  estimate.segment = segment;
  const StampedPose last = front_end->last_pose().value_or(StampedPose{});
  estimate.trajectory = ScanTrajectory(last.pose, scan.mid_ns());
  return estimate;
}

Estimate Odometry::State::in_world(Estimate estimate) const {
  estimate.stamp_ns = estimate.trajectory.mid_ns();
  estimate.trajectory = estimate.trajectory.moved(T_world_map);
  estimate.T_world_lidar = estimate.trajectory.at(0.5);
  const Matrix6 turn = turned_axes(T_world_map.rotation);
  estimate.covariance = turn * estimate.covariance * turn.transpose();
  for (DegenerateDirection& weak : estimate.degenerate) weak.direction = turn * weak.direction;
  return estimate;
}

const Config& Odometry::config() const { return state_->session.config; }

const LevelReport& Odometry::level() const { return state_->front_end->level(); }

const DeskewedScan& Odometry::deskewed_scan() const { return state_->front_end->deskewed_scan(); }

std::vector<Eigen::Vector3d> Odometry::local_map() const {
  std::vector<Eigen::Vector3d> points = state_->front_end->local_map();
  for (Eigen::Vector3d& point : points) point = state_->T_world_map * point;
  return points;
}

Cubes Odometry::emptied_cubes() const {
  Cubes cubes = state_->front_end->emptied_cubes();
  for (Eigen::Vector3d& centre : cubes.centres) centre = state_->T_world_map * centre;
  return cubes;
}

std::int64_t Odometry::ahead_ns() const { return state_->clock.ahead_ns(); }

void Odometry::set_step_observer(StepObserver observer) {
  state_->session.begin_step = observer ? std::move(observer) : [](Step) {};
}

}  // namespace surefoot
