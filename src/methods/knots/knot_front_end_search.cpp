// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the front-end does while it is lost. docs/method.md, "Lost".
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "core/information.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "methods/knots/knot_search.hpp"
#include "methods/knots/verdict_weights.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// The region grows from so far [m, rad], up to so far, by the speed [m/s] of who is carried, or by
// so many times the mean speed of who walks on, and at least so much; it turns by so much a second.
constexpr double kReach = 1.0, kMostReach = 25.0, kCarried = 5.0, kHurries = 1.25, kSlowest = 0.5;
constexpr double kTurn = 0.5, kTurnSpeed = 1.5;
constexpr double kAhead = 1.5, kAheadTurn = 0.4;  // of who walked straight on

// [m] Who has climbed on so far may be so high that the storey below, which looks alike, is as high
// as he was.
constexpr double kWayOfAStorey = 3.0;

// Another place than the registration's is looked for so much farther away [m]: who was carried, or
// turned by hand, went faster than it walks.
constexpr double kLeeway = 2.0;
constexpr std::int64_t kLeewayNs = 500'000'000;

// A large region is gone through at every so many-th scan.
constexpr int kSeldom = 5;

constexpr std::size_t kPoints = 150;  // to look with, coarsely
constexpr std::size_t kPlaces = 4;    // to register at
constexpr std::size_t kTwins = 12;    // to register at, before a place is believed

// What has not settled after so many iterations is hardly a place that is believed.
constexpr int kMostIterations = 40;

// So much more doubt is allowed straight after the scan that went wrong: where the robot would be
// had that one not come is a likelier place than one that was looked for.
constexpr double kStraightOn = 2.0;

// A scan fewer of whose beams can tell of a place than this share believes none: a covered sensor
// sees nothing that speaks against any.
constexpr double kBlind = 0.1;

std::vector<Eigen::Vector3d> some_of(const PreparedScan& scan,
                                     const std::vector<std::uint32_t>& chosen) {
  std::vector<Eigen::Vector3d> points;
  const std::size_t stride = std::max<std::size_t>(chosen.size() / kPoints, 1);
  for (std::size_t i = 0; i < chosen.size(); i += stride) {
    points.emplace_back(scan.points[chosen[i]].cast<double>());
  }
  return points;
}

/// How probably a registration of who is lost is wrong. `far`: it was looked for in a large region.
double hazard_where_lost(bool far, Estimate& estimate) {
  const auto slides = [](const DegenerateDirection& weak) {
    return weak.name != "roll" && weak.name != "pitch";
  };
  const bool any = std::any_of(estimate.degenerate.begin(), estimate.degenerate.end(), slides);
  estimate.evidence = evidence_where_lost(estimate.evidence, any, far);
  return hazard(estimate.evidence);
}

}  // namespace

/// Where one may be who goes so fast, the longer after the last trusted scan the farther from it.
/// Who is seen all the while does not come to another storey, which looks as this one does; and who
/// climbs, to a storey that is not known yet, is not found where he came from.
SearchRegion KnotFrontEnd::region_within(double speed, std::int64_t instant_ns) const {
  const double since = std::max(since_trusted(instant_ns), 0.0);
  // [K30]
  SearchRegion region{end_.prior.means[1], std::min(kReach + speed * since, kMostReach),
                      std::min(kTurn + kTurnSpeed * since, std::numbers::pi)};
  if (search_ && search_->after_hole) return region;
  const double climb = way_.climb_of_late();
  if (climb == 0.0 && !way_.has_storeys(region.centre.translation, region.radius)) return region;
  region.keep_to_storey(climb);
  return region;
}

/// Whether who climbs may have come to where the next storey looks as this one does here.
bool KnotFrontEnd::may_be_a_storey_on(std::int64_t instant_ns) const {
  if (search_->after_hole || way_.climb_of_late() == 0.0) return false;
  return std::max(mean_speed(), kSlowest) * since_trusted(instant_ns) > kWayOfAStorey;
}

/// Where it may be if it went on as it walked.
SearchRegion KnotFrontEnd::region_walked(std::int64_t instant_ns) const {
  return region_within(std::max(kHurries * mean_speed(), kSlowest), instant_ns);
}

/// Where it may be if it was carried.
SearchRegion KnotFrontEnd::region_carried(std::int64_t instant_ns) const {
  return region_within(kCarried, instant_ns);
}

/// About where it would be had it walked straight on.
SearchRegion KnotFrontEnd::straight_on(std::int64_t instant_ns) const {
  const Pose& last = end_.prior.means[1];
  const Eigen::Vector3d way = since_trusted(instant_ns) * model_.mean(last.rotation).head<3>();
  const double heading = roll_pitch_yaw(last.rotation).z();
  SearchRegion ahead{way_.stand_at(last.translation + way, heading), kAhead, kAheadTurn};
  ahead.keep_to_storey(0.0);
  return ahead;
}

/// A scan where it would be had it walked straight on, unseen: as high as the ground of its way
/// goes on there, or as it climbed of late.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_ahead(
    const PreparedScan& scan, const std::vector<std::uint32_t>& thinned) {
  const Pose level = straight_on(scan.start_ns).centre;
  const Twist going = model_.mean(level.rotation);
  const auto chosen = choice_.choose(scan, thinned, session_.workers);
  std::optional<Registered> best = register_at({level, going}, scan, chosen);
  Pose climbing = level;
  const Pose& last = end_.prior.means[1];
  climbing.translation.z() =
      last.translation.z() + since_trusted(scan.start_ns) * model_.mean(last.rotation).z();
  auto other = register_at({climbing, going}, scan, chosen);
  const bool better =
      other && other->estimate.trusted() &&
      (!best || !best->estimate.trusted() || disagreement_of(*other) < disagreement_of(*best));
  return better ? std::move(other) : std::move(best);
}

/// Where a lost one is looked for by the scan whose turn it is; nowhere by some of those for which
/// it would be far.
std::optional<SearchRegion> KnotFrontEnd::region_of_turn(std::int64_t instant_ns) const {
  const SearchRegion carried = region_carried(instant_ns), walked = region_walked(instant_ns);
  const int turn = search_->scans % kSeldom;
  if (!carried.large() || turn == kSeldom - 1) return carried;
  if (!walked.large() || turn == 0) return walked;
  return std::nullopt;
}

/// The places of a region that a scan fits best, coarsely: best first.
std::vector<PlaceFit> KnotFrontEnd::places_in(const PreparedScan& scan,
                                              const std::vector<std::uint32_t>& chosen,
                                              const SearchRegion& region, std::size_t most) const {
  session_.begin_step(Step::search);
  return search_places(map_.surfels(), some_of(scan, chosen), region, way_, most, session_.workers);
}

/// A scan where it is thought to begin, from some motion; none if that is not solved. From far away
/// it takes its time: whether it settles is told by a second one, from where the first ended.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_from(
    const KnotEnd& begin, const KnotWindow& predicted, const KnotWindow& start,
    const PreparedScan& scan, const std::vector<std::uint32_t>& chosen) const {
  Registered here{begin, predicted};
  KnotPoints points = sort_points(scan, chosen, predicted);
  Config::Knots config = config_.knots;
  config.max_iterations = std::min(config.max_iterations, kMostIterations);
  const KnotProblem problem{map_.surfels(), begin.prior,      model_,
                            config,         session_.workers, session_.begin_step};
  here.found = register_in_attempts(points, problem, start, usual_);
  if (here.found.solved && !has_settled(here.found.converged, here.found.settling, false)) {
    here.found = register_knots(points, problem, here.found.window, usual_annealing(config));
  }
  if (!here.found.solved) return std::nullopt;
  conclude(scan, points.points.size(), here);
  return here;
}

/// Likewise, at a place and a velocity.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_at(
    const PlaceStart& start, const PreparedScan& scan,
    const std::vector<std::uint32_t>& chosen) const {
  const KnotEnd begin = begin_at(start.place, scan, config_.knots);
  const KnotWindow predicted =
      predict_knots(scan, begin, model_, config_.knots).at_velocity(start.velocity);
  return register_from(begin, predicted, predicted, scan, chosen);
}

/// At each place: whoever was carried stands; whoever lost himself in a turn still goes.
std::vector<PlaceStart> KnotFrontEnd::starts_at(const std::vector<PlaceFit>& places) const {
  std::vector<PlaceStart> starts;
  for (const PlaceFit& place : places) {
    starts.push_back({place.pose, Twist::Zero()});
    starts.push_back({place.pose, model_.mean(place.pose.rotation)});
  }
  return starts;
}

double KnotFrontEnd::disagreement_of(const Registered& registered) const {
  return registered.found.disagreement(config_.knots.unseen_weight);
}

/// As far as a place is ever looked for, and turned anyhow.
SearchRegion KnotFrontEnd::region_anywhere() const {
  SearchRegion region = region_carried(last_pose_->stamp_ns);
  region.radius = kMostReach;
  region.turn = std::numbers::pi;
  return region;
}

/// How much better the scan fits at another place of a region than where it was registered: at the
/// best ones by a coarse look, `most` at most, if the very best is another.
double KnotFrontEnd::rival_in(const SearchRegion& region, std::size_t most,
                              const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                              const Registered& registered) const {
  PointChoice choice = choice_;  // what is asked here must not change the next scan
  const auto chosen = choice.choose(scan, thinned, session_.workers);
  const auto places = places_in(scan, chosen, region, most);
  const Pose here = registered.trajectory.at(0.5);
  if (places.empty() || same_place(places[0].pose, here)) return 0.0;
  const KnotProblem problem_here = problem(registered.begin);
  const PlaceTrials trials(scan, chosen, problem_here);
  const double disagreement = trials.disagreement_at(registered.bent);
  std::vector<PlaceStart> standing;
  for (const PlaceFit& place : places) standing.push_back({place.pose, Twist::Zero()});
  double rival = 0.0;
  for (const PlaceTrial& other : trials.from(standing, disagreement)) {
    if (same_place(other.pose, here) || is_farther_back(other.pose, scan)) continue;
    if (is_after_hole(scan) && sees_more_new(other.unseen, registered.found.unseen)) continue;
    // [K33]
    rival = std::max(rival, strength(disagreement / std::max(other.disagreement, 1e-3)));
  }
  return rival;
}

/// Of places so near that somebody may have come there since the last scan.
double KnotFrontEnd::rival_beside(const PreparedScan& scan,
                                  const std::vector<std::uint32_t>& thinned,
                                  const Registered& registered) const {
  SearchRegion region = region_walked(scan.end_ns + kLeewayNs);
  region.radius += kLeeway;
  return rival_in(region, 1, scan, thinned, registered);
}

double KnotFrontEnd::rival_anywhere(const PreparedScan& scan,
                                    const std::vector<std::uint32_t>& thinned,
                                    const Registered& registered) const {
  return rival_in(region_anywhere(), kPlaces, scan, thinned, registered);
}

/// The place of the region that fits best, if there is one that fits clearly best.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::find_place(
    const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
    const SearchRegion& region) {
  const auto chosen = choice_.choose(scan, thinned, session_.workers);
  std::vector<PlaceFit> places = places_in(scan, chosen, region, kPlaces);
  const auto ahead = places_in(scan, chosen, straight_on(scan.start_ns), 1);
  if (!ahead.empty()) places.push_back(ahead.front());
  const KnotProblem problem_here = problem(end_);
  auto trials = PlaceTrials(scan, chosen, problem_here).from(starts_at(places));
  std::erase_if(
      trials, [&](const PlaceTrial& trial) { return !region.is_as_high(trial.pose.translation); });
  if (trials.empty()) return std::nullopt;
  const PlaceTrial& best = trials[0];
  const bool alike =
      trials.size() > 1 && trials[1].disagreement < kClearlyBetter * best.disagreement;
  if (alike) return std::nullopt;
  auto found = register_from(best.begin, best.predicted, best.window, scan, chosen);
  const bool as_high = found && region.is_as_high(found->trajectory.at(0.5).translation);
  return as_high ? std::move(found) : std::nullopt;
}

/// Whether a scan fits elsewhere as well as where it was found. Who is found elsewhere than where
/// it would be by itself was carried, nobody knows how far: of places that look alike, none is his.
bool KnotFrontEnd::has_twin(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                            const Registered& registered) const {
  const Pose here = registered.trajectory.at(0.5);
  if (same_place(here, straight_on(scan.start_ns).centre)) return false;
  PointChoice choice = choice_;  // what is asked here must not change the next scan
  const auto chosen = choice.choose(scan, thinned, session_.workers);
  std::vector<PlaceFit> places = places_in(scan, chosen, region_anywhere(), kTwins);
  std::erase_if(places, [&](const PlaceFit& place) { return same_place(place.pose, here); });
  const KnotProblem problem_here = problem(registered.begin);
  const PlaceTrials trials(scan, chosen, problem_here);
  const double disagreement = trials.disagreement_at(registered.bent);
  const std::vector<PlaceTrial> others = trials.from(starts_at(places), disagreement);
  return std::any_of(others.begin(), others.end(), [&](const PlaceTrial& other) {
    return !same_place(other.pose, here) && other.disagreement < kClearlyBetter * disagreement;
  });
}

/// A scan right after one that went wrong: where it would be had that one not come. One scan of
/// garbage is no reason to look elsewhere.
std::optional<Estimate> KnotFrontEnd::go_on(const PreparedScan& scan,
                                            const std::vector<std::uint32_t>& thinned) {
  if (!can_be_placed() || is_after_hole(scan)) return std::nullopt;
  Registered next = register_scan(scan, thinned, beginning_of(scan, end_, model_, config_));
  if (!next.estimate.trusted()) return std::nullopt;
  View view = look(scan, thinned, next.trajectory);
  judge(scan, view, next);
  const double hazard_now = hazard_where_lost(false, next.estimate);
  if (is_doubtful(hazard_now / kStraightOn)) return std::nullopt;
  search_.reset();
  forget_verdicts();
  next.estimate.wrong_probability = verdict_.add(hazard_now);
  return accept(hazard_now, std::move(view), std::move(next));
}

/// A scan where another one was found, or at a place of the region whose turn it is.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_lost(
    const PreparedScan& scan, const std::vector<std::uint32_t>& thinned) {
  if (search_->found) {
    return register_scan(scan, thinned, beginning_of(scan, *search_->found, model_, config_));
  }
  const auto region = region_of_turn(scan.end_ns);
  if (!region || !can_be_placed()) return std::nullopt;
  search_->far = region->large();
  return find_place(scan, thinned, *region);
}

/// A scan while it is lost: finds a place, or holds another scan against the one that was found.
Estimate KnotFrontEnd::search(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned) {
  const bool confirms = search_->found.has_value();
  if (!confirms) {
    if (std::optional<Estimate> next = go_on(scan, thinned)) return std::move(*next);
  }
  std::optional<Registered> best = register_lost(scan, thinned);
  ++search_->scans;
  bool right = false;
  if (best && best->estimate.trusted() && can_be_placed()) {
    View view = look(scan, thinned, best->trajectory);
    judge(scan, view, *best);
    if (!confirms) best->estimate.evidence.motion = 0.0;
    const double hazard_now = best->estimate.wrong_probability =
        hazard_where_lost(search_->far, best->estimate);
    right = !is_doubtful(hazard_now) && view.beams.telling() > kBlind;
    const bool agreed = right && search_->agreed + 1 >= kAgree;
    right = right && !(agreed && has_twin(scan, thinned, *best));
    if (right && agreed) {
      search_.reset();
      forget_verdicts();
      best->estimate.message = "found itself again";
      return accept(hazard_now, std::move(view), std::move(*best));
    }
  }
  search_->agreed = right ? search_->agreed + 1 : 0;
  search_->found.reset();
  if (right) search_->found = end_of(best->found.window, best->found.last_two);
  return stay_lost(scan, thinned);
}

/// The pose is the one predicted for the scan that went wrong; who has searched in vain for long
/// begins anew.
Estimate KnotFrontEnd::stay_lost(const PreparedScan& scan,
                                 const std::vector<std::uint32_t>& thinned) {
  // A map of few scans is not worth many more of them.
  const int most = std::min(config_.knots.search_scans, kAgree * agreed_);
  const bool in_vain = search_->scans > most || may_be_a_storey_on(scan.end_ns);
  if (in_vain && !search_->found && !seen_again_) return begin_map(scan, thinned);
  Estimate estimate;
  estimate.status = Status::lost;
  estimate.message = search_->found ? "a place was found, and is to be confirmed" : "searching";
  estimate.covariance = unregistered_covariance(config_.health);
  const Pose& last = end_.prior.means[1];
  const ScanTrajectory guess({last, last}, scan.start_ns, scan.end_ns);
  to_deskew_ = {&scan, guess};
  return publish(guess, std::move(estimate));
}

}  // namespace surefoot
