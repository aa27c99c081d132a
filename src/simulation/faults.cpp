// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "simulation/random.hpp"
#include "simulation/scan_changes.hpp"

namespace surefoot::simulation {

namespace {

using Maker = decltype(Fault::scan);
/// Which scan of the walk is shown as number n.
using Order = std::function<std::uint64_t(std::uint64_t n, const FaultSource& walk)>;

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::uint64_t kFaultEnds = kFaultBegins + kFaultLasts;

bool once(std::uint64_t n) { return n == kFaultBegins; }
bool for_a_while(std::uint64_t n) { return n >= kFaultBegins && n < kFaultEnds; }
bool from_then_on(std::uint64_t n) { return n >= kFaultBegins; }
bool always(std::uint64_t) { return true; }
bool first(std::uint64_t n) { return n == 0; }
bool second(std::uint64_t n) { return n == 1; }
bool first_three(std::uint64_t n) { return n < 3; }

using When = bool (*)(std::uint64_t n);

FaultyScan taken(const FaultSource& source, std::uint64_t index, int place = 0) {
  FaultyScan result{source.scan(index), {}, place};
  result.T_map_lidar = source.T_map_lidar(middle_of(result.scan));
  return result;
}

/// The walk's scan, changed.
Maker changed(When when, Change change) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    FaultyScan result = taken(walk, n);
    if (when(n)) change(result.scan, n);
    return result;
  };
}

/// Other scans of the walk than those whose turn it is, at the stamps of these.
Maker reordered(Order order) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    FaultyScan result = taken(walk, order(n, walk));
    result.scan.stamp_ns = walk.scan(n).stamp_ns;
    return result;
  };
}

/// The sensor's scan of another instant, at this instant's stamp: what it shows is not so.
Maker stale(Order order) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    FaultyScan result = taken(walk, n);
    Scan shown = walk.scan(order(n, walk));
    shown.stamp_ns = result.scan.stamp_ns;
    result.scan = std::move(shown);
    return result;
  };
}

/// No scans for so long.
Maker hole(std::uint64_t scans) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    return taken(walk, from_then_on(n) ? n + scans : n);
  };
}

Maker every(std::uint64_t stride) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    return taken(walk, from_then_on(n) ? kFaultBegins + (n - kFaultBegins) * stride : n);
  };
}

Maker elsewhere(When when) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource& other) {
    FaultyScan result = when(n) ? taken(other, n, 1) : taken(walk, n);
    result.scan.stamp_ns = walk.scan(n).stamp_ns;
    return result;
  };
}

/// Carried along its way, in no time.
Maker carried(double distance) {
  return reordered([=](std::uint64_t n, const FaultSource& walk) {
    if (!from_then_on(n)) return n;
    constexpr std::uint64_t kMost = kFaultReach - kFaultyScans;
    const auto place = [&](std::uint64_t scans) {
      const std::int64_t period = kSecond / 10;
      return walk.T_map_lidar(walk.scan(0).stamp_ns + static_cast<std::int64_t>(scans) * period)
          .translation;
    };
    std::uint64_t skipped = 1;
    while (skipped < kMost &&
           (place(kFaultBegins + skipped) - place(kFaultBegins)).norm() < distance) {
      ++skipped;
    }
    return n + skipped;
  });
}

/// The sensor turned, or shifted, on its mount: it is where it is then.
Maker mounted(const Pose& T_old_new) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    FaultyScan result = taken(walk, n);
    if (!from_then_on(n)) return result;
    result.T_map_lidar = result.T_map_lidar * T_old_new;
    const Pose back = T_old_new.inverse();
    for (Eigen::Vector3f& p : result.scan.points) p = (back * p.cast<double>()).cast<float>();
    return result;
  };
}

/// Every fifth scan, at its own stamp, of who turns the sensor by so much [rad] in between.
Maker turned_by_hand(double least, double most) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    if (!from_then_on(n)) return taken(walk, n);
    double yaw = 0.0;
    for (std::uint64_t k = kFaultBegins; k <= n; ++k) {
      const CounterRandom random(k, 77);
      yaw += random.uniform(0, least, most) * (random.uniform(1) < 0.7 ? 1.0 : -1.0);
    }
    FaultyScan result = taken(walk, kFaultBegins + 5 * (n - kFaultBegins));
    const Pose turn{from_roll_pitch_yaw({0.0, 0.0, yaw}), {0, 0, 0}};
    result.T_map_lidar = result.T_map_lidar * turn;
    const Pose back = turn.inverse();
    for (Eigen::Vector3f& p : result.scan.points) p = (back * p.cast<double>()).cast<float>();
    return result;
  };
}

/// A car's recording of which few scans were kept: each a stretch farther on, 0.8 s later. At its
/// end it begins again from the other end.
Maker leaps(std::uint64_t stretch) {
  return [=](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    constexpr std::uint64_t kMost = kFaultReach - kFaultyScans;
    const std::uint64_t phase = n * stretch % (2 * kMost);
    FaultyScan result = taken(walk, std::min(phase, 2 * kMost - phase));
    result.scan.stamp_ns =
        walk.scan(0).stamp_ns + static_cast<std::int64_t>(n) * 8 * (kSecond / 10);
    return result;
  };
}

Pose turned(double roll_deg, double pitch_deg, double yaw_deg,
            const Eigen::Vector3d& shift = {0, 0, 0}) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return {from_roll_pitch_yaw(kDegree * Eigen::Vector3d(roll_deg, pitch_deg, yaw_deg)), shift};
}

/// A number up to 59, by chance.
std::uint64_t any(std::uint64_t n) { return CounterRandom(n, 76).bits(0) % 60; }

std::vector<Fault> what_the_sensor_does() {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Change empty = only([](const Eigen::Vector3f&, std::size_t) { return false; });
  const auto points = [](std::size_t count) {
    return only(
        [=](const Eigen::Vector3f&, std::size_t i) { return i % 997 == 0 && i < 997 * count; });
  };
  const auto up_to = [](float range) {
    return only([=](const Eigen::Vector3f& p, std::size_t) { return p.norm() < range; });
  };
  return {
      {"empty", "a scan without points", changed(once, empty)},
      {"empty 2 s", "20 of them", changed(for_a_while, empty)},
      {"one point", "a scan of one point",
       changed(once, only([](const Eigen::Vector3f&, std::size_t i) { return i == 0; }))},
      {"30 points", "2 s of scans of 30 points", changed(for_a_while, points(30))},
      {"NaN", "a scan of NaN", changed(once, every_point(kNaN))},
      {"infinite", "a scan of infinite coordinates", changed(once, every_point(kInfinity))},
      {"1e30", "a scan of coordinates of 1e30", changed(once, every_point(1e30F))},
      {"zeros 2 s", "2 s of scans of zeros", changed(for_a_while, every_point(0.0F))},
      {"covered near", "every beam ends at 0.6 m for 2 s", changed(for_a_while, covered(0.6F))},
      {"covered far", "every beam ends at 60 m for 2 s", changed(for_a_while, covered(60.0F))},
      {"sphere", "every beam ends at 3 m from then on", changed(from_then_on, covered(3.0F)),
       false},
      {"tube", "a bare tunnel from then on", changed(from_then_on, tube), false},
      {"tube 2 s", "a bare tunnel for 2 s", changed(for_a_while, tube)},
      {"floor 2 s", "nothing but a level floor for 2 s", changed(for_a_while, floor_only)},
      {"floor", "nothing but a level floor from then on", changed(from_then_on, floor_only), false},
      {"garbage", "a scan of random ranges", changed(once, garbage(1.0))},
      {"garbage 2 s", "2 s of them", changed(for_a_while, garbage(1.0))},
      {"garbage first", "the first scan of random ranges", changed(first, garbage(1.0))},
      {"garbage second", "the second one", changed(second, garbage(1.0))},
      {"garbage first three", "the first three", changed(first_three, garbage(1.0))},
      {"random tenth", "a tenth of all points at random ranges", changed(always, garbage(0.1))},
      {"random half", "half of all points at random ranges for 2 s",
       changed(for_a_while, garbage(0.5))},
      {"noise 0.1 m", "ranges with a noise of 0.1 m for 2 s", changed(for_a_while, noisy(0.1))},
      {"noise 0.5 m", "ranges with a noise of 0.5 m for 2 s", changed(for_a_while, noisy(0.5))},
      {"fog 6 m", "nothing farther than 6 m from then on", changed(from_then_on, up_to(6.0F))},
      {"fog 2.5 m", "nothing farther than 2.5 m for 2 s", changed(for_a_while, up_to(2.5F))},
      {"half", "the half in front for 2 s",
       changed(for_a_while, only([](const Eigen::Vector3f& p, std::size_t) { return p.x() > 0; }))},
      {"wedge", "60 degrees in front from then on",
       changed(from_then_on, only([](const Eigen::Vector3f& p, std::size_t) {
                 return p.x() > 1.73F * std::abs(p.y());
               }))},
      {"mount turned 30", "the sensor turned by 30 degrees on its mount",
       mounted(turned(0, 0, 30))},
      {"mount turned 90", "by 90 degrees", mounted(turned(0, 0, 90))},
      {"mount turned 180", "by 180 degrees", mounted(turned(0, 0, 180))},
      {"mount tilted 15", "tilted by 15 degrees", mounted(turned(15, 0, 0))},
      {"mount shifted", "shifted by 0.5 m", mounted(turned(0, 0, 0, {0.0, 0.5, 0.1}))},
  };
}

std::vector<Fault> what_drivers_and_files_do() {
  const Order frozen = [](std::uint64_t n, const FaultSource&) {
    return for_a_while(n) ? kFaultBegins - 1 : n;
  };
  const Order frozen_for_good = [](std::uint64_t n, const FaultSource&) {
    return std::min(n, kFaultBegins - 1);
  };
  const Order twice = [](std::uint64_t n, const FaultSource&) {
    return for_a_while(n) ? n - n % 2 : n;
  };
  const auto repeated = [](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
    const std::uint64_t steps = std::min(n, kFaultEnds) - std::min(n, kFaultBegins);
    return taken(walk, n - steps + steps / 2);
  };
  const Order shuffled = [](std::uint64_t n, const FaultSource&) {
    return from_then_on(n) ? any(n) : n;
  };
  const Order backwards = [](std::uint64_t n, const FaultSource&) {
    return for_a_while(n) ? kFaultEnds + kFaultBegins - 1 - n : n;
  };
  return {
      {"frozen 2 s", "the same scan at new stamps for 2 s", stale(frozen)},
      {"frozen", "the same scan at new stamps from then on", stale(frozen_for_good), false},
      {"stuttering", "every other scan is the last one's, at a new stamp, for 2 s", stale(twice)},
      {"repeated", "every scan twice, stamps too, for 2 s", repeated},
      {"duplicated", "every point twice", changed(always, doubled)},
      {"reversed points", "points in the reverse order for 2 s",
       changed(for_a_while, reversed_order)},
      {"reversed times", "times that run backwards for 2 s", changed(for_a_while, reversed_times)},
      {"no times", "no point times from then on", changed(from_then_on, without_times)},
      {"mirrored", "left and right changed from then on", changed(from_then_on, mirrored), false},
      {"stamp +1 s", "stamps jump by 1 s", changed(from_then_on, at_later_stamps(kSecond))},
      {"stamp +60 s", "by 60 s", changed(from_then_on, at_later_stamps(60 * kSecond))},
      {"stamp -1 s", "back by 1 s", changed(from_then_on, at_later_stamps(-kSecond))},
      {"stamps repeat", "for 2 s the stamp stays",
       [](std::uint64_t n, const FaultSource& walk, const FaultSource&) {
         FaultyScan result = taken(walk, n);
         if (for_a_while(n)) result.scan.stamp_ns = walk.scan(kFaultBegins).stamp_ns;
         return result;
       }},
      {"millimetres", "coordinates in millimetres from then on",
       changed(from_then_on, scaled(1000.0F)), false},
      {"feet", "in feet", changed(from_then_on, scaled(3.2808F)), false},
      {"scale 0.5", "halved", changed(from_then_on, scaled(0.5F)), false},
      {"other place", "another recording from then on", elsewhere(from_then_on), false},
      {"other place 2 s", "another recording for 2 s", elsewhere(for_a_while)},
      {"shuffled", "scans of the last 6 s in random order from then on", reordered(shuffled),
       false},
      {"backwards 2 s", "2 s of scans in the reverse order", reordered(backwards)},
      {"every third", "every third scan from then on", every(3)},
      {"every eighth", "every eighth scan from then on", every(8)},
      {"leaps", "every scan 4 s of walking farther on, 0.8 s later: from the first on", leaps(40)},
  };
}

std::vector<Fault> what_those_who_carry_it_do() {
  return {
      {"turned by hand", "every fifth scan, turned by 26 to 41 degrees in between",
       turned_by_hand(0.454, 0.716)},
      {"carried 1 m", "carried 1 m along its way, unseen", carried(1.0)},
      {"carried 5 m", "carried 5 m", carried(5.0)},
      {"carried 20 m", "carried 20 m", carried(20.0)},
      {"hole 1 s", "no scans for 1 s", hole(10)},
      {"hole 3 s", "no scans for 3 s", hole(30)},
      {"hole 10 s", "no scans for 10 s", hole(100)},
      {"hole 60 s", "no scans for 60 s", hole(600)},
  };
}

}  // namespace

const std::vector<Fault>& fault_catalogue() {
  static const std::vector<Fault> faults = [] {
    std::vector<Fault> all = {
        {"none", "nothing goes wrong", changed(always, [](Scan&, std::uint64_t) {})}};
    for (const auto& group :
         {what_the_sensor_does(), what_drivers_and_files_do(), what_those_who_carry_it_do()}) {
      all.insert(all.end(), group.begin(), group.end());
    }
    return all;
  }();
  return faults;
}

}  // namespace surefoot::simulation
