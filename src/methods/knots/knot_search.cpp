// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "methods/knots/surfel_lookup.hpp"

namespace surefoot {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// First as finely as walls at some ten metres allow, then so often twice as finely.
constexpr double kStep = 1.0, kTurnStep = 12.0 * kDegree;  // [m], [rad]
constexpr int kRefinements = 2;

/// A round weighs places by some of the points; the best go on to the next one, of more points.
struct Round {
  std::size_t stride;  // every so many-th point
  double kept;         // share of all places
  std::size_t fewest;  // places that are kept, however many there are
};
// The best place of a large region was always among these. docs/tried.md, "Lost and search".
constexpr Round kRounds[] = {{27, 0.4, 1500}, {9, 0.12, 1500}, {3, 0.012, 600}, {1, 1.0, 0}};
constexpr Round kRefiningRounds[] = {{18, 0.5, 0}, {6, 0.2, 4 * kGlance.refined}, {2, 1.0, 0}};

// [rad] Ground is tilted otherwise beside the way, and who stands on stones is tilted by them.
constexpr double kTilt = 12.0 * kDegree;
constexpr std::size_t kSettlingStride = 2;  // every so many-th point tells which way

// Two places are one if they are nearer.
constexpr double kApart = 0.8, kTurnApart = 15.0 * kDegree;  // [m], [rad]

// [m] Heights that are another storey's; of who climbs, those of where he came from.
constexpr double kOtherStorey = 1.5, kCameFrom = 0.75;

// What points lie off a surfel that fits [m], at the first step.
constexpr double kScale = 0.35;

/// How finely to look.
struct Grain {
  double step;   // [m]
  double turn;   // [rad]
  double scale;  // [m]
};

/// Of a point, by how far it lies off its surfel.
double fit_of(const Eigen::Vector3d& place, const Surfel& surfel, double scale) {
  double fit = 0.0;
  for (int d = 0; d < surfel.directions; ++d) {
    const double residual = surfel.across(d).dot(place - surfel.mean);
    const double variance = scale * scale + surfel.variance(d);
    fit += 1.0 / (1.0 + residual * residual / variance);  // [K29]
  }
  return fit / surfel.directions;
}

/// A map asked from the same grid on.
struct FinelyAsked {
  const SurfelMap& map;
  int finest;

  [[nodiscard]] const Surfel* find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray) const {
    return map.find(place, ray, finest);
  }
};

/// About what some points show from some places [m].
Eigen::AlignedBox3d box_of(const std::vector<PlaceFit>& places,
                           const std::vector<Eigen::Vector3d>& points) {
  constexpr double kUneven = 3.0;  // [m] by which a tilt lifts or lowers most points at most
  Eigen::AlignedBox3d stands, seen;
  for (const PlaceFit& place : places) stands.extend(place.pose.translation);
  double range = 0.0;
  for (const Eigen::Vector3d& point : points) {
    range = std::max(range, point.head<2>().norm());
    seen.extend(point);
  }
  const Eigen::Vector3d below(range, range, kUneven - seen.min().z());
  const Eigen::Vector3d above(range, range, kUneven + seen.max().z());
  return {stands.min() - below, stands.max() + above};
}

/// The sum over every so many-th point, but for those of the round before.
template <typename Map>
double fit_of(const Map& map, const std::vector<Eigen::Vector3d>& points, std::size_t stride,
              std::size_t before, const Pose& pose, double scale) {
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (before > 0 && i % before == 0) continue;
    const Eigen::Vector3d ray = R * points[i];
    const Eigen::Vector3d place = ray + pose.translation;
    const Surfel* const surfel = map.find(place, ray);
    if (surfel != nullptr) sum += fit_of(place, *surfel, scale);
  }
  return sum;
}

double heading(const Pose& pose) { return roll_pitch_yaw(pose.rotation).z(); }

/// So many steps of so much [rad] to the right, up to as many to the left.
std::vector<Eigen::Quaterniond> turns_of(int steps, double step) {
  std::vector<Eigen::Quaterniond> turns;
  for (int turn = -steps; turn <= steps; ++turn) {
    turns.emplace_back(Eigen::AngleAxisd(turn * step, Eigen::Vector3d::UnitZ()));
  }
  return turns;
}

/// To the right and to the left.
std::vector<Eigen::Quaterniond> turns_aside(double angle) {
  return {so3_exp({0.0, 0.0, -angle}), so3_exp({0.0, 0.0, angle})};
}

/// To every side, and between.
std::vector<Eigen::Quaterniond> tilts_of(double angle) {
  std::vector<Eigen::Quaterniond> tilts;
  for (int roll = -1; roll <= 1; ++roll) {
    for (int pitch = -1; pitch <= 1; ++pitch) {
      if (roll != 0 || pitch != 0) tilts.push_back(so3_exp({angle * roll, angle * pitch, 0.0}));
    }
  }
  return tilts;
}

Pose turned(const Pose& pose, const Eigen::Quaterniond& turn) {
  return {(pose.rotation * turn).normalized(), pose.translation};
}

/// On the ground of the way, and near the centre on a level with it: stairs leave the way steeply.
std::vector<PlaceFit> places_of(const SearchRegion& region, const Grain& grain,
                                const WalkedWay& way) {
  std::vector<PlaceFit> places;
  const int reach = static_cast<int>(region.radius / grain.step);
  const auto turns =
      turns_of(static_cast<int>(std::min(region.turn, std::numbers::pi) / grain.turn), grain.turn);
  const double yaw = heading(region.centre);
  const Eigen::Vector3d& centre = region.centre.translation;
  const auto add = [&](const Pose& stand) {
    for (const Eigen::Quaterniond& turn : turns) places.push_back({turned(stand, turn)});
  };
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      const Eigen::Vector2d aside = grain.step * Eigen::Vector2d(x, y);
      if (aside.norm() > region.radius) continue;
      const Eigen::Vector3d level = centre + Eigen::Vector3d(aside.x(), aside.y(), 0.0);
      for (const Pose& stand : way.stands_at(level.head<2>(), yaw)) {
        if (region.is_as_high(stand.translation)) add(stand);
      }
      if (!region.large()) add({so3_exp({0.0, 0.0, yaw}), level});
    }
  }
  return places;
}

/// About one of those before, and higher and lower: ground is not even.
void add_places_about(const Pose& pose, const Grain& grain, const SearchRegion& region,
                      std::vector<PlaceFit>& places) {
  const auto turns = turns_of(1, grain.turn);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int rise = -2; rise <= 2; ++rise) {
        for (const Eigen::Quaterniond& turn : turns) {
          Pose place = turned(pose, turn);
          place.translation += grain.step * Eigen::Vector3d(x, y, rise);
          if (region.is_as_high(place.translation)) places.push_back({place});
        }
      }
    }
  }
}

bool better(const PlaceFit& a, const PlaceFit& b) { return a.fit > b.fit; }

/// Only the best of a round reach the next one.
template <typename Map>
void weigh_in_rounds(std::span<const Round> rounds, const Map& map,
                     const std::vector<Eigen::Vector3d>& points, const Grain& grain,
                     const Workers& workers, std::vector<PlaceFit>& places) {
  const auto all = static_cast<double>(places.size());
  std::size_t before = 0;
  for (const Round& round : rounds) {
    workers.for_each(places.size(), [&](std::size_t i) {
      places[i].fit += fit_of(map, points, round.stride, before, places[i].pose, grain.scale);
    });
    const std::size_t most = std::max(static_cast<std::size_t>(round.kept * all), round.fewest);
    if (places.size() > most) {
      const auto end = places.begin() + static_cast<std::ptrdiff_t>(most);
      std::nth_element(places.begin(), end, places.end(), better);
      places.erase(end, places.end());
    }
    before = round.stride;
  }
  const auto asked = static_cast<double>((points.size() + before - 1) / before);
  for (PlaceFit& place : places) place.fit /= std::max(asked, 1.0);
}

/// Turns every place by half a step if it fits better so, and then tilts it: between the steps of
/// the first grid the true place fits no better than others.
template <typename Map>
void settle(const Map& map, const std::vector<Eigen::Vector3d>& points, const Grain& grain,
            const Workers& workers, std::vector<PlaceFit>& places) {
  const std::vector<Eigen::Quaterniond> kinds[] = {turns_aside(0.5 * grain.turn), tilts_of(kTilt)};
  workers.for_each(places.size(), [&](std::size_t i) {
    const auto fit = [&](const Pose& pose) {
      return PlaceFit{pose, fit_of(map, points, kSettlingStride, 0, pose, grain.scale)};
    };
    PlaceFit best = fit(places[i].pose);
    for (const std::vector<Eigen::Quaterniond>& kind : kinds) {
      const Pose before = best.pose;
      for (const Eigen::Quaterniond& turn : kind) {
        const PlaceFit other = fit(turned(before, turn));
        if (better(other, best)) best = other;
      }
    }
    places[i] = best;
  });
}

}  // namespace

void SearchRegion::keep_to_storey(double climb) {
  below = climb > 0.0 ? kCameFrom : kOtherStorey;
  above = climb < 0.0 ? kCameFrom : kOtherStorey;
}

bool SearchRegion::is_as_high(const Eigen::Vector3d& place) const {
  const double higher = place.z() - centre.translation.z();
  return -below < higher && higher < above;
}

bool same_place(const Pose& a, const Pose& b) {
  return (a.translation - b.translation).norm() < kApart &&
         a.rotation.angularDistance(b.rotation) < kTurnApart;
}

std::vector<PlaceFit> search_places(const SurfelMap& map,
                                    const std::vector<Eigen::Vector3d>& points,
                                    const SearchRegion& region, const WalkedWay& way,
                                    std::size_t most, const SearchEffort& effort,
                                    const Workers& workers) {
  Grain grain{kStep, kTurnStep, kScale};
  std::vector<PlaceFit> places = places_of(region, grain, way);
  if (places.empty() || points.empty()) return {};
  const SurfelLookup lookup(map, map.level_of(grain.step), box_of(places, points));
  weigh_in_rounds(kRounds, lookup, points, grain, workers, places);
  if (effort.settled) settle(lookup, points, grain, workers, places);
  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    const std::vector<PlaceFit> coarse =
        best_apart(std::move(places), std::max(effort.refined, most), better);
    grain = {0.5 * grain.step, 0.5 * grain.turn, 0.7 * grain.scale};
    places.clear();
    for (const PlaceFit& place : coarse) add_places_about(place.pose, grain, region, places);
    const FinelyAsked finely{map, map.level_of(grain.step)};
    weigh_in_rounds(kRefiningRounds, finely, points, grain, workers, places);
  }
  return best_apart(std::move(places), most, better);
}

}  // namespace surefoot
