// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan through Surefoot's own method, in add: a map begins with it, or it is registered in the
// map (KnotTrack), judged (ScanJudge), and taken for right or lost.
#include "methods/knots/knot_front_end.hpp"

#include <array>
#include <bit>
#include <utility>

#include "core/deskew.hpp"
#include "core/information.hpp"
#include "core/level.hpp"
#include "geometry/se3.hpp"

namespace surefoot {

namespace {

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

bool is_levelled(const LevelReport& level) {
  return level.from_ground || level.mode != LevelMode::ground;
}

}  // namespace

KnotFrontEnd::KnotFrontEnd(const Session& session)
    : session_(session),
      config_(session.config),
      track_(session),
      judge_(session.config),
      map_choice_(map_choice(config_.knots)) {}

KnotFrontEnd::KnotFrontEnd(const KnotFrontEnd& lost, int segments) : KnotFrontEnd(lost.session_) {
  track_.take_over(lost.track_);
  search_ = lost.search_;
  segment_ = segments - 1;
  level_ = lost.level_;
  is_levelled_ = lost.is_levelled_;
  map_choice_ = lost.map_choice_;
  last_print_ = lost.last_print_;
  sweep_direction_ = lost.sweep_direction_;
  last_told_ = lost.last_told_;
}

Estimate KnotFrontEnd::add(const PreparedScan& scan) {
  const std::uint64_t print = fingerprint(scan.points);
  seen_again_ = print == std::exchange(last_print_, print);
  reversed_ = sweep_direction_.is_reversed(sweep_axis(scan));
  session_.begin_step(Step::downsample);
  const std::vector<std::uint32_t> points = map_choice_.choose(scan, session_.workers);
  const ScanPart thinned{scan, points};
  if (agreed() == 0) return begin_map(thinned);  // there is no map
  session_.begin_step(Step::map);                // what of the last scan is not in it yet
  track_.forget_emptied();
  session_.begin_step(Step::downsample);
  return search_ ? search(thinned) : follow(thinned);
}

/// Where a map begins. After a search in vain its tilt is anyone's guess, and it is made level
/// again.
Pose KnotFrontEnd::begin_level(const PreparedScan& scan) {
  if (!track_.last_pose()) {
    Pose level = level_pose(scan.points, config_.level, level_);
    is_levelled_ = is_levelled(level_);
    return level;
  }
  const Pose& predicted = track_.end().prior.means[1];
  if (!search_ || config_.level.mode == LevelMode::none) return predicted;
  LevelReport again;
  const Pose level = level_pose(scan.points, config_.level, again);
  is_levelled_ = is_levelled(again);
  return {upright(predicted).rotation * upright(level).rotation.inverse() * level.rotation,
          predicted.translation};
}

/// The first scan, or the first after too many lost ones: the map begins with it.
Estimate KnotFrontEnd::begin_map(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  session_.begin_step(Step::map);
  const bool anew = track_.last_pose().has_value();
  const Pose T_map_lidar = begin_level(scan);
  track_.begin(thinned, T_map_lidar, is_levelled_);
  judge_.begin(scan.mid_ns());
  beginning_.emplace(thinned);
  sweep_direction_.begin(sweep_axis(scan));
  search_.reset();
  lost_in_a_row_ = 0;
  Estimate estimate;
  estimate.status = Status::first_scan;
  estimate.message = anew ? "the map begins anew at the predicted pose" : level_.message;
  if (anew) {
    ++segment_;
    estimate.covariance = unregistered_covariance(config_.health);
  }
  return publish(scan, {{T_map_lidar, T_map_lidar}, scan.start_ns, scan.end_ns},
                 std::move(estimate));
}

/// The next scan of one who knows where he is.
Estimate KnotFrontEnd::follow(const ScanPart& thinned) {
  RegisteredScan registered =
      beginning_ ? beginning_->register_second(track_, thinned) : track_.register_next(thinned);
  if (reversed_) refuse_reversed(registered.estimate);
  if (!registered.estimate.trusted()) return lose(thinned, std::move(registered));
  View view = track_.look(thinned, registered.trajectory);
  const double hazard_now = judge_.hazard_of(track_, thinned, view, seen_again_, registered);
  if (judge_.is_lost(hazard_now, agreed(), registered.estimate)) {
    return lose(thinned, std::move(registered));
  }
  return accept(thinned.scan, hazard_now, std::move(view), std::move(registered));
}

/// Takes a pose for right: learns from it and maps what the scan saw.
Estimate KnotFrontEnd::accept(const PreparedScan& scan, double hazard_now, View view,
                              RegisteredScan registered) {
  const double right = 1.0 - hazard_now;
  judge_.accept(registered, right);
  track_.accept(registered, right, std::move(view));
  beginning_.reset();
  lost_in_a_row_ = 0;
  if (since_found_ < kSettled) ++since_found_;
  return publish(scan, registered.told.trajectory, std::move(registered.estimate));
}

/// A scan that could not be registered, or whose pose is probably wrong: the pose is the
/// prediction, and the map stays as it is. What disagrees with the first scans of a map is no
/// reason to believe these: the map begins anew.
Estimate KnotFrontEnd::lose(const ScanPart& thinned, RegisteredScan registered) {
  const PreparedScan& scan = thinned.scan;
  track_.miss(registered);
  Estimate& estimate = registered.estimate;
  const bool wrong = estimate.trusted();
  ++lost_in_a_row_;
  if (agreed() < kAgree && (wrong || lost_in_a_row_ == kAgree)) return begin_map(thinned);
  if (wrong) {
    estimate.status = Status::lost;
    estimate.message = "the pose is wrong with a probability of " +
                       std::to_string(estimate.wrong_probability) + "; expected at most " +
                       std::to_string(config_.knots.lost_probability);
    estimate.degenerate.clear();
  }
  const bool after_hole = track_.whereabouts().is_after_hole(scan);
  if (wrong || after_hole || lost_in_a_row_ > config_.health.restart_after) {
    if (config_.knots.search_scans == 0) return begin_map(thinned);
    begin_search();
    track_.may_have_walked_unseen(after_hole);
  }
  estimate.covariance = unregistered_covariance(config_.health);
  return publish(scan, registered.predicted.trajectory(scan.start_ns, scan.end_ns),
                 std::move(estimate));
}

Estimate KnotFrontEnd::publish(const PreparedScan& scan, const ScanTrajectory& trajectory,
                               Estimate estimate) {
  to_deskew_ = {&scan, trajectory};
  estimate.trajectory = trajectory;
  if (estimate.trusted()) last_told_ = StampedPose{trajectory.mid_ns(), trajectory.at(0.5)};
  estimate.twist = velocity();
  estimate.segment = segment_;
  return estimate;
}

const DeskewedScan& KnotFrontEnd::deskewed_scan() const {
  if (to_deskew_.scan != nullptr) {
    const PreparedScan& scan = *to_deskew_.scan;
    last_scan_ = {deskew(scan, to_deskew_.trajectory, session_.workers), scan.intensities};
    to_deskew_.scan = nullptr;
  }
  return last_scan_;
}

}  // namespace surefoot
