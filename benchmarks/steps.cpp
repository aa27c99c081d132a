// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Time of every step of one scan, and of whole scans. "items" are the points that a step is given.
#include <benchmark/benchmark.h>

#include <string>

#include "methods/paper/horizontal.hpp"
#include "methods/paper/vertical.hpp"
#include "moment.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

void count_points(benchmark::State& state, std::size_t points) {
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

void time_preprocess(benchmark::State& state) {
  const Moment& at = moment();
  for (auto _ : state) benchmark::DoNotOptimize(preprocess(at.scan, at.config.preprocess));
  count_points(state, at.scan.points.size());
}
BENCHMARK(time_preprocess)->Name("preprocess")->Unit(benchmark::kMicrosecond);

void time_deskew(benchmark::State& state, DeskewMode mode) {
  const Moment& at = moment();
  PaperParameters::Deskew config = at.paper.deskew;
  config.mode = mode;
  for (auto _ : state) {
    const ScanTrajectory predicted =
        predict_trajectory(at.prior, at.prepared.start_ns, at.prepared.end_ns, config);
    benchmark::DoNotOptimize(deskew(at.prepared, predicted, at.workers));
  }
  count_points(state, at.prepared.points.size());
}
BENCHMARK_CAPTURE(time_deskew, constant_velocity, DeskewMode::constant_velocity)
    ->Name("deskew/constant_velocity")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(time_deskew, piecewise, DeskewMode::piecewise)
    ->Name("deskew/piecewise")
    ->Unit(benchmark::kMicrosecond);

void time_thin_scan(benchmark::State& state) {
  const Moment& at = moment();
  for (auto _ : state) benchmark::DoNotOptimize(thin_scan(at.deskewed, at.paper.downsample));
  count_points(state, at.deskewed.size());
}
BENCHMARK(time_thin_scan)->Name("thin_scan")->Unit(benchmark::kMicrosecond);

/// Places of the registered points at the predicted pose, map frame [m].
std::vector<Eigen::Vector3d> predicted_places() {
  const Pose T_0 = moment().predicted.at(0.5);
  std::vector<Eigen::Vector3d> places;
  for (const Eigen::Vector3f& point : moment().source.points) {
    places.push_back(T_0 * point.cast<double>());
  }
  return places;
}

/// A search for every registered point, as the first iteration makes them.
void time_nearby(benchmark::State& state) {
  const Moment& at = moment();
  const double radius = max_search_radius(at.paper.registration);
  const std::vector<Eigen::Vector3d> places = predicted_places();
  for (auto _ : state) {
    for (const Eigen::Vector3d& place : places) {
      benchmark::DoNotOptimize(at.map.nearby(place, radius));
    }
  }
  count_points(state, places.size());
}
BENCHMARK(time_nearby)->Name("local_map/nearby")->Unit(benchmark::kMicrosecond);

/// A normal for every registered point, as the first vertical update looks them up.
void time_surface(benchmark::State& state) {
  const Moment& at = moment();
  const std::vector<Eigen::Vector3d> places = predicted_places();
  for (auto _ : state) {
    for (const Eigen::Vector3d& place : places) {
      benchmark::DoNotOptimize(at.map.surface(at.map.voxel_of(place)));
    }
  }
  count_points(state, places.size());
}
BENCHMARK(time_surface)->Name("local_map/surface")->Unit(benchmark::kMicrosecond);

void time_horizontal_equations(benchmark::State& state) {
  const Moment& at = moment();
  for (auto _ : state) {
    benchmark::DoNotOptimize(horizontal_equations(at.source, at.registration.T_map_lidar,
                                                  at.paper.horizontal, at.workers));
  }
  count_points(state, at.source.points.size());
}
BENCHMARK(time_horizontal_equations)->Name("horizontal_equations")->Unit(benchmark::kMicrosecond);

/// With the surfaces known, as in all updates of a scan but the first.
void time_vertical_equations(benchmark::State& state) {
  const Moment& at = moment();
  Source source = at.source;
  for (auto _ : state) {
    benchmark::DoNotOptimize(vertical_equations(source, at.map, at.registration.T_map_lidar,
                                                at.paper.vertical, at.workers));
  }
  count_points(state, source.points.size());
}
BENCHMARK(time_vertical_equations)->Name("vertical_equations")->Unit(benchmark::kMicrosecond);

/// All iterations of one scan, from the prediction to convergence.
void time_register_scan(benchmark::State& state) {
  const Moment& at = moment();
  const Workers workers(static_cast<int>(state.range(0)));
  const Pose T_0 = at.predicted.at(0.5);
  Source source = at.source;
  for (auto _ : state) {
    benchmark::DoNotOptimize(register_scan(source, at.map, T_0, at.paper,
                                           at.config.health.min_matches, workers, [](Step) {}));
  }
  count_points(state, source.points.size());
  state.counters["iterations"] = at.registration.horizontal.iterations;
}
BENCHMARK(time_register_scan)
    ->Name("register_scan")
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

/// A scan's points into the map that the scans before have made.
void time_insert(benchmark::State& state) {
  const Moment& at = moment();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : at.thinned.map_points) {
    points.push_back(at.registration.T_map_lidar * point.cast<double>());
  }
  for (auto _ : state) {
    state.PauseTiming();
    LocalMap map = at.map;
    state.ResumeTiming();
    for (const Eigen::Vector3d& point : points) map.insert(point);
    benchmark::DoNotOptimize(map);
  }
  count_points(state, points.size());
}
BENCHMARK(time_insert)->Name("local_map/insert")->Unit(benchmark::kMicrosecond);

/// Cleaning the map of far voxels, which happens every few metres. "items" are voxels here.
void time_remove_far(benchmark::State& state) {
  const Moment& at = moment();
  LocalMap map = at.map;
  const Eigen::Vector3d step = Eigen::Vector3d::UnitX() * at.config.map.radius * 0.06;
  const Eigen::Vector3d here = at.registration.T_map_lidar.translation;
  map.remove_far(here, at.config.map.radius);
  bool away = false;
  for (auto _ : state) {
    away = !away;
    map.remove_far(away ? here + step : here, at.config.map.radius);
  }
  state.counters["voxels"] = static_cast<double>(map.voxels());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.voxels()));
}
BENCHMARK(time_remove_far)->Name("local_map/remove_far")->Unit(benchmark::kMicrosecond);

/// Whole scans, one after another, once the map is whole.
void time_add_scan(benchmark::State& state) {
  const std::vector<Scan>& scans = campus_scans();
  Odometry odometry({}, static_cast<int>(state.range(0)));
  std::size_t next = 0;
  while (next < kWarmUp) odometry.add_scan(scans[next++]);
  std::size_t points = 0;
  for (auto _ : state) {
    const Estimate estimate = odometry.add_scan(scans[next++]);
    points += static_cast<std::size_t>(estimate.points);
    if (!estimate.trusted()) state.SkipWithError(estimate.message.c_str());
  }
  state.counters["points"] = static_cast<double>(points) / kMeasured;
  state.SetItemsProcessed(static_cast<std::int64_t>(points));
}
BENCHMARK(time_add_scan)
    ->Name("add_scan")
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(kMeasured)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace surefoot::benchmarks
