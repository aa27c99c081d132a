// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_beginning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

double speed(const Twist& velocity) { return velocity.head<3>().norm(); }

/// The velocity that the second scan of a map shows: both scans as measured, distorted alike, as
/// rigid bodies, from standstill to a car's speed. Zero where that cannot be told. Map axes.
Twist first_velocity(KnotTrack& track, const ScanPart& second) {
  const Config& config = track.config();
  const Session& session = track.session();
  const Pose& middle = track.last_pose()->pose;
  const std::int64_t from_ns = track.last_pose()->stamp_ns;
  const std::int64_t mid_ns = second.scan.mid_ns();
  const double elapsed = seconds(mid_ns - from_ns);
  const KnotWindow standing{{middle, middle, middle}, elapsed, elapsed, from_ns, mid_ns};
  KnotPoints points;
  for (const std::uint32_t i : track.choose(second)) {
    points.points.push_back({second.scan.points[i].cast<double>(), 1.0, {}});
  }
  points.begins = {0, points.points.size()};
  const KnotPrior anywhere = at_rest(middle, elapsed);
  const VelocityModel any_speed(config.knots, kAnyFluctuation);
  const KnotProblem two_scans{track.map().surfels(), anywhere,        any_speed,
                              config.knots,          session.workers, session.begin_step};
  const KnotRegistration found =
      register_knots(points, two_scans, standing, patient_annealing(config.knots));
  if (!found.solved || found.matches < config.health.min_matches) return Twist::Zero();
  return found.window.mean_velocity();
}

/// Whether one start led to a registration of which so many times less disagrees than of another's.
bool is_better(const RegisteredScan& one, const RegisteredScan& other, double times_less,
               const KnotTrack& track) {
  if (!one.estimate.trusted() || !other.estimate.trusted()) return one.estimate.trusted();
  return times_less * track.disagreement_of(one) < track.disagreement_of(other);
}

}  // namespace

RegisteredScan KnotBeginning::register_second(KnotTrack& track, const ScanPart& second) const {
  const Twist fast = first_velocity(track, second);
  Start best = registered_on(start_at(Twist::Zero(), track), 1, track, second);
  if (std::abs(fast[5]) >= kTurning) {
    const double times_less = firmness(best.second.found) > 0.0 ? 1.0 / kAsGood : kClearlyFaster;
    const Twist turn = fast[5] * Twist::Unit(5);
    Start turning = registered_on(start_at(turn, track), kTurnRounds, track, second);
    if (is_better(turning.second, best.second, times_less, track)) best = std::move(turning);
  }
  if (speed(fast) >= kWalking) {
    const bool walks = speed(best.second.found.window.mean_velocity()) < kWalking;
    Start faster = registered_on(start_at(fast, track), 1, track, second);
    const bool held = faster.second.estimate.degenerate.empty();
    const double times_less = !walks ? 1.0 : held ? kFasterAndHeld : kClearlyFaster;
    if (is_better(faster.second, best.second, times_less, track)) best = std::move(faster);
  }
  go_on_from(best, track);
  return std::move(best.second);
}

/// The first scan at a velocity, about where it was taken to be.
KnotBeginning::Start KnotBeginning::start_at(const Twist& velocity, const KnotTrack& track) const {
  const StampedPose& last = *track.last_pose();
  const Pose& middle = last.pose;
  const double half = 0.5 * seconds(scan_.end_ns - scan_.start_ns);
  Start start{{{displaced(middle, -half * velocity), displaced(middle, half * velocity)},
               scan_.start_ns,
               scan_.end_ns},
              track.end(),
              track.model(),
              {}};
  if (velocity.isZero()) return start;
  KnotEnd& end = start.end;
  const double since = seconds(end.stamp_ns - last.stamp_ns);
  end.prior.means[0] = displaced(middle, (since - end.step) * velocity);
  end.prior.means[1] = displaced(middle, since * velocity);
  start.model.begin(velocity, middle.rotation);
  return start;
}

/// The second scan on a map of the first, then the first on a map of the second, and the second
/// again, `rounds` times: a gait swings, and what the one scan was bent by the other was not.
KnotBeginning::Start KnotBeginning::registered_on(Start start, int rounds, KnotTrack& track,
                                                  const ScanPart& second) const {
  go_on_from(start, track);
  start.second = track.register_next(second);
  for (int round = 0; round < rounds && start.second.estimate.trusted(); ++round) {
    std::optional<Start> turn = turned(start, track, second);
    if (!turn) break;
    go_on_from(*turn, track);
    turn->second = track.register_next(second);
    if (!turn->second.estimate.trusted()) break;
    start = std::move(*turn);
  }
  return start;
}

/// The first scan's motion as a map of the second shows it. Its middle stays where it is; a gait's
/// swing in the second is not the first one's.
std::optional<KnotBeginning::Start> KnotBeginning::turned(const Start& start, KnotTrack& track,
                                                          const ScanPart& second) const {
  track.map_alone(track.look(second, start.second.trajectory));
  Twist velocity = start.second.found.window.mean_velocity();
  velocity.segment<2>(3).setZero();
  const KnotEnd& end = track.end();
  const Pose from = start_at(velocity, track).first.at(0.0);
  const KnotEnd begin{
      {{displaced(from, -end.step * velocity), from}, at_rest(from, end.step, kVague).information},
      std::min(scan_.start_ns, scan_.end_ns - kInstantNs),
      end.step};
  const Config& config = track.config();
  const KnotWindow predicted =
      predict_knots(scan_, begin, track.model(), config.knots).at_velocity(velocity);
  KnotPoints points = sort_points(scan_, track.choose(first()), predicted);
  const KnotRegistration found =
      register_knots(points, track.problem(begin), predicted, usual_annealing(config.knots));
  if (!found.solved || found.matches < config.health.min_matches) return std::nullopt;

  const ScanTrajectory motion = found.window.trajectory(scan_.start_ns, scan_.end_ns);
  const Pose fix = track.last_pose()->pose * motion.at(0.5).inverse();
  Start result{motion.moved(fix), end, track.model(), {}};
  const std::size_t last = found.window.knots.size() - 1;
  result.end.prior = at_rest(fix * found.window.knots[last], end.step);
  result.end.prior.means[0] = fix * found.window.knots[last - 1];
  return result;
}

/// With a map of the first scan alone.
void KnotBeginning::go_on_from(const Start& start, KnotTrack& track) const {
  track.begin_otherwise(start.end, start.model, track.look(first(), start.first));
}

}  // namespace surefoot
