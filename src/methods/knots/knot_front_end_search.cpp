// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the front-end does while it is lost. docs/method.md, "Lost".
#include <algorithm>
#include <utility>

#include "core/information.hpp"
#include "methods/knots/knot_front_end.hpp"
#include "methods/knots/knot_search.hpp"
#include "methods/knots/verdict_weights.hpp"

namespace surefoot {

namespace {

// Another place than the registration's is looked for so much farther away [m]: who was carried, or
// turned by hand, went faster than it walks.
constexpr double kLeeway = 2.0;
constexpr std::int64_t kLeewayNs = 500'000'000;

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

constexpr int kKept = 20;  // trusted scans of a map that is worth to come back to

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

/// A scan where it would be had it walked straight on, unseen: as high as the ground of its way
/// goes on there, or as it climbed of late.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_ahead(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  const Pose level = whereabouts().going_straight_on(scan.start_ns);
  const Pose climbing = whereabouts().climbing_on(scan.start_ns);
  const Twist going = model_.mean(level.rotation);
  const auto chosen = choose(thinned);
  std::optional<Registered> best = register_at({level, going}, scan, chosen);
  auto other = register_at({climbing, going}, scan, chosen);
  const bool better =
      other && other->estimate.trusted() &&
      (!best || !best->estimate.trusted() || disagreement_of(*other) < disagreement_of(*best));
  return better ? std::move(other) : std::move(best);
}

/// The places of a region that a scan fits best, coarsely: best first.
std::vector<PlaceFit> KnotFrontEnd::places_in(const PreparedScan& scan,
                                              const std::vector<std::uint32_t>& chosen,
                                              const SearchRegion& region, std::size_t most) const {
  session_.begin_step(Step::search);
  std::vector<Eigen::Vector3d> points = some_of(scan, chosen);
  for (Eigen::Vector3d& point : points) point = mount_.conjugate() * point;
  auto places = search_places(map_.surfels(), points, region, way_, most, session_.workers);
  for (PlaceFit& place : places) place.pose = lidar_on(place.pose, mount_);
  return places;
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

/// How much better the scan fits at another place of a region than where it was registered: at the
/// best ones by a coarse look, `most` at most, if the very best is another.
double KnotFrontEnd::rival_in(const SearchRegion& region, std::size_t most, const ScanPart& thinned,
                              const Registered& registered) const {
  const PreparedScan& scan = thinned.scan;
  const auto chosen = chosen_in_passing(thinned);
  const auto places = places_in(scan, chosen, region, most);
  const Pose here = registered.trajectory.at(0.5);
  const Whereabouts about = whereabouts();
  if (places.empty() || same_place(places[0].pose, here)) return 0.0;
  const KnotProblem problem_here = problem(registered.begin);
  const PlaceTrials trials(scan, chosen, problem_here);
  const double disagreement = trials.disagreement_at(registered.bent);
  std::vector<PlaceStart> standing;
  standing.reserve(places.size());
  for (const PlaceFit& place : places) standing.push_back({place.pose, Twist::Zero()});
  double rival = 0.0;
  for (const PlaceTrial& other : trials.from(standing, disagreement)) {
    if (same_place(other.pose, here) || about.is_farther_back(other.pose, scan)) continue;
    if (about.is_after_hole(scan) && sees_more_new(other.unseen, registered.found.unseen)) continue;
    // [K33]
    rival = std::max(rival, strength(disagreement / std::max(other.disagreement, 1e-3)));
  }
  return rival;
}

/// Of places so near that somebody may have come there since the last scan.
double KnotFrontEnd::rival_beside(const ScanPart& thinned, const Registered& registered) const {
  SearchRegion region = whereabouts().walked(thinned.scan.end_ns + kLeewayNs);
  region.radius += kLeeway;
  return rival_in(region, 1, thinned, registered);
}

double KnotFrontEnd::rival_anywhere(const ScanPart& thinned, const Registered& registered) const {
  return rival_in(whereabouts().anywhere(), kPlaces, thinned, registered);
}

/// The place of the region that fits best, if there is one that fits clearly best.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::find_place(const ScanPart& thinned,
                                                                 const SearchRegion& region) {
  const PreparedScan& scan = thinned.scan;
  const auto chosen = choose(thinned);
  std::vector<PlaceFit> places = places_in(scan, chosen, region, kPlaces);
  if (!search_->left) {
    const auto ahead = places_in(scan, chosen, whereabouts().straight_on(scan.start_ns), 1);
    if (!ahead.empty()) places.push_back(ahead.front());
  }
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
bool KnotFrontEnd::has_twin(const ScanPart& thinned, const Registered& registered) const {
  const PreparedScan& scan = thinned.scan;
  const Pose here = registered.trajectory.at(0.5);
  const Whereabouts about = whereabouts();
  if (!search_->left && same_place(here, about.going_straight_on(scan.start_ns))) return false;
  const auto chosen = chosen_in_passing(thinned);
  const SearchRegion region =
      search_->left ? about.anywhere_about(here.translation) : about.anywhere();
  std::vector<PlaceFit> places = places_in(scan, chosen, region, kTwins);
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
std::optional<Estimate> KnotFrontEnd::go_on(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  if (!can_be_placed() || whereabouts().is_after_hole(scan)) return std::nullopt;
  Registered next = register_scan(thinned, beginning_of(scan, end_, model_, config_));
  if (!next.estimate.trusted()) return std::nullopt;
  View view = look(thinned, next.trajectory);
  judge(scan, view, next);
  const double hazard_now = hazard_where_lost(false, next.estimate);
  if (is_doubtful(hazard_now / kStraightOn)) return std::nullopt;
  search_.reset();
  forget_verdicts();
  next.estimate.wrong_probability = verdict_.add(hazard_now);
  return accept(hazard_now, std::move(view), std::move(next));
}

/// A scan where another one was found, or at a place of the region whose turn it is.
std::optional<KnotFrontEnd::Registered> KnotFrontEnd::register_lost(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  if (search_->found) {
    return register_scan(thinned, beginning_of(scan, *search_->found, model_, config_));
  }
  const auto region = search_->left ? whereabouts().come_back(search_->scans)
                                    : whereabouts().of_turn(search_->scans, scan.end_ns);
  if (!region || !can_be_placed()) return std::nullopt;
  search_->far = region->large();
  return find_place(thinned, *region);
}

/// A scan while it is lost: finds a place, or holds another scan against the one that was found.
Estimate KnotFrontEnd::search(const ScanPart& thinned) {
  const bool confirms = search_->found.has_value();
  if (!confirms && !search_->left) {
    if (std::optional<Estimate> next = go_on(thinned)) return std::move(*next);
  }
  std::optional<Registered> best = register_lost(thinned);
  ++search_->scans;
  bool right = false;
  if (best && best->estimate.trusted() && can_be_placed()) {
    View view = look(thinned, best->trajectory);
    judge(thinned.scan, view, *best);
    if (!confirms) best->estimate.evidence.motion = 0.0;
    const double hazard_now = best->estimate.wrong_probability =
        hazard_where_lost(search_->far, best->estimate);
    right = !is_doubtful(hazard_now) && view.beams.telling() > kBlind;
    const bool agreed = right && search_->agreed + 1 >= kAgree;
    right = right && !(agreed && has_twin(thinned, *best));
    if (right && agreed) {
      best->estimate.message = search_->left ? "came home" : "found itself again";
      search_.reset();
      forget_verdicts();
      return accept(hazard_now, std::move(view), std::move(*best));
    }
  }
  search_->agreed = right ? search_->agreed + 1 : 0;
  search_->found.reset();
  if (right) search_->found = end_of(best->found.window, best->found.last_two);
  return stay_lost(thinned);
}

bool KnotFrontEnd::is_worth_keeping(std::int64_t instant_ns) const {
  return agreed_ >= kKept && !whereabouts().may_be_a_storey_on(instant_ns);
}

void KnotFrontEnd::leave() {
  search_ = PoseSearch{};
  search_->left = true;
  in_vain_ = false;
}

/// The pose is the one predicted for the scan that went wrong. Who has searched for long does so in
/// vain.
Estimate KnotFrontEnd::stay_lost(const ScanPart& thinned) {
  const PreparedScan& scan = thinned.scan;
  // A map of few scans is not worth many more of them.
  const int most = std::min(config_.knots.search_scans, kAgree * agreed_);
  const bool too_long = search_->scans > most || whereabouts().may_be_a_storey_on(scan.end_ns);
  in_vain_ = too_long && !search_->left && !search_->found && !seen_again_;
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
