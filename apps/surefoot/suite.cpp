// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot suite: the fixed set of recordings that tables stand on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "commands.hpp"
#include "interrupt.hpp"
#include "recording_maker.hpp"
#include "simulation/standard_suite.hpp"

namespace surefoot::app {

namespace {

constexpr int kIncomplete = 1;

struct SuiteArguments {
  std::string output;
  std::string seeds = "reporting";
  unsigned jobs = 1;
};

class SuiteRun {
 public:
  explicit SuiteRun(const SuiteArguments& arguments)
      : arguments_(arguments), set_(*simulation::find_suite_set(arguments.seeds)) {}

  /// @returns whether every recording was made whole.
  bool run() {
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < arguments_.jobs; ++i) {
      workers.emplace_back([this] { work(); });
    }
    for (std::thread& worker : workers) worker.join();
    if (error_) std::rethrow_exception(error_);
    return !guard_.interrupted();
  }

 private:
  void work() {
    try {
      for (std::size_t entry = next_++; entry < simulation::kStandardSuite.size() && !stopped();
           entry = next_++) {
        make(entry);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
  }

  void make(std::size_t entry) {
    const simulation::SuiteEntry& wanted = simulation::kStandardSuite[entry];
    RecordingRequest request;
    request.scene = wanted.scene;
    request.robot = wanted.robot;
    request.scans = wanted.scans;
    request.seed = simulation::suite_seed(set_, entry);
    const std::string name = fmt::format("{}-{}", request.scene, request.robot);
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t done =
        make_recording(request, std::filesystem::path(arguments_.output) / name,
                       [this](std::uint64_t) { return !stopped(); });
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::lock_guard lock(mutex_);
    fmt::print(stderr, "{:<20} seed {}  {} of {} scans  {:.1f} s\n", name, request.seed, done,
               request.scans, seconds);
  }

  [[nodiscard]] bool stopped() const { return failed_ || guard_.interrupted(); }

  SuiteArguments arguments_;
  const simulation::SuiteSet& set_;
  InterruptGuard guard_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void add_suite_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<SuiteArguments>();
  CLI::App* command =
      app.add_subcommand("suite", "Make the fixed set of recordings that tables stand on");
  command->add_option("-o,--output", arguments->output, "Folder; a sub-folder each recording")
      ->required();
  std::vector<std::string> sets;
  for (const simulation::SuiteSet& set : simulation::kSuiteSets) sets.emplace_back(set.name);
  command->add_option("--seeds", arguments->seeds, "Set of seeds; no two sets share one")
      ->check(CLI::IsMember(sets))
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Recordings made at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->callback([arguments, &exit_code] {
    if (!SuiteRun(*arguments).run()) exit_code = kIncomplete;
  });
}

}  // namespace surefoot::app
