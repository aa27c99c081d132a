// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a registered scan is told as: pose, covariance, weak directions, and whether it is right.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/health.hpp"
#include "core/information.hpp"
#include "methods/knots/drift.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "methods/knots/verdict_weights.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// What the evidence is counted from: [m], [s].
constexpr double kKnown = 0.01, kUsualPeriod = 0.1;

constexpr double kSuddenlyNew = 2.0;  // times as much as usual that the map does not have
constexpr int kYoung = 20;            // scans: a map of fewer is young
constexpr double kFollows = 1.5;      // usual periods since the last scan, or one is missing

}  // namespace

void KnotFrontEnd::conclude(const PreparedScan& scan, std::size_t points,
                            Registered& registered) const {
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
      judge_registration({T_0, T_map_lidar, found.matches, points}, config_.health);
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
  report_weak_directions(held, found.squared_distance, T_map_lidar, config_.health, estimate);
}

/// What a trusted scan does not hold may have moved since one last did.
void KnotFrontEnd::let_drift(Registered& registered) {
  Estimate& estimate = registered.estimate;
  const std::int64_t mid_ns = registered.trajectory.mid_ns();
  if (estimate.degenerate.empty()) held_ns_ = mid_ns;
  const NormalEquations<6>& rigid = registered.found.rigid;
  const double distance =
      std::sqrt(registered.found.squared_distance / std::max(rigid.weight, 1e-12));
  const Drift drift = drift_along(estimate.degenerate, std::max(distance, 1e-3),
                                  std::max(seconds(mid_ns - held_ns_), 0.0));
  estimate.covariance += drift.covariance;
  estimate.wrong_probability =
      1.0 - (1.0 - estimate.wrong_probability) * (1.0 - drift.wrong_probability);
}

/// A pose that is wrong as probably as a lost one's, but was not lost since a direction was named
/// that was not held, is no better than those of the scans that named it.
void KnotFrontEnd::name_weakness_of_late(Registered& registered) {
  Estimate& estimate = registered.estimate;
  if (!estimate.degenerate.empty()) {
    weak_of_late_ = estimate.degenerate;
    return;
  }
  if (estimate.wrong_probability <= config_.knots.lost_probability) weak_of_late_.clear();
  if (weak_of_late_.empty()) return;
  estimate.status = Status::degenerate;
  estimate.degenerate = weak_of_late_;
  estimate.message = "of late scans hardly constrained:";
  for (DegenerateDirection& weak : estimate.degenerate) {
    weak.name = name_direction(weak.direction, registered.trajectory.at(0.5));
    estimate.message += ' ' + weak.name;
  }
}

/// What speaks against a registration.
void KnotFrontEnd::judge(const PreparedScan& scan, const View& view, Registered& registered) const {
  const KnotRegistration& found = registered.found;
  const bool slides = !registered.estimate.degenerate.empty();
  const bool settled = has_settled(found.converged, found.settling, slides);
  registered.signs = {found.misfit_of_seen(), found.unseen,
                      map_.views().contradiction(view, session_.workers),
                      registered.begin.prior.surprise(found.window), settled ? 0.0 : 1.0};
  Evidence& evidence = registered.estimate.evidence = usual_signs_.compare(registered.signs);
  evidence.uncertainty = strength(registered.told.deviation / kKnown);
  evidence.gap = strength(whereabouts().since(scan.mid_ns()) / kUsualPeriod);
  evidence.frozen = seen_again_ ? model_.walking() : 0.0;
}

/// How probably a scan went wrong; where what speaks against it leaves doubt, whether another place
/// fits better is asked, too.
double KnotFrontEnd::hazard_of(const ScanPart& thinned, const View& view,
                               Registered& registered) const {
  judge(thinned.scan, view, registered);
  Estimate& estimate = registered.estimate;
  const double alone = hazard(estimate.evidence);
  if (!is_doubtful(alone)) return alone;
  estimate.evidence.rival = rival_beside(thinned, registered);
  // Who suddenly sees much that is new may have been carried to a place that he knows.
  if (estimate.evidence.unseen > strength(kSuddenlyNew)) {
    const double far = rival_anywhere(thinned, registered);
    estimate.evidence.rival = std::max(estimate.evidence.rival, far);
    return hazard_beside_rival(estimate.evidence);
  }
  // Along a weak direction the scan fits everywhere; that it is weak is told.
  if (!estimate.degenerate.empty()) return hazard(estimate.evidence);
  return hazard_beside_rival(estimate.evidence);
}

/// What of a scan's hazard is a reason to leave the map. That a young one holds a direction badly
/// is none, where that direction is named and no scan is missing: the next map would hold it no
/// better.
double KnotFrontEnd::objection_of(const Estimate& estimate, double hazard_now) const {
  const bool follows = estimate.evidence.gap < strength(kFollows);
  if (agreed_ >= kYoung || !follows || estimate.degenerate.empty()) return hazard_now;
  Evidence others = estimate.evidence;
  others.uncertainty = 0.0;
  return hazard(others);
}

/// To begin a map of few scans anew costs little: there a single scan is held to what poses are
/// held to in all.
bool KnotFrontEnd::is_lost(double objection, double of_all) const {
  const double most = config_.knots.lost_probability;
  return of_all > most || (agreed_ < kAgree && most < 1.0 && objection > kVerdictBase);
}

}  // namespace surefoot
