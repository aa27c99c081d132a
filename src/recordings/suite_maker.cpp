// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/suite_maker.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "recordings/recording_maker.hpp"
#include "simulation/standard_suite.hpp"

namespace surefoot::recordings {

namespace {

class SuiteMaker {
 public:
  SuiteMaker(const SuiteRequest& request, const SuiteListener& listener)
      : request_(request), listener_(listener), set_(*simulation::find_suite_set(request.seeds)) {}

  bool make_all() {
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < request_.jobs; ++i) {
      workers.emplace_back([this] { work(); });
    }
    for (std::thread& worker : workers) worker.join();
    if (error_) std::rethrow_exception(error_);
    return !stopped();
  }

 private:
  void work() {
    try {
      for (std::size_t entry = next_++; entry < set_.entries().size() && !stopped();
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
    const simulation::SuiteEntry& wanted = set_.entries()[entry];
    RecordingRequest request;
    request.scene = wanted.scene;
    request.robot = wanted.robot;
    request.scans = wanted.scans;
    request.seed = simulation::suite_seed(set_, entry);
    if (!set_.own_layouts) request.layout = simulation::kFirstLayout;
    request.overwrite = request_.overwrite;
    const std::string name = simulation::suite_folder_name(wanted);
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t done = make_recording(request, request_.folder / name,
                                              [this](std::uint64_t) { return !stopped(); });
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::lock_guard lock(mutex_);
    listener_.say(fmt::format("{:<20} seed {}  {} of {} scans  {:.1f} s", name, request.seed, done,
                              request.scans, seconds));
  }

  [[nodiscard]] bool stopped() {
    const std::lock_guard lock(mutex_);
    return failed_ || listener_.interrupted();
  }

  const SuiteRequest& request_;
  const SuiteListener& listener_;
  const simulation::SuiteSet& set_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

bool make_suite(const SuiteRequest& request, const SuiteListener& listener) {
  return SuiteMaker(request, listener).make_all();
}

}  // namespace surefoot::recordings
