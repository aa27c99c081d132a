// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// soak [--scans N] [--stand]: more than a kilometre through the town's streets, or standing on the
// campus. Fails if memory or the local map still grows after the first thousand scans by more than
// the streets differ, if the robot got lost, or drifts while it stands.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>

#include "memory.hpp"
#include "simulated_walk.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr std::uint64_t kSettled = 1000;  // scans after which nothing may grow
constexpr std::uint64_t kEvery = 250;     // scans between two looks at the map
constexpr double kSpeed = 2.5;            // [m/s]
constexpr double kLeastStride = 0.17;     // [m] of way per scan
// At a crossing the robot sees two streets, and has seen but one in the first kSettled scans. A map
// that forgot nothing would grow to several times its size.
constexpr double kMapGrowth = 1.75;
constexpr double kMemoryGrowth = 25.0;                        // [MB]
constexpr double kDrift = 0.02;                               // of the way; measured: 0.007
constexpr double kStandingDrift = 0.02, kStandingTurn = 0.1;  // [m], [deg]

/// Highest values seen until now.
struct Peak {
  double megabytes = 0.0;
  std::size_t map_points = 0;

  void raise(double memory, std::size_t points) {
    megabytes = std::max(megabytes, memory);
    map_points = std::max(map_points, points);
  }
};

struct Soak {
  Peak early;              ///< in the first kSettled scans
  Peak late;               ///< after them
  double way = 0.0;        ///< truly walked [m]
  std::uint64_t lost = 0;  ///< scans whose pose is not to be trusted
  double error = 0.0;      ///< largest, begun together [m]
  double turn = 0.0;       ///< likewise [deg]
};

simulation::Scene standing_on_campus() {
  simulation::Scene scene = campus();
  scene.robot = "still";
  return scene;
}

Soak follow(SimulatedWalk& walk, std::uint64_t scans) {
  Odometry odometry;
  Soak soak;
  Pose T_start_map, T_start_scene, T_scene_last;
  fmt::print("{:>6} {:>9} {:>9} {:>11} {:>12}\n", "scan", "way [m]", "RSS [MB]", "map points",
             "error [m]");
  for (std::uint64_t i = 0; i < scans; ++i) {
    const Estimate estimate = odometry.add_scan(walk.next().value());
    const Pose truth = walk.T_map_lidar(estimate.stamp_ns);
    soak.lost += estimate.trusted() ? 0 : 1;
    if (i == 0) {
      T_start_map = estimate.T_world_lidar.inverse();
      T_start_scene = truth.inverse();
    } else {
      soak.way += (truth.translation - T_scene_last.translation).norm();
    }
    T_scene_last = truth;
    if ((i + 1) % kEvery != 0) continue;
    const double megabytes = resident_megabytes();
    const std::size_t points = odometry.local_map().size();
    (i < kSettled ? soak.early : soak.late).raise(megabytes, points);
    const Pose off = (T_start_scene * truth).inverse() * (T_start_map * estimate.T_world_lidar);
    const double error = off.translation.norm();
    soak.error = std::max(soak.error, error);
    soak.turn =
        std::max(soak.turn, Eigen::AngleAxisd(off.rotation).angle() * 180.0 / std::numbers::pi);
    fmt::print("{:6} {:9.0f} {:9.1f} {:11} {:12.2f}\n", i + 1, soak.way, megabytes, points, error);
    std::fflush(stdout);
  }
  return soak;
}

bool expect(bool held, const std::string& what) {
  fmt::print("{} {}\n", held ? "ok:    " : "FAILED:", what);
  return held;
}

bool judge_way(const Soak& soak, std::uint64_t scans) {
  const double least_way = kLeastStride * static_cast<double>(scans);
  const bool went =
      expect(soak.way > least_way,
             fmt::format("walked {:.0f} m, wanted more than {:.0f}", soak.way, least_way));
  return expect(soak.error < kDrift * soak.way,
                fmt::format("error at most {:.2f} m, wanted less than {:.2f}", soak.error,
                            kDrift * soak.way)) &&
         went;
}

bool judge_standing(const Soak& soak) {
  return expect(soak.error < kStandingDrift && soak.turn < kStandingTurn,
                fmt::format("off by {:.4f} m and {:.4f} deg at most, wanted less than {:.2f} and "
                            "{:.1f}",
                            soak.error, soak.turn, kStandingDrift, kStandingTurn));
}

bool judge_memory(const Soak& soak, std::uint64_t scans) {
  const double growth = soak.late.megabytes - soak.early.megabytes;
  const double map_growth =
      static_cast<double>(soak.late.map_points) / static_cast<double>(soak.early.map_points);
  bool held =
      expect(soak.lost == 0, fmt::format("{} of {} scans lost, wanted 0", soak.lost, scans));
  held &= expect(growth < kMemoryGrowth,
                 fmt::format("memory grew by {:.1f} MB after {} scans, wanted less than {:.0f}",
                             growth, kSettled, kMemoryGrowth));
  held &= expect(map_growth < kMapGrowth,
                 fmt::format("local map at most {:.2f} times as large after {} scans as before, "
                             "wanted less than {:.2f}",
                             map_growth, kSettled, kMapGrowth));
  return held;
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  std::uint64_t scans = 6000;
  bool stand = false;
  CLI::App app{"Memory and map on a long way"};
  app.add_option("--scans", scans, "Scans, at ten a second; 45,000 are 10 km")
      ->check(CLI::Range(2000, 1'000'000))
      ->capture_default_str();
  app.add_flag("--stand", stand, "Stand on the campus instead; 36,000 scans are an hour");
  try {
    app.parse(argc, argv);
    using namespace surefoot::benchmarks;
    namespace simulation = surefoot::simulation;
    SimulatedWalk walk(stand ? standing_on_campus() : simulation::build_scene("town", 1),
                       {.scans = scans, .speed = stand ? 0.0 : kSpeed, .footprint = false});
    const Soak soak = follow(walk, scans);
    const bool held = stand ? judge_standing(soak) : judge_way(soak, scans);
    return judge_memory(soak, scans) && held ? 0 : 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "soak: {}\n", error.what());
    return 2;
  }
}
