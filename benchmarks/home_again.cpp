// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// home_again: who was carried, or saw nothing while it went on, or was somewhere else meanwhile,
// within what it has mapped: how soon it is right again, and whether it ever takes another place
// for that. Places are drawn at random from simulated walks. Without --keep it prints. Exit codes:
// 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "fault_runs.hpp"
#include "geometry/so3.hpp"
#include "kept_run.hpp"
#include "simulation/scan_changes.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr std::uint64_t kFirst = 100, kLast = 300;  // scans before anything happens
constexpr std::uint64_t kLatest = 600;              // where it has not come far enough by then
constexpr std::uint64_t kAfter = 70;                // scans that it has to find itself
constexpr double kPeriod = 0.1;                     // [s] of a scan

/// What its scans show meanwhile: there are none, a hand on the sensor, or another scene of the
/// same kind.
enum class Meanwhile { no_scans, covered, elsewhere };

/// What happens to it.
struct Absence {
  std::string name;
  double distance;  ///< [m] that it is put down away; 0: it walks on meanwhile
  double gap;       ///< [s] without a scan of the walk
  double limit;     ///< [s] after the first scan since, within which it should be right
  Meanwhile meanwhile = Meanwhile::no_scans;
};

const std::vector<Absence>& absences() {
  static const std::vector<Absence> all = {
      {"carried 5 m", 5.0, 0.0, 2.0},
      {"hole of 3 s", 0.0, 3.0, 2.0},
      {"carried 20 m", 20.0, 0.0, 5.0},
      {"20 m away after 60 s", 20.0, 60.0, 5.0},
      {"covered for 10 s", 5.0, 10.0, 2.0, Meanwhile::covered},
      {"10 s elsewhere", 5.0, 10.0, 5.0, Meanwhile::elsewhere}};
  return all;
}

std::vector<std::string> absence_names() {
  std::vector<std::string> names;
  for (const Absence& absence : absences()) names.push_back(absence.name);
  return names;
}

/// What came of one.
struct Outcome {
  std::optional<double> right_after;  // [s]
  bool wrong = false;                 // a pose elsewhere was called ok
};

/// Where and how it goes on.
struct Event {
  std::uint64_t scans = 0;  ///< before it
  double from = 0.0;        ///< [s] of the walk where it goes on
  Pose moved;               ///< from there, in the body's frame
  bool stands = false;      ///< it does not go on at all
};

double apart(const simulation::Motion& motion, double a, double b) {
  return (motion.T_map_body(a).translation - motion.T_map_body(b).translation).norm();
}

/// A place on the way so far, so far away [m], of one who is put down there: a little aside of
/// where it went; then it goes on about as it went there, or stands and faces anywhere. None if the
/// way has no two places so far apart.
std::optional<Event> put_down(const simulation::Motion& motion, double distance,
                              std::mt19937_64& random) {
  const auto uniform = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  for (int trial = 0; trial < 10'000; ++trial) {
    const std::uint64_t last = trial < 1'000 ? kLast : kLatest;
    const auto scans =
        static_cast<std::uint64_t>(uniform(static_cast<double>(kFirst), static_cast<double>(last)));
    const double now = kPeriod * static_cast<double>(scans), from = uniform(1.0, now);
    if (std::abs(apart(motion, now, from) - distance) > 0.1 * distance) continue;
    const bool stands = uniform(0.0, 1.0) < 0.5;
    const double yaw = stands ? std::numbers::pi : std::numbers::pi / 6.0;
    const Pose moved{so3_exp({0.0, 0.0, uniform(-yaw, yaw)}), {0.0, uniform(-0.5, 0.5), 0.0}};
    return Event{scans, from, moved, stands};
  }
  return std::nullopt;
}

/// One who walks on unseen.
Event walks_on(double gap, std::mt19937_64& random) {
  const std::uint64_t scans = std::uniform_int_distribution<std::uint64_t>(kFirst, kLast)(random);
  return {scans, kPeriod * static_cast<double>(scans) + gap, {}, false};
}

/// The way since the event, from time 0 on.
simulation::Motion way_since(const simulation::Motion& walk, const Event& event) {
  std::vector<simulation::PoseAngles> controls;
  const double duration = kPeriod * static_cast<double>(kAfter + 2);
  const int steps = static_cast<int>(duration / simulation::kMotionStep) + 4;
  double yaw = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double time = (i - 1) * simulation::kMotionStep;
    const Pose body = walk.T_map_body(event.from + (event.stands ? 0.0 : time)) * event.moved;
    simulation::PoseAngles angles;
    angles << body.translation, roll_pitch_yaw(body.rotation);
    angles[5] = yaw += std::remainder(angles[5] - yaw, 2.0 * std::numbers::pi);
    controls.push_back(angles);
  }
  return {controls, mount()};
}

/// The scans between.
void go_through(Meanwhile meanwhile, double gap, const FaultWalk& walk, std::int64_t last_ns,
                Odometry& odometry) {
  if (meanwhile == Meanwhile::no_scans) return;
  const WalkSpec& spec = walk.spec();
  const FaultWalk elsewhere({spec.scene, spec.seed + 5000, spec.robot});
  const auto cover = simulation::covered(0.6F);
  const auto scans = static_cast<std::uint64_t>(gap / kPeriod);
  for (std::uint64_t n = 0; n < scans; ++n) {
    Scan scan = elsewhere.source().scan(n);
    scan.stamp_ns = last_ns + static_cast<std::int64_t>(1e9 * kPeriod * static_cast<double>(n + 1));
    if (meanwhile == Meanwhile::covered) cover(scan, n);
    odometry.add_scan(scan);
  }
}

Outcome outcome_of(const FaultWalk& walk, const Absence& absence, const Event& event,
                   std::uint64_t seed) {
  Odometry odometry;
  std::optional<Pose> fix;  // truth times the inverse of the estimate, before
  int segment = 0;
  const auto& before = walk.source();
  std::int64_t last_ns = 0;
  for (std::uint64_t n = 0; n < event.scans; ++n) {
    const Scan scan = before.scan(n);
    const Estimate estimate = odometry.add_scan(scan);
    segment = estimate.segment;
    fix = before.T_map_lidar(estimate.stamp_ns) * estimate.T_world_lidar.inverse();
    last_ns = scan.stamp_ns;
  }
  go_through(absence.meanwhile, absence.gap, walk, last_ns, odometry);
  simulation::Scanner since = walk.on_the_way(way_since(walk.motion(), event), seed);
  const std::int64_t first_ns = since.scan(0).scan.stamp_ns;
  const std::int64_t later_ns =
      last_ns - first_ns + static_cast<std::int64_t>(1e9 * (kPeriod + absence.gap));
  Outcome outcome;
  for (std::uint64_t n = 0; n < kAfter; ++n) {
    Scan scan = since.scan(n).scan;
    scan.stamp_ns += later_ns;
    const Estimate estimate = odometry.add_scan(scan);
    if (!estimate.trusted() || estimate.segment != segment) continue;
    const double time =
        1e-9 * static_cast<double>(estimate.stamp_ns - later_ns - since.options().start_ns);
    const bool wrong =
        motion_error(*fix * estimate.T_world_lidar, since.motion().T_map_lidar(time)).wrong();
    outcome.wrong |= wrong && estimate.status == Status::ok;
    if (wrong) outcome.right_after.reset();
    if (!wrong && !outcome.right_after) outcome.right_after = kPeriod * static_cast<double>(n);
  }
  return outcome;
}

struct Options {
  std::vector<std::string> walks;
  std::vector<std::string> absences;  // by name; none: all
  int places = 9;                     // of each walk
  std::string keep, commit;
};

/// How many of some places.
struct Tally {
  int places = 0, right = 0, in_time = 0, wrong = 0;

  void add(const Outcome& outcome, double limit) {
    ++places;
    right += outcome.right_after ? 1 : 0;
    in_time += outcome.right_after && *outcome.right_after <= limit ? 1 : 0;
    wrong += outcome.wrong ? 1 : 0;
  }
  [[nodiscard]] Tally operator+(const Tally& more) const {
    return {places + more.places, right + more.right, in_time + more.in_time, wrong + more.wrong};
  }
};

std::string row_of(const std::string& walk, const Absence& absence, const Tally& tally) {
  return fmt::format("{},{},{},{},{:g},{},{}\n", absence.name, walk, tally.places, tally.in_time,
                     absence.limit, tally.right, tally.wrong);
}

/// One kind of absence, from some places of a walk.
Tally tally_of(const FaultWalk& walk, const Absence& absence, int places) {
  std::mt19937_64 random(walk.spec().seed);
  Tally tally;
  for (int place = 0; place < places; ++place) {
    const std::optional<Event> event = absence.distance > 0.0
                                           ? put_down(walk.motion(), absence.distance, random)
                                           : walks_on(absence.gap, random);
    if (!event) {
      fmt::print("{:20} {:16} has no two places so far apart\n", absence.name, walk.spec().name());
      break;
    }
    const std::uint64_t seed = 1000 * walk.spec().seed + static_cast<std::uint64_t>(place);
    const Outcome outcome = outcome_of(walk, absence, *event, seed);
    tally.add(outcome, absence.limit);
    fmt::print("{:20} {:16} after {:3} scans, {:6}: {} s{}\n", absence.name, walk.spec().name(),
               event->scans, event->stands ? "stands" : "walks",
               outcome.right_after ? fmt::format("{:.1f}", *outcome.right_after) : "–",
               outcome.wrong ? ", wrong place" : "");
    std::fflush(stdout);
  }
  return tally;
}

bool wanted(const Options& options, const Absence& absence) {
  const auto& names = options.absences;
  return names.empty() || std::find(names.begin(), names.end(), absence.name) != names.end();
}

void run(const Options& options, const std::string& command) {
  std::string rows;
  std::vector<Tally> all(absences().size());
  for (const std::string& text : options.walks) {
    const FaultWalk walk(WalkSpec::parse(text));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Absence& absence = absences()[i];
      if (!wanted(options, absence)) continue;
      const Tally tally = tally_of(walk, absence, options.places);
      if (tally.places > 0) rows += row_of(walk.spec().name(), absence, tally);
      all[i] = all[i] + tally;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].places > 0) rows += row_of("all", absences()[i], all[i]);
  }
  rows = "absence,walk,places,right in time,limit [s],right at all,wrong place\n" + rows;
  fmt::print("{}", rows);
  if (options.keep.empty()) return;
  const auto file = std::filesystem::path(options.keep) / "home_again.csv";
  std::ofstream out(file);
  out << "# commit: " << options.commit << "\n# command: " << command << '\n' << rows;
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  surefoot::benchmarks::Options options;
  options.walks = {"campus:321",      "plaza:322",    "foyer:323",      "forest:324",
                   "forest-path:325", "hillside:326", "rubble:327",     "parking:328",
                   "street:329",      "bays:330",     "playground:331", "stairwell:332",
                   "storeys:333"};
  CLI::App app{"Who was carried, or saw nothing for a while: how soon it is right again"};
  app.add_option("--walk", options.walks, "SCENE:SEED[:ROBOT]")->capture_default_str();
  app.add_option("--absence", options.absences, "Names of what happens; none: all")
      ->check(CLI::IsMember(surefoot::benchmarks::absence_names()));
  app.add_option("--places", options.places, "Of each walk")->capture_default_str();
  app.add_option("--keep", options.keep, "Folder for home_again.csv");
  app.add_option("--commit", options.commit, "Named in what is kept");
  const auto run = [&](const std::string& command) { surefoot::benchmarks::run(options, command); };
  return surefoot::benchmarks::run_kept(app, argc, argv, "home_again", run);
}
