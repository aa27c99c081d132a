// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// whole_run [RECORDING]: time per scan of a whole run, processor and wall, with one thread and with
// two; memory; and whether every number of threads gave the same bits. Without a recording it
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

#include "io/recording.hpp"
#include "memory.hpp"
#include "process/machine.hpp"
#include "simulated_walk.hpp"
#include "support/synthetic_run.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::benchmarks {

namespace {

/// The next scan, or null at the end; it stays until the next call.
using ScanSource = std::function<const Scan*()>;

struct Arguments {
  std::vector<std::string> methods = {"surefoot"};
  std::string recording;
  std::size_t scans = 600;
  std::vector<int> threads = {1, 2};
};

/// The campus walk, all of it beforehand: while it lives, its ray caster (Embree) holds oneTBB to
/// one thread in the whole process.
std::vector<Scan> simulate_walk(std::size_t count) {
  SimulatedWalk walk(campus(), WalkOptions{.scans = count});
  std::vector<Scan> scans;
  while (std::optional<Scan> scan = walk.next()) scans.push_back(std::move(*scan));
  return scans;
}

/// From the first scan again. Files that cannot be read and partial revolutions are left out.
ScanSource open_source(const Arguments& arguments, const std::vector<Scan>& walk) {
  if (arguments.recording.empty()) {
    return [&walk, next = std::size_t{0}]() mutable {
      return next == walk.size() ? nullptr : &walk[next++];
    };
  }
  std::shared_ptr<io::Recording> recording = io::open_recording(arguments.recording);
  return [recording, item = std::optional<io::ScanItem>()]() mutable -> const Scan* {
    while ((item = recording->next())) {
      if (item->scan && item->remark.empty()) return &*item->scan;
    }
    return nullptr;
  };
}

struct Measured {
  std::vector<Estimate> estimates;   ///< of all scans
  std::vector<double> wall_ms;       ///< of all scans but the first
  std::vector<double> processor_ms;  ///< of these, all threads together
  double peak_megabytes = 0.0;       ///< resident, with the reader and the simulated walk
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

Measured measure_run(const Arguments& arguments, const std::vector<Scan>& walk,
                     const std::string& method, int threads) {
  const ScanSource next_scan = open_source(arguments, walk);
  Odometry odometry(method_config(method), threads);
  Measured measured;
  while (measured.estimates.size() < arguments.scans) {
    const Scan* const scan = next_scan();
    if (scan == nullptr) break;
    measure_scan(odometry, *scan, measured);
    measured.peak_megabytes = std::max(measured.peak_megabytes, resident_megabytes());
  }
  if (measured.wall_ms.empty()) {
    throw std::runtime_error(
        fmt::format("{} usable scans, at least 2 are needed", measured.estimates.size()));
  }
  return measured;
}

void print_head(const Arguments& arguments, const Measured& measured) {
  std::vector<double> points;
  for (const Estimate& estimate : measured.estimates) points.push_back(estimate.points);
  fmt::print("machine    {}, {} cores\n", process::processor_name(), process::processor_cores());
  fmt::print("recording  {}: {} scans, {:.0f} valid points in the median one\n",
             arguments.recording.empty() ? "simulated campus" : arguments.recording, points.size(),
             quantile(points, 0.5));
  fmt::print("{:16}   {:7} | {:^26} | {:^26} | {:>7} | {:>6} | {:>7}\n", "", "",
             "wall time [ms/scan]", "processor time [ms/scan]", "", "memory", "not");
  fmt::print("{0:16} | {1:7} | {2:>8} {3:>8} {4:>8} | {2:>8} {3:>8} {4:>8} | {5} | {6:>6} | {7}\n",
             "method", "threads", "min", "median", "p99", "scans/s", "[MB]", "trusted");
}

/// Memory beyond `before` [MB], which the walk takes.
void print_row(const std::string& method, int threads, const Measured& measured, double before) {
  const double seconds =
      1e-3 * std::accumulate(measured.wall_ms.begin(), measured.wall_ms.end(), 0.0);
  const auto untrusted =
      std::count_if(measured.estimates.begin(), measured.estimates.end(),
                    [](const Estimate& estimate) { return !estimate.trusted(); });
  fmt::print("{:16} | {:7} |", method, threads);
  for (const std::vector<double>* times : {&measured.wall_ms, &measured.processor_ms}) {
    for (const double share : {0.0, 0.5, 0.99}) fmt::print(" {:8.2f}", quantile(*times, share));
    fmt::print(" |");
  }
  fmt::print(" {:7.0f} | {:6.0f} | {:7}\n", static_cast<double>(measured.wall_ms.size()) / seconds,
             measured.peak_megabytes - before, untrusted);
  std::fflush(stdout);
}

/// Returns whether all runs of each method agree in every bit.
bool run_all(const Arguments& arguments) {
  std::vector<Scan> walk;
  if (arguments.recording.empty()) walk = simulate_walk(arguments.scans);
  const double before = resident_megabytes();
  bool same = true;
  for (const std::string& method : arguments.methods) {
    std::vector<Estimate> first;
    for (const int threads : arguments.threads) {
      const Measured measured = measure_run(arguments, walk, method, threads);
      if (first.empty()) {
        if (method == arguments.methods.front()) print_head(arguments, measured);
        first = measured.estimates;
      }
      print_row(method, threads, measured, before);
      same = same && test::same_bits(first, measured.estimates);
    }
  }
  const bool compared = arguments.threads.size() > 1;
  fmt::print("same bits: {}\n", !compared ? "not compared" : same ? "yes" : "NO");
  return same;
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  surefoot::benchmarks::Arguments arguments;
  CLI::App app{"Time per scan of a whole run"};
  app.add_option("recording", arguments.recording,
                 "Folder of scans or capture; absent: a walk over the simulated campus");
  app.add_option("--method", arguments.methods, "As surefoot run's; several in turn")
      ->capture_default_str();
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
