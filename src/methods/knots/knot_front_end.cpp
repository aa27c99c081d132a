// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan through Surefoot's own method, in add: predict the knots, register them, learn from
// them, map what they deskewed.
#include "methods/knots/knot_front_end.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/deskew.hpp"
#include "core/information.hpp"

namespace surefoot {

namespace {

// [m] of the cubes that choose the points to be registered: of the first scan, before anything is
// known of the scene's scale, and at most, about the voxels of the map's coarsest grid.
constexpr double kFirstCube = 1.0, kCoarsestCube = 3.0;

// A scan tells of another mean velocity unless so many times more speaks against it than leaves
// doubt: a car that speeds up is a little doubtful until its mean is known, and who leaps is more.
constexpr double kSpeedsUp = 3.0;

constexpr double kNew = 0.02;  // share of the points, more than what is the same

/// By which a scan that was seen before is known again, byte by byte.
std::uint64_t fingerprint(const std::vector<Eigen::Vector3f>& points) {
  constexpr std::uint64_t kFactor = 0x100000001b3ULL;
  std::array<std::uint64_t, 3> hashes = {points.size(), 0, 0};  // of each axis: three at a time
  for (const Eigen::Vector3f& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hashes[axis] =
          (hashes[axis] ^ std::bit_cast<std::uint32_t>(p[static_cast<int>(axis)])) * kFactor;
    }
  }
  return ((hashes[0] * kFactor) ^ hashes[1]) * kFactor ^ hashes[2];
}

void refuse_reversed(Estimate& estimate) {
  estimate.status = Status::lost;
  estimate.message =
      "the scan's beams turn the other way than before: it is mirrored, or its times run backwards";
}

}  // namespace

KnotFrontEnd::KnotFrontEnd(const Session& session)
    : session_(session),
      config_(session.config),
      map_(session),
      model_(config_.knots),
      map_choice_(map_choice(config_.knots)),
      choice_(config_.knots.points, {config_.knots.map_voxel, kFirstCube, kCoarsestCube}),
      errors_(config_.knots) {}

KnotFrontEnd::KnotFrontEnd(const KnotFrontEnd& lost, int segments) : KnotFrontEnd(lost.session_) {
  model_ = lost.model_;
  map_choice_ = lost.map_choice_;
  choice_ = lost.choice_;
  end_ = lost.end_;
  last_pose_ = lost.last_pose_;
  last_told_ = lost.last_told_;
  velocity_ = lost.velocity_;
  errors_ = lost.errors_;
  last_print_ = lost.last_print_;
  sweep_direction_ = lost.sweep_direction_;
  level_ = lost.level_;
  search_ = lost.search_;
  segment_ = segments - 1;
}

Estimate KnotFrontEnd::add(const PreparedScan& scan) {
  const std::uint64_t print = fingerprint(scan.points);
  seen_again_ = print == std::exchange(last_print_, print);
  reversed_ = sweep_direction_.is_reversed(sweep_axis(scan));
  session_.begin_step(Step::downsample);
  const std::vector<std::uint32_t> points = map_choice_.choose(scan, session_.workers);
  const ScanPart thinned{scan, points};
  if (agreed_ == 0) return begin_map(thinned);  // there is no map
  session_.begin_step(Step::map);               // what of the last scan is not in it yet
  map_.forget_emptied();
  session_.begin_step(Step::downsample);
  if (search_) return search(thinned);
  Registered registered = first_scan_ ? register_second(thinned) : register_next(thinned);
  if (reversed_) refuse_reversed(registered.estimate);
  if (!registered.estimate.trusted()) return lose(thinned, std::move(registered));
  View view = look(thinned, registered.trajectory);
  const double hazard_now = hazard_of(thinned, view, registered);
  registered.estimate.wrong_probability = verdict_.add(hazard_now);
  const double objection = objection_of(registered.estimate, hazard_now);
  if (is_lost(objection, objections_.add(objection))) {
    return lose(thinned, std::move(registered));
  }
  return accept(hazard_now, std::move(view), std::move(registered));
}

/// A scan from where the last one ended; after a hole, from where it would be had it walked
/// straight on, unless it fits clearly better nearer to where it was. Of equal bays none fits
/// better than the next, but for what was not seen of it yet: nobody who walked ahead is farther
/// back, and who stayed where he was sees nothing new.
KnotFrontEnd::Registered KnotFrontEnd::register_next(const ScanPart& thinned) {
  Registered here = register_scan(thinned, beginning_of(thinned.scan, end_, model_, config_));
  if (!whereabouts().is_after_short_hole(thinned.scan)) return here;
  std::optional<Registered> there = register_ahead(thinned);
  if (!there || !there->estimate.trusted()) return here;
  const bool better_here = here.estimate.trusted() &&
                           !whereabouts().is_farther_back(here.trajectory.at(0.5), thinned.scan) &&
                           kClearlyBetter * disagreement_of(here) < disagreement_of(*there) &&
                           !sees_more_new(here.found.unseen, there->found.unseen);
  return better_here ? std::move(here) : std::move(*there);
}

/// Whether much that a scan sees would be new at one place, and known at another: by the shares
/// that are new.
bool KnotFrontEnd::sees_more_new(double at_one, double at_other) {
  return at_one >= kClearlyBetter * at_other + kNew;
}

Whereabouts KnotFrontEnd::whereabouts() const {
  return {end_.prior.means[1],
          mount_,
          last_pose_->stamp_ns,
          model_,
          way_,
          config_.motion_prior.max_extrapolation,
          search_ && search_->after_hole};
}

/// A scan from where it is taken to begin, and what is known of the pose by itself.
KnotFrontEnd::Registered KnotFrontEnd::register_scan(const ScanPart& thinned,
                                                     const KnotEnd& begin) {
  Registered result{begin, predict_knots(thinned.scan, begin, model_, config_.knots)};
  KnotPoints points = sort_points(thinned.scan, choose(thinned), result.predicted);
  result.found = register_in_attempts(points, problem(begin), result.predicted, usual_);
  session_.begin_step(Step::assess);
  conclude(thinned.scan, points.points.size(), result);
  return result;
}

/// Takes a pose for right: learns from it and maps what the scan saw.
Estimate KnotFrontEnd::accept(double hazard_now, View view, Registered registered) {
  learn(registered, 1.0 - hazard_now);
  session_.begin_step(Step::map);
  first_scan_.reset();
  integrate(std::move(view));
  let_drift(registered);
  name_weakness_of_late(registered);
  const ScanTrajectory& trajectory = registered.trajectory;
  last_pose_ = StampedPose{trajectory.mid_ns(), trajectory.at(0.5)};
  way_.add(carrier_of(last_pose_->pose, mount_));
  to_deskew_.trajectory = registered.told.trajectory;
  return publish(registered.told.trajectory, std::move(registered.estimate));
}

/// The points to register.
std::vector<std::uint32_t> KnotFrontEnd::choose(const ScanPart& thinned) {
  return choice_.choose(thinned.scan, thinned.points, session_.workers);
}

/// Likewise, but that the next scan's do not depend on it.
std::vector<std::uint32_t> KnotFrontEnd::chosen_in_passing(const ScanPart& thinned) const {
  PointChoice choice = choice_;
  return choice.choose(thinned.scan, thinned.points, session_.workers);
}

KnotProblem KnotFrontEnd::problem(const KnotEnd& begin) const {
  return {map_.surfels(), begin.prior,      model_,
          config_.knots,  session_.workers, session_.begin_step};
}

/// What a trusted registration tells for the next scan.
void KnotFrontEnd::learn(const Registered& registered, double right) {
  const Config::Knots& knots = config_.knots;
  const KnotRegistration& found = registered.found;
  lost_in_a_row_ = 0;
  ++agreed_;
  usual_signs_.learn(registered.signs, right, knots.usual_rate);
  errors_.learn(found, registered.trajectory, agreed_);
  usual_.learn(found, first_scan_ ? 1.0 : knots.usual_rate, knots);
  bend_.learn(registered.bent);
  model_.learn(found.window, found.covariance, registered.begin.prior.means[1].rotation,
               !is_doubtful((1.0 - right) / kSpeedsUp));
  finish(found.window, found.last_two);
}

/// A scan that could not be registered, or whose pose is probably wrong: the pose is the
/// prediction, and the map stays as it is. What disagrees with the first scans of a map is no
/// reason to believe these: the map begins anew.
Estimate KnotFrontEnd::lose(const ScanPart& thinned, Registered registered) {
  finish(registered.predicted, registered.begin.prior.information);
  Estimate& estimate = registered.estimate;
  const bool wrong = estimate.trusted();
  ++lost_in_a_row_;
  if (agreed_ < kAgree && (wrong || lost_in_a_row_ == kAgree)) return begin_map(thinned);
  if (wrong) {
    estimate.status = Status::lost;
    estimate.message = "the pose is wrong with a probability of " +
                       std::to_string(estimate.wrong_probability) + "; expected at most " +
                       std::to_string(config_.knots.lost_probability);
    estimate.degenerate.clear();
  }
  const bool after_hole = whereabouts().is_after_hole(thinned.scan);
  if (wrong || after_hole || lost_in_a_row_ > config_.health.restart_after) {
    if (config_.knots.search_scans == 0) return begin_map(thinned);
    search_ = PoseSearch{};
    search_->after_hole = after_hole;
  }
  estimate.covariance = unregistered_covariance(config_.health);
  const ScanTrajectory trajectory =
      registered.predicted.trajectory(thinned.scan.start_ns, thinned.scan.end_ns);
  to_deskew_ = {&thinned.scan, trajectory};
  return publish(trajectory, std::move(estimate));
}

/// The last two knots are where the next scan begins; not all that is known of them is relied on.
KnotEnd KnotFrontEnd::end_of(const KnotWindow& window, const Matrix12& information) const {
  const std::size_t last = window.knots.size() - 1;
  // [K9]
  return {{{window.knots[last - 1], window.knots[last]}, config_.knots.memory * information},
          window.end_ns,
          window.duration(last - 1)};
}

void KnotFrontEnd::finish(const KnotWindow& window, const Matrix12& information) {
  end_ = end_of(window, information);
  velocity_ = rotated(window.knots.back().rotation.conjugate(), window.mean_velocity());
}

const DeskewedScan& KnotFrontEnd::deskewed_scan() const {
  if (to_deskew_.scan != nullptr) {
    const PreparedScan& scan = *to_deskew_.scan;
    last_scan_ = {deskew(scan, to_deskew_.trajectory, session_.workers), scan.intensities};
    to_deskew_.scan = nullptr;
  }
  return last_scan_;
}

void KnotFrontEnd::clear_map() {
  map_.clear();
  bend_.clear();
}

void KnotFrontEnd::forget_verdicts() {
  verdict_.clear();
  objections_.clear();
}

/// Puts what a scan saw, deskewed, into the map's frame.
View KnotFrontEnd::look(const ScanPart& thinned, const ScanTrajectory& trajectory) {
  const PreparedScan& scan = thinned.scan;
  const Pose middle = trajectory.at(0.5);
  to_deskew_ = {&scan, trajectory};
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

void KnotFrontEnd::integrate(View view) {
  way_.remove_far(view.sensor, config_.map.radius);
  map_.add(std::move(view));
}

Estimate KnotFrontEnd::publish(const ScanTrajectory& trajectory, Estimate estimate) {
  estimate.trajectory = trajectory;
  if (estimate.trusted()) last_told_ = StampedPose{trajectory.mid_ns(), trajectory.at(0.5)};
  estimate.twist = velocity_;
  estimate.segment = segment_;
  return estimate;
}

}  // namespace surefoot
