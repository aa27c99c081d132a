// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the front-end does while it is lost. docs/method.md, "Lost".
#include <algorithm>
#include <utility>

#include "core/information.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "methods/knots/knot_places.hpp"

namespace surefoot {

namespace {

// So much more doubt is allowed straight after the scan that went wrong: where the robot would be
// had that one not come is a likelier place than one that was looked for.
constexpr double kStraightOn = 2.0;

// A scan fewer of whose beams can tell of a place than this share believes none: a covered sensor
// sees nothing that speaks against any.
constexpr double kBlind = 0.1;

constexpr int kKept = 20;  // trusted scans of a map that is worth to come back to

/// How probably a registration of who is lost is wrong. `far`: it was looked for in a large region.
double hazard_where_lost(bool far, RegisteredScan& registered) {
  Estimate& estimate = registered.estimate;
  // By its largest part, which need not be its name where several are weak.
  const auto slides = [&](const DegenerateDirection& weak) {
    const std::string name = name_direction(weak.direction, registered.trajectory.at(0.5));
    return name != "roll" && name != "pitch";
  };
  const bool any = std::any_of(estimate.degenerate.begin(), estimate.degenerate.end(), slides);
  estimate.evidence = evidence_where_lost(estimate.evidence, any, far);
  return hazard(estimate.evidence);
}

}  // namespace

/// A scan while it is lost: finds a place, or holds another scan against the one that was found.
Estimate KnotFrontEnd::search(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  const bool confirms = search_->found.has_value();
  if (!confirms && !search_->left && !search_->has_twin) {
    if (std::optional<Estimate> next = go_on(thinned)) return std::move(*next);
  }
  std::optional<RegisteredScan> best = register_lost(thinned);
  ++search_->scans;
  bool right = false;
  if (best && best->estimate.trusted() && can_be_placed()) {
    View view = track_.look(thinned, best->trajectory);
    if (!confirms) search_->rival = best->estimate.evidence.rival;
    judge_.weigh(track_, scan, view, seen_again_, *best);
    best->estimate.evidence.rival = search_->rival;
    if (!confirms) best->estimate.evidence.motion = 0.0;
    const double hazard_now = best->estimate.wrong_probability =
        hazard_where_lost(search_->far, *best);
    right = !is_doubtful(hazard_now) && view.beams.telling() > kBlind;
    const bool agreed = right && search_->agreed + 1 >= search_->needed;
    if (agreed) search_->has_twin = has_twin(track_, thinned, *best, search_->left);
    right = right && !(agreed && search_->has_twin);
    if (right && agreed) {
      best->estimate.message = search_->left ? "came home" : "found itself again";
      end_search();
      since_found_ = 0;
      return accept(scan, hazard_now, std::move(view), std::move(*best));
    }
  }
  search_->agreed = right ? search_->agreed + 1 : 0;
  search_->found.reset();
  if (right) search_->found = track_.end_of(*best);
  return stay_lost(scan);
}

/// A scan right after one that went wrong: where it would be had that one not come. One scan of
/// garbage is no reason to look elsewhere.
std::optional<Estimate> KnotFrontEnd::go_on(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  if (!can_be_placed() || track_.whereabouts().is_after_hole(scan)) return std::nullopt;
  RegisteredScan next =
      track_.register_scan(thinned, beginning_of(scan, track_.end(), track_.model(), config_));
  if (!next.estimate.trusted()) return std::nullopt;
  View view = track_.look(thinned, next.trajectory);
  judge_.weigh(track_, scan, view, seen_again_, next);
  const double hazard_now = hazard_where_lost(false, next);
  if (is_doubtful(hazard_now / kStraightOn)) return std::nullopt;
  end_search();
  next.estimate.wrong_probability = judge_.wrong_probability_with(hazard_now);
  return accept(scan, hazard_now, std::move(view), std::move(next));
}

/// A scan where another one was found, or at a place of the region whose turn it is.
std::optional<RegisteredScan> KnotFrontEnd::register_lost(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  if (search_->found) {
    return track_.register_scan(thinned,
                                beginning_of(scan, *search_->found, track_.model(), config_));
  }
  const Whereabouts about = track_.whereabouts();
  const auto region =
      search_->left ? about.come_back(search_->scans) : about.of_turn(search_->scans, scan.end_ns);
  if (!region || !can_be_placed()) return std::nullopt;
  search_->far = region->large();
  return find_place(track_, thinned, *region, search_->left);
}

/// Who is lost again soon after he was found was found wrongly, or is where places are hard to
/// tell: each time more scans must agree.
void KnotFrontEnd::begin_search() {
  relapses_ = since_found_ < kSettled ? relapses_ + 1 : 0;
  search_ = PoseSearch{};
  search_->needed = kAgree * (1 + relapses_);
}

void KnotFrontEnd::end_search() {
  search_.reset();
  track_.may_have_walked_unseen(false);
  judge_.forget_verdicts();
}

bool KnotFrontEnd::is_worth_keeping(std::int64_t instant_ns) const {
  return agreed() >= kKept && !track_.whereabouts().may_be_a_storey_on(instant_ns);
}

void KnotFrontEnd::leave() {
  search_ = PoseSearch{};
  search_->left = true;
  track_.may_have_walked_unseen(false);
  in_vain_ = false;
}

/// The pose is the one predicted for the scan that went wrong. Who has searched for long does so in
/// vain.
Estimate KnotFrontEnd::stay_lost(const PreparedScan& scan) {
  // A map of few scans is not worth many more of them.
  const int most = std::min(config_.knots.search_scans, kAgree * agreed());
  const bool too_long =
      search_->scans > most || track_.whereabouts().may_be_a_storey_on(scan.end_ns);
  in_vain_ = too_long && !search_->left && !search_->found && !seen_again_;
  Estimate estimate;
  estimate.status = Status::lost;
  estimate.message = search_->found ? "a place was found, and is to be confirmed" : "searching";
  estimate.covariance = unregistered_covariance(config_.health);
  const Pose& last = track_.end().prior.means[1];
  return publish(scan, {{last, last}, scan.start_ns, scan.end_ns}, std::move(estimate));
}

}  // namespace surefoot
