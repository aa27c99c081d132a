// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// whole_run [RECORDING]: time per scan of a whole run, processor and wall, with one thread and with
// two; peak memory; and whether every number of threads gave the same bits. Without a recording it
// walks over the simulated campus. Reading and simulating are not timed. Exit codes: 0, 1 if bits
// differ, 2 for wrong usage or bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dataset/recording.hpp"
#include "machine.hpp"
#include "memory.hpp"
#include "simulated_walk.hpp"
#include "support/synthetic_run.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

/// The next scan, or nothing at the end.
using ScanSource = std::function<std::optional<Scan>()>;

struct Arguments {
  std::string method = "surefoot";
  std::string recording;
  std::size_t scans = 600;
  std::vector<int> threads = {1, 2};
};

/// From the first scan again. Files that cannot be read and partial revolutions are left out.
ScanSource open_source(const Arguments& arguments) {
  if (arguments.recording.empty()) {
    auto walk = std::make_shared<SimulatedWalk>(campus(), WalkOptions{.scans = arguments.scans});
    return [walk] { return walk->next(); };
  }
  std::shared_ptr<dataset::Recording> recording = dataset::open_recording(arguments.recording);
  return [recording]() -> std::optional<Scan> {
    while (auto item = recording->next()) {
      if (item->scan && item->remark.empty()) return std::move(item->scan);
    }
    return std::nullopt;
  };
}

struct Measured {
  std::vector<Estimate> estimates;   ///< of all scans
  std::vector<double> wall_ms;       ///< of all scans but the first
  std::vector<double> processor_ms;  ///< of these, all threads together
  double peak_megabytes = 0.0;       ///< resident, with the scene or the reader
};

/// The first scan only begins the map; its time would be the minimum and tell nothing.
void measure_scan(Odometry& odometry, const Scan& scan, Measured& measured) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  Estimate estimate = odometry.add_scan(scan);
  const std::clock_t processor_end = std::clock();
  const auto wall_end = std::chrono::steady_clock::now();
  measured.estimates.push_back(std::move(estimate));
  if (measured.estimates.size() == 1) return;
  measured.wall_ms.push_back(std::chrono::duration<double, std::milli>(wall_end - wall).count());
  measured.processor_ms.push_back(1e3 * static_cast<double>(processor_end - processor) /
                                  CLOCKS_PER_SEC);
}

Measured measure_run(const Arguments& arguments, int threads) {
  const ScanSource next_scan = open_source(arguments);
  Odometry odometry(method_config(arguments.method), threads);
  Measured measured;
  while (measured.estimates.size() < arguments.scans) {
    const std::optional<Scan> scan = next_scan();
    if (!scan) break;
    measure_scan(odometry, *scan, measured);
    measured.peak_megabytes = std::max(measured.peak_megabytes, resident_megabytes());
  }
  if (measured.wall_ms.empty()) {
    throw std::runtime_error(
        fmt::format("{} usable scans, at least 2 are needed", measured.estimates.size()));
  }
  return measured;
}

/// Smallest value that at least this share of the values does not exceed.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

void print_head(const Arguments& arguments, const Measured& measured) {
  std::vector<double> points;
  for (const Estimate& estimate : measured.estimates) points.push_back(estimate.points);
  const auto untrusted =
      std::count_if(measured.estimates.begin(), measured.estimates.end(),
                    [](const Estimate& estimate) { return !estimate.trusted(); });
  fmt::print("machine    {}, {} cores\n", app::processor_name(), app::processor_cores());
  fmt::print("recording  {}: {} scans, {:.0f} valid points in the median one; {} not trusted\n",
             arguments.recording.empty() ? "simulated campus" : arguments.recording, points.size(),
             quantile(points, 0.5), untrusted);
  fmt::print("{:7} | {:^26} | {:^26} | {:>7} | {:>9}\n", "", "wall time [ms/scan]",
             "processor time [ms/scan]", "", "peak RSS");
  fmt::print("{0:7} | {1:>8} {2:>8} {3:>8} | {1:>8} {2:>8} {3:>8} | {4:>7} | {5:>9}\n", "threads",
             "min", "median", "p99", "scans/s", "[MB]");
}

void print_row(int threads, const Measured& measured) {
  const double seconds =
      1e-3 * std::accumulate(measured.wall_ms.begin(), measured.wall_ms.end(), 0.0);
  fmt::print("{:7} |", threads);
  for (const std::vector<double>* times : {&measured.wall_ms, &measured.processor_ms}) {
    for (const double share : {0.0, 0.5, 0.99}) fmt::print(" {:8.2f}", quantile(*times, share));
    fmt::print(" |");
  }
  fmt::print(" {:7.0f} | {:9.0f}\n", static_cast<double>(measured.wall_ms.size()) / seconds,
             measured.peak_megabytes);
  std::fflush(stdout);
}

/// Returns whether all runs agree in every bit.
bool run_all(const Arguments& arguments) {
  std::vector<Estimate> first;
  bool same = true;
  for (const int threads : arguments.threads) {
    const Measured measured = measure_run(arguments, threads);
    if (first.empty()) {
      print_head(arguments, measured);
      first = measured.estimates;
    }
    print_row(threads, measured);
    same = same && test::same_bits(first, measured.estimates);
  }
  fmt::print("same bits: {}\n", same ? "yes" : "NO");
  return same;
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  surefoot::benchmarks::Arguments arguments;
  CLI::App app{"Time per scan of a whole run"};
  app.add_option("recording", arguments.recording,
                 "Folder of scans or capture; absent: a walk over the simulated campus");
  app.add_option("--method", arguments.method, "As surefoot run's")->capture_default_str();
  app.add_option("--scans", arguments.scans, "At most this many")
      ->check(CLI::Range(2, 1'000'000))
      ->capture_default_str();
  app.add_option("--threads", arguments.threads, "Numbers of threads, one run each")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    return surefoot::benchmarks::run_all(arguments) ? 0 : 1;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "whole_run: {}\n", error.what());
    return 2;
  }
}
