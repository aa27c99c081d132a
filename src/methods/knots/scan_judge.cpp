// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/scan_judge.hpp"

#include <algorithm>
#include <cmath>

#include "core/information.hpp"
#include "methods/knots/drift.hpp"
#include "methods/knots/knot_places.hpp"
#include "methods/knots/verdict_weights.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// What the evidence is counted from: [m], and of scans that are shorter [s].
constexpr double kKnown = 0.01, kUsualPeriod = 0.1;

constexpr double kSuddenlyNew = 2.0;  // times as much as usual that the map does not have
constexpr int kYoung = 20;            // scans: a map of fewer is young
constexpr double kFollows = 1.5;      // usual periods since the last scan, or one is missing

}  // namespace

void ScanJudge::begin(std::int64_t instant_ns) {
  usual_ = {};
  forget_verdicts();
  weak_of_late_.clear();
  held_ns_ = instant_ns;
}

void ScanJudge::weigh(const KnotTrack& track, const PreparedScan& scan, const View& view,
                      bool seen_again, RegisteredScan& registered) const {
  const KnotRegistration& found = registered.found;
  const bool slides = !registered.estimate.degenerate.empty();
  const bool settled = has_settled(found.converged, found.settling, slides);
  registered.signs = {found.misfit_of_seen(), found.unseen,
                      track.map().views().contradiction(view, track.session().workers),
                      registered.begin.prior.surprise(found.window), settled ? 0.0 : 1.0};
  Evidence& evidence = registered.estimate.evidence = usual_.compare(registered.signs);
  evidence.uncertainty = strength(registered.told.deviation / kKnown);
  // That a sweep takes its time is no gap.
  const double period = std::max(seconds(scan.end_ns - scan.start_ns), kUsualPeriod);
  evidence.gap = strength(track.whereabouts().since(scan.mid_ns()) / period);
  evidence.frozen = seen_again ? track.model().walking() : 0.0;
}

double ScanJudge::hazard_of(const KnotTrack& track, const ScanPart& thinned, const View& view,
                            bool seen_again, RegisteredScan& registered) const {
  weigh(track, thinned.scan, view, seen_again, registered);
  Estimate& estimate = registered.estimate;
  const double alone = hazard(estimate.evidence);
  if (!is_doubtful(alone)) return alone;
  estimate.evidence.rival = rival_beside(track, thinned, registered);
  // Who suddenly sees much that is new may have been carried to a place that he knows.
  if (estimate.evidence.unseen > strength(kSuddenlyNew)) {
    const double far = rival_anywhere(track, thinned, registered);
    estimate.evidence.rival = std::max(estimate.evidence.rival, far);
    return hazard_beside_rival(estimate.evidence);
  }
  // Along a weak direction the scan fits everywhere; that it is weak is told.
  if (!estimate.degenerate.empty()) return hazard(estimate.evidence);
  return hazard_beside_rival(estimate.evidence);
}

/// To begin a map of few scans anew costs little: there a single scan is held to what poses are
/// held to in all.
bool ScanJudge::is_lost(double hazard_now, int agreed, Estimate& estimate) {
  estimate.wrong_probability = wrong_probability_with(hazard_now);
  const double objection = objection_of(estimate, hazard_now, agreed);
  const double most = config_.knots.lost_probability;
  return objections_.add(objection) > most ||
         (agreed < kAgree && most < 1.0 && objection > kVerdictBase);
}

/// What of a scan's hazard is a reason to leave the map. That a young one holds a direction badly
/// is none, where that direction is named and no scan is missing: the next map would hold it no
/// better.
double ScanJudge::objection_of(const Estimate& estimate, double hazard_now, int agreed) {
  const bool follows = estimate.evidence.gap < strength(kFollows);
  if (agreed >= kYoung || !follows || estimate.degenerate.empty()) return hazard_now;
  Evidence others = estimate.evidence;
  others.uncertainty = 0.0;
  return hazard(others);
}

void ScanJudge::forget_verdicts() {
  verdict_.clear();
  objections_.clear();
}

void ScanJudge::accept(RegisteredScan& registered, double right) {
  usual_.learn(registered.signs, right, config_.knots.usual_rate);
  let_drift(registered);
  name_weakness_of_late(registered);
}

/// What a trusted scan does not hold may have moved since one last did.
void ScanJudge::let_drift(RegisteredScan& registered) {
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
void ScanJudge::name_weakness_of_late(RegisteredScan& registered) {
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
  name_directions(registered.trajectory.at(0.5), estimate.degenerate);
  for (const DegenerateDirection& weak : estimate.degenerate) estimate.message += ' ' + weak.name;
}

}  // namespace surefoot
