// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/whereabouts.hpp"

#include <algorithm>
#include <numbers>

#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// The region grows from so far [m, rad], up to so far, by the speed [m/s] of who is carried, or by
// so many times the mean speed of who walks on, and at least so much; it turns by so much a second.
constexpr double kFirstReach = 1.0, kMostReach = 25.0, kCarried = 5.0, kHurries = 1.25,
                 kSlowest = 0.5;
constexpr double kFirstTurn = 0.5, kTurnSpeed = 1.5;
constexpr double kAheadReach = 1.5, kAheadTurn = 0.4;  // of who walked straight on

constexpr double kLongStraight = 5.0;  // [s] that one may have walked straight on
constexpr double kBack = 0.8;          // [m] as another place is

// [m] Who has climbed on so far may be so high that the storey below, which looks alike, is as high
// as he was.
constexpr double kWayOfAStorey = 3.0;

// A large region is gone through at every so many-th scan.
constexpr int kSeldom = 5;

}  // namespace

double Whereabouts::since(std::int64_t instant_ns) const {
  return seconds(instant_ns - trusted_ns);
}

bool Whereabouts::is_after_hole(const PreparedScan& scan) const {
  return seconds(scan.start_ns - trusted_end_ns) > extrapolated;
}

bool Whereabouts::is_after_short_hole(const PreparedScan& scan) const {
  return is_after_hole(scan) && seconds(scan.start_ns - trusted_end_ns) <= kLongStraight;
}

bool Whereabouts::is_farther_back(const Pose& place, const PreparedScan& scan) const {
  if (!is_after_short_hole(scan)) return false;
  const Eigen::Vector3d ahead = straight_on(scan.start_ns).centre.translation;
  return (place.translation - ahead).norm() > (last.translation - ahead).norm() + kBack;
}

bool Whereabouts::may_be_a_storey_on(std::int64_t instant_ns) const {
  if (walked_unseen || way.climb_of_late() == 0.0) return false;
  return std::max(model.mean_speed(), kSlowest) * since(instant_ns) > kWayOfAStorey;
}

Pose Whereabouts::last_carrier() const { return carrier_of(last, mount); }

SearchRegion Whereabouts::straight_on(std::int64_t instant_ns) const {
  const Eigen::Vector3d onwards = since(instant_ns) * model.mean(last.rotation).head<3>();
  const double heading = roll_pitch_yaw(last_carrier().rotation).z();
  SearchRegion ahead{way.stand_at(last.translation + onwards, heading), kAheadReach, kAheadTurn};
  ahead.keep_to_storey(0.0);
  return ahead;
}

Pose Whereabouts::going_straight_on(std::int64_t instant_ns) const {
  return lidar_on(straight_on(instant_ns).centre, mount);
}

Pose Whereabouts::climbing_on(std::int64_t instant_ns) const {
  Pose climbing = going_straight_on(instant_ns);
  const double climb = since(instant_ns) * model.mean(last.rotation).z();
  climbing.translation.z() = last.translation.z() + climb;
  return climbing;
}

SearchRegion Whereabouts::walked(std::int64_t instant_ns) const {
  return within(std::max(kHurries * model.mean_speed(), kSlowest), instant_ns);
}

SearchRegion Whereabouts::carried(std::int64_t instant_ns) const {
  return within(kCarried, instant_ns);
}

SearchRegion Whereabouts::anywhere() const {
  SearchRegion region = carried(trusted_ns);
  region.radius = kMostReach;
  region.turn = std::numbers::pi;
  return region;
}

SearchRegion Whereabouts::anywhere_about(const Eigen::Vector3d& place) const {
  return {{last_carrier().rotation, place}, kMostReach, std::numbers::pi};
}

SearchRegion Whereabouts::come_back(int scans) const {
  std::vector<Eigen::Vector3d> places = way.places_apart(kMostReach);
  if (places.empty()) places.push_back(last.translation);
  return anywhere_about(places[static_cast<std::size_t>(scans) % places.size()]);
}

std::optional<SearchRegion> Whereabouts::of_turn(int scans, std::int64_t instant_ns) const {
  const SearchRegion far = carried(instant_ns), near = walked(instant_ns);
  const int turn = scans % kSeldom;
  if (!far.large() || turn == kSeldom - 1) return far;
  if (!near.large() || turn == 0) return near;
  return std::nullopt;
}

/// Where one may be who goes so fast, the longer after the last trusted scan the farther from it.
/// Who is seen all the while does not come to another storey, which looks as this one does; and who
/// climbs, to a storey that is not known yet, is not found where he came from.
SearchRegion Whereabouts::within(double speed, std::int64_t instant_ns) const {
  const double away = std::max(since(instant_ns), 0.0);
  // [K30]
  SearchRegion region{last_carrier(), std::min(kFirstReach + speed * away, kMostReach),
                      std::min(kFirstTurn + kTurnSpeed * away, std::numbers::pi)};
  if (walked_unseen) return region;
  const double climb = way.climb_of_late();
  if (climb == 0.0 && !way.has_storeys(region.centre.translation, region.radius)) return region;
  region.keep_to_storey(climb);
  return region;
}

}  // namespace surefoot
