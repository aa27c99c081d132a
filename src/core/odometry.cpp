// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What all methods share: scans are checked on the way in, estimates brought to the caller's world
// on the way out.
#include "surefoot/odometry.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/front_end.hpp"
#include "core/information.hpp"
#include "core/preprocess.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// One scan refused for its stamp came late, or twice: the next one's stamp tells all. After so many
// the clock was set back; and after so many that it is not going to catch up soon, that is taken.
constexpr int kClockWasSet = 2, kClockStays = 10, kMostEarly = 1'000'000;

// [ns] between two scans; stamps that are farther apart tell no period.
constexpr std::int64_t kMostPeriod = 10'000'000'000;

// [ns] half of what two stamps may be apart: 146 years.
constexpr std::int64_t kLongest = std::int64_t{1} << 61;

/// Of any two stamps.
bool are_far_apart(std::int64_t a_ns, std::int64_t b_ns) {
  return std::abs(a_ns / 2 - b_ns / 2) > kLongest;
}

std::int64_t mid_ns_of(const PreparedScan& scan) {
  return scan.start_ns + (scan.end_ns - scan.start_ns) / 2;
}

const Config& validated(const Config& config) {
  validate(config);
  return config;
}

}  // namespace

struct Odometry::State {
  State(const Config& config, int threads, const Pose& T_world_start, const MakeFrontEnd& make)
      : session{validated(config), Workers(threads)},
        T_world_map(T_world_start),
        front_end(make(session)) {}

  Session session;
  Pose T_world_map;
  std::unique_ptr<FrontEnd> front_end;
  PreparedScan accepted;                    // the last one, kept for the front-end
  std::optional<std::int64_t> last_mid_ns;  // of the scans that were not rejected
  int early = 0;                            // scans in a row refused for their stamps, which rise
  std::int64_t early_mid_ns = 0;            // of the last of these
  std::int64_t set_back_ns = 0;             // by which the clock was, in all

  [[nodiscard]] std::string objection(const PreparedScan& scan) const;
  [[nodiscard]] std::string stamp_objection(const PreparedScan& scan) const;
  [[nodiscard]] bool clock_stays(std::int64_t mid_ns) const;
  void note_early(const PreparedScan& scan);
  void follow_clock(std::int64_t mid_ns);
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
  std::string objection = state_->objection(prepared);
  const auto points = static_cast<int>(prepared.points.size());
  Estimate estimate;
  if (objection.empty()) {
    estimate = state_->accept(std::move(prepared));
  } else {
    if (prepared.rejection.empty()) state_->note_early(prepared);
    estimate = state_->reject(prepared, std::move(objection));
  }
  estimate.points = points;
  session.begin_step(Step::idle);
  return state_->in_world(std::move(estimate));
}

void Odometry::State::note_early(const PreparedScan& scan) {
  const std::int64_t mid_ns = mid_ns_of(scan);
  const bool rises = early > 0 && mid_ns > early_mid_ns && !are_far_apart(mid_ns, early_mid_ns);
  early = rises ? std::min(early + 1, kMostEarly) : 1;
  early_mid_ns = mid_ns;
}

/// Whether a scan goes on from so many refused before it that nobody waits for the old time.
bool Odometry::State::clock_stays(std::int64_t mid_ns) const {
  return early >= kClockStays && mid_ns > early_mid_ns &&
         !are_far_apart(mid_ns, *last_mid_ns - set_back_ns);
}

/// Scans refused for their stamps took time, too, which the stamps of those about them do not tell
/// where the clock was set back. What the front-end is told goes on as if it had not been.
void Odometry::State::follow_clock(std::int64_t mid_ns) {
  if (last_mid_ns && early >= kClockWasSet && !are_far_apart(mid_ns, early_mid_ns)) {
    const std::int64_t told = mid_ns + set_back_ns - *last_mid_ns;
    const std::int64_t period = std::clamp(mid_ns - early_mid_ns, std::int64_t{0}, kMostPeriod);
    const std::int64_t took = (early + 1) * period;
    set_back_ns += std::max(took - told, std::int64_t{0});
  }
  early = 0;
}

Estimate Odometry::State::accept(PreparedScan&& scan) {
  follow_clock(mid_ns_of(scan));
  accepted = std::move(scan);
  accepted.start_ns += set_back_ns;
  accepted.end_ns += set_back_ns;
  Estimate estimate = front_end->add(accepted);
  last_mid_ns = estimate.trajectory.mid_ns();
  estimate.trajectory = estimate.trajectory.delayed(-set_back_ns);
  return estimate;
}

std::string Odometry::State::objection(const PreparedScan& scan) const {
  return scan.rejection.empty() ? stamp_objection(scan) : scan.rejection;
}

std::string Odometry::State::stamp_objection(const PreparedScan& scan) const {
  if (!last_mid_ns) return {};
  const std::int64_t mid_ns = mid_ns_of(scan);
  const std::int64_t last = *last_mid_ns - set_back_ns;
  std::int64_t end_ns = 0;
  if (are_far_apart(std::max(mid_ns, last), last) ||
      __builtin_add_overflow(scan.end_ns, set_back_ns, &end_ns)) {
    return "scan's mid-scan stamp " + std::to_string(mid_ns) +
           " ns is more than 146 years after the last scan's " + std::to_string(last) + " ns";
  }
  if (mid_ns > last || clock_stays(mid_ns)) return {};
  return "scan's mid-scan stamp " + std::to_string(mid_ns) + " ns is not after the last scan's " +
         std::to_string(last) + " ns";
}

/// The last pose again, as something that is not known.
Estimate Odometry::State::reject(const PreparedScan& scan, std::string reason) const {
  Estimate estimate;
  estimate.status = Status::rejected;
  estimate.message = std::move(reason);
  estimate.covariance = unregistered_covariance(session.config.health);
  estimate.twist = front_end->velocity();
  const std::int64_t mid_ns = mid_ns_of(scan);
  const StampedPose last = front_end->last_pose().value_or(StampedPose{});
  estimate.trajectory = ScanTrajectory(last.pose, mid_ns);
  return estimate;
}

Estimate Odometry::State::in_world(Estimate estimate) const {
  estimate.stamp_ns = estimate.trajectory.mid_ns();
  estimate.trajectory = estimate.trajectory.moved(T_world_map);
  estimate.T_world_lidar = estimate.trajectory.at(0.5);
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
      T_world_map.rotation.toRotationMatrix();
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

void Odometry::set_step_observer(StepObserver observer) {
  state_->session.begin_step = observer ? std::move(observer) : [](Step) {};
}

}  // namespace surefoot
