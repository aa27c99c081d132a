// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_places.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "methods/knots/place_trials.hpp"

namespace surefoot {

namespace {

// Another place than the registration's is looked for so much farther away [m]: who was carried, or
// turned by hand, went faster than it walks.
constexpr double kLeeway = 2.0;
constexpr std::int64_t kLeewayNs = 500'000'000;

constexpr std::size_t kPoints = 150;  // to look with, coarsely
constexpr std::size_t kPlaces = 4;    // to register at
constexpr std::size_t kTwins = 12;    // to register at, before a place is believed

/// Points of an upright carrier's scan.
std::vector<Eigen::Vector3d> some_of(const PreparedScan& scan,
                                     const std::vector<std::uint32_t>& chosen,
                                     const Eigen::Quaterniond& mount) {
  std::vector<Eigen::Vector3d> points;
  const std::size_t stride = std::max<std::size_t>(chosen.size() / kPoints, 1);
  for (std::size_t i = 0; i < chosen.size(); i += stride) {
    points.emplace_back(mount.conjugate() * scan.points[chosen[i]].cast<double>());
  }
  return points;
}

/// The places of a region that a scan fits best, coarsely: best first.
std::vector<PlaceFit> places_in(const KnotTrack& track, const PreparedScan& scan,
                                const std::vector<std::uint32_t>& chosen,
                                const SearchRegion& region, std::size_t most,
                                const SearchEffort& effort) {
  track.session().begin_step(Step::search);
  const Eigen::Quaterniond& mount = track.mount();
  auto places = search_places(track.map().surfels(), some_of(scan, chosen, mount), region,
                              track.way(), most, effort, track.session().workers);
  for (PlaceFit& place : places) place.pose = lidar_on(place.pose, mount);
  return places;
}

/// At each place: whoever was carried stands; whoever lost himself in a turn still goes.
std::vector<PlaceStart> starts_at(const std::vector<PlaceFit>& places, const VelocityModel& model) {
  std::vector<PlaceStart> starts;
  for (const PlaceFit& place : places) {
    starts.push_back({place.pose, Twist::Zero()});
    starts.push_back({place.pose, model.mean(place.pose.rotation)});
  }
  return starts;
}

/// At the best places by a coarse look, `most` at most, if the very best is another.
double rival_in(const KnotTrack& track, const SearchRegion& region, std::size_t most,
                const ScanPart& thinned, const RegisteredScan& registered) {
  const PreparedScan& scan = thinned.scan;
  const auto chosen = track.chosen_in_passing(thinned);
  const auto places = places_in(track, scan, chosen, region, most, kGlance);
  const Pose here = registered.trajectory.at(0.5);
  const Whereabouts about = track.whereabouts();
  if (places.empty() || same_place(places[0].pose, here)) return 0.0;
  const KnotProblem problem = track.problem(registered.begin);
  const PlaceTrials trials(scan, chosen, problem);
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

}  // namespace

double rival_beside(const KnotTrack& track, const ScanPart& thinned,
                    const RegisteredScan& registered) {
  SearchRegion region = track.whereabouts().walked(thinned.scan.end_ns + kLeewayNs);
  region.radius += kLeeway;
  return rival_in(track, region, 1, thinned, registered);
}

double rival_anywhere(const KnotTrack& track, const ScanPart& thinned,
                      const RegisteredScan& registered) {
  return rival_in(track, track.whereabouts().anywhere(), kPlaces, thinned, registered);
}

std::optional<RegisteredScan> find_place(KnotTrack& track, const ScanPart& thinned,
                                         const SearchRegion& region, bool left) {
  const PreparedScan& scan = thinned.scan;
  const auto chosen = track.choose(thinned);
  std::vector<PlaceFit> places = places_in(track, scan, chosen, region, kPlaces, kThorough);
  if (!left) {
    const SearchRegion straight_on = track.whereabouts().straight_on(scan.start_ns);
    const auto ahead = places_in(track, scan, chosen, straight_on, 1, kThorough);
    if (!ahead.empty()) places.push_back(ahead.front());
  }
  const KnotProblem problem = track.problem(track.end());
  auto trials = PlaceTrials(scan, chosen, problem).from(starts_at(places, track.model()));
  std::erase_if(
      trials, [&](const PlaceTrial& trial) { return !region.is_as_high(trial.pose.translation); });
  if (trials.empty()) return std::nullopt;
  const PlaceTrial& best = trials[0];
  const bool alike =
      trials.size() > 1 && trials[1].disagreement < kClearlyBetter * best.disagreement;
  if (alike) return std::nullopt;
  auto found = track.register_from(best.begin, best.predicted, best.window, scan, chosen);
  if (!found || !region.is_as_high(found->trajectory.at(0.5).translation)) return std::nullopt;
  // [K33] of the best place against the second best.
  if (trials.size() > 1) {
    found->estimate.evidence.rival =
        -strength(trials[1].disagreement / std::max(best.disagreement, 1e-3));
  }
  return found;
}

bool has_twin(const KnotTrack& track, const ScanPart& thinned, const RegisteredScan& found,
              bool left) {
  const PreparedScan& scan = thinned.scan;
  const Pose here = found.trajectory.at(0.5);
  const Whereabouts about = track.whereabouts();
  const bool straight_on = !left && same_place(here, about.going_straight_on(scan.start_ns));
  const auto chosen = track.chosen_in_passing(thinned);
  const SearchRegion region = left ? about.anywhere_about(here.translation) : about.anywhere();
  std::vector<PlaceFit> places = places_in(track, scan, chosen, region, kTwins, kThorough);
  std::erase_if(places, [&](const PlaceFit& place) { return same_place(place.pose, here); });
  const KnotProblem problem = track.problem(found.begin);
  const PlaceTrials trials(scan, chosen, problem);
  const double disagreement = trials.disagreement_at(found.bent);
  const std::vector<PlaceTrial> others =
      trials.from(starts_at(places, track.model()), disagreement);
  const double alike = disagreement * (straight_on ? 1.0 / kClearlyBetter : kClearlyBetter);
  return std::any_of(others.begin(), others.end(), [&](const PlaceTrial& other) {
    return !same_place(other.pose, here) && other.disagreement < alike;
  });
}

}  // namespace surefoot
