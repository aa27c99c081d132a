// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot sweep: what a parameter's value does to the error, over several recordings with truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "commands.hpp"
#include "config_file.hpp"
#include "dataset/recording.hpp"
#include "dataset/trajectory_files.hpp"
#include "evaluation/alignment.hpp"
#include "evaluation/ape.hpp"
#include "evaluation/statistics.hpp"
#include "interrupt.hpp"
#include "option_checks.hpp"
#include "progress.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::app {

namespace fs = std::filesystem;

namespace {

struct SweepOptions {
  std::vector<fs::path> recordings;
  std::string method = "surefoot";
  std::vector<std::string> settings;
  std::vector<std::string> variations;
  std::size_t count = 0;
  int jobs = 1;
};

/// One value of one parameter; no name for the unchanged parameters.
struct Variant {
  std::string label;
  Config config;
};

/// How one variant did on one recording.
struct Outcome {
  double ape = 0.0;           ///< [m] RMSE after SE(3) alignment
  double step_error = 0.0;    ///< [m] RMSE of the motion from scan to scan
  double milliseconds = 0.0;  ///< median processor time per scan
  std::size_t untrusted = 0;
};

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void score(const Trajectory& truth, const Trajectory& estimate, Outcome& outcome) {
  using namespace evaluation;
  const AssociatedTrajectories raw =
      associate(truth, estimate, {.method = AssociationMethod::kInterpolate});
  const AssociatedTrajectories pairs{
      raw.reference, aligned(raw.estimate, find_alignment(raw, AlignmentMethod::kRigid))};
  outcome.ape = statistics_of(absolute_errors(pairs, Relation::kTranslation)).rmse;
  std::vector<double> steps;
  for (std::size_t i = 1; i < raw.reference.size(); ++i) {
    const auto step = [i](const Trajectory& t) { return t[i - 1].pose.inverse() * t[i].pose; };
    steps.push_back(
        size_of(step(raw.estimate).inverse() * step(raw.reference), Relation::kTranslation));
  }
  outcome.step_error = statistics_of(steps).rmse;
}

Outcome try_variant(const fs::path& path, const Config& config, std::size_t count) {
  const auto recording = dataset::open_recording(path);
  Odometry odometry(config);
  Trajectory estimate;
  Outcome outcome;
  std::vector<double> milliseconds;
  for (auto item = recording->next(); item && (count == 0 || milliseconds.size() < count);
       item = recording->next()) {
    if (!item->scan) continue;
    const double begin = thread_seconds();
    const Estimate result = odometry.add_scan(*item->scan);
    milliseconds.push_back(1e3 * (thread_seconds() - begin));
    outcome.untrusted += result.trusted() ? 0 : 1;
    if (result.status != Status::rejected) {
      estimate.push_back({result.stamp_ns, result.T_map_lidar});
    }
  }
  outcome.milliseconds = median(std::move(milliseconds));
  score(dataset::read_tum(path / "gt.tum"), estimate, outcome);
  return outcome;
}

std::vector<Variant> make_variants(const SweepOptions& options) {
  Config base = method_config(options.method);
  apply_settings(options.settings, base);
  std::vector<Variant> variants{{"unchanged", base}};
  for (const std::string& variation : options.variations) {
    const std::size_t equals = variation.find('=');
    if (equals == std::string::npos) {
      throw ConfigError(fmt::format(
          "--vary {}: expected key=value,value,... as in deskew.segments=1,4", variation));
    }
    const std::string key = variation.substr(0, equals);
    for (const std::string& value : CLI::detail::split(variation.substr(equals + 1), ',')) {
      Variant variant{fmt::format("{} = {}", key, value), base};
      set_parameter(variant.config, key, value);
      variants.push_back(std::move(variant));
    }
  }
  return variants;
}

/// All outcomes, variants x recordings, several at a time; the order does not change a result.
std::vector<Outcome> try_all(const SweepOptions& options, const std::vector<Variant>& variants) {
  const std::size_t recordings = options.recordings.size();
  std::vector<Outcome> outcomes(variants.size() * recordings);
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  Progress progress("runs", false);
  InterruptGuard interrupt;
  const auto work = [&](bool reports) {
    for (std::size_t i = next++; i < outcomes.size() && !interrupt.interrupted(); i = next++) {
      outcomes[i] = try_variant(options.recordings[i % recordings], variants[i / recordings].config,
                                options.count);
      ++done;
      if (reports) progress.update(done, double(done) / double(outcomes.size()));
    }
  };
  std::vector<std::jthread> others;
  for (int job = 1; job < options.jobs; ++job) others.emplace_back(work, false);
  work(true);
  others.clear();  // joins
  progress.finish();
  if (interrupt.interrupted()) throw std::runtime_error("interrupted");
  return outcomes;
}

/// Markdown: a row per variant; APE and scan-to-scan error per recording, and the geometric means
/// of both over the recordings against the unchanged parameters'.
void print_table(const SweepOptions& options, const std::vector<Variant>& variants,
                 const std::vector<Outcome>& outcomes) {
  const std::size_t recordings = options.recordings.size();
  fmt::print("| parameter |");
  for (const fs::path& path : options.recordings) fmt::print(" {} |", path.filename().string());
  fmt::print(" APE ratio | step ratio | ms | untrusted |\n|---|");
  for (std::size_t i = 0; i < recordings + 4; ++i) fmt::print("---|");
  fmt::print("\n");
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const Outcome* const row = &outcomes[v * recordings];
    double ape_log = 0.0, step_log = 0.0, milliseconds = 0.0;
    std::size_t untrusted = 0;
    fmt::print("| {} |", variants[v].label);
    for (std::size_t r = 0; r < recordings; ++r) {
      fmt::print(" {:.3f} / {:.3f} |", row[r].ape, row[r].step_error);
      ape_log += std::log(row[r].ape / outcomes[r].ape);
      step_log += std::log(row[r].step_error / outcomes[r].step_error);
      milliseconds += row[r].milliseconds;
      untrusted += row[r].untrusted;
    }
    const auto n = static_cast<double>(recordings);
    fmt::print(" {:.2f} | {:.2f} | {:.1f} | {} |\n", std::exp(ape_log / n), std::exp(step_log / n),
               milliseconds / n, untrusted);
  }
}

}  // namespace

void add_sweep_command(CLI::App& app, int&) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = app.add_subcommand(
      "sweep", "Try values of parameters, one at a time, on recordings with a gt.tum beside them");
  command->add_option("recordings", options->recordings, "folders of scans with gt.tum")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--vary", options->variations, "key=value,value,...; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--method", options->method)->capture_default_str();
  command->add_option("--set", options->settings, "key=value for every run; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--count", options->count, "scans of each recording to use; 0: all")
      ->check(whole_number(0));
  command->add_option("-j,--jobs", options->jobs, "runs at the same time")
      ->check(CLI::Range(1, 64));
  command->callback([options] {
    const std::vector<Variant> variants = make_variants(*options);
    print_table(*options, variants, try_all(*options, variants));
  });
}

}  // namespace surefoot::app
