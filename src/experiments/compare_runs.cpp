// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/compare_runs.hpp"

#include <fmt/format.h>

#include <csignal>
#include <thread>
#include <utility>

#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "runs/run_files.hpp"

namespace surefoot::experiments {

namespace {
constexpr std::chrono::milliseconds kPollPeriod{5};
constexpr double kMebibyte = 1024.0 * 1024.0;

/// Whether what the tables are made of is still there.
bool has_results(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / runs::kTrajectoryFile) &&
         std::filesystem::exists(folder / runs::kScansFile);
}
}  // namespace

struct RunQueue::Running {
  std::size_t task;
  process::ChildProcess process;
};

RunQueue::RunQueue(std::vector<RunTask> tasks, int jobs, bool quiet)
    : tasks_(std::move(tasks)), jobs_(jobs), quiet_(quiet) {
  for (std::size_t i = tasks_.size(); i-- > 0;) waiting_.push_back(i);
  for (const RunTask& task : tasks_) weight_left_ += task.weight;
}

RunQueue::~RunQueue() = default;

void RunQueue::skip_done(bool retry_failed) {
  std::erase_if(waiting_, [&](std::size_t i) {
    const std::optional<RunRecord> record = read_record(tasks_[i].folder);
    const bool kept =
        record && (record->end.is_done() ? has_results(tasks_[i].folder) : !retry_failed);
    const bool done = kept && record->key == tasks_[i].key;
    if (done) {
      ++done_;
      failed_ += record->end.is_done() ? 0 : 1;
      weight_left_ -= tasks_[i].weight;
    }
    return done;
  });
}

void RunQueue::start(std::size_t task) {
  clear_run_folder(tasks_[task].folder);
  running_.push_back(
      {task, process::ChildProcess(tasks_[task].arguments, log_file(tasks_[task].folder))});
}

void RunQueue::tell(const RunTask& task, const RunRecord& record) const {
  if (quiet_) return;
  const evaluation::MeasuredRun run = measured_run(task.folder, record);
  const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
  std::string text =
      run.error.empty()
          ? fmt::format("{:.1f} s, {:.1f} ms a scan, {:.0f} MiB", run.wall_seconds, run.median_ms,
                        static_cast<double>(run.peak_memory_bytes) / kMebibyte)
          : "failed: " + run.error;
  if (done_ < tasks_.size() && weight_worked_ > 0.0) {
    text += fmt::format("; {} left", process::clock_text(elapsed / weight_worked_ * weight_left_));
  }
  fmt::print(stderr, "{}/{}  {}: {}\n", done_, tasks_.size(), task.name, text);
}

void RunQueue::finish(const Running& running, const process::ProcessEnd& end) {
  const RunTask& task = tasks_[running.task];
  const RunRecord record{task.key, end, jobs_};
  write_record(task.folder, record);
  ++done_;
  failed_ += end.is_done() ? 0 : 1;
  weight_left_ -= task.weight;
  weight_worked_ += task.weight;
  tell(task, record);
}

void RunQueue::poll_all(bool interrupted) {
  for (std::size_t i = 0; i < running_.size();) {
    const std::optional<process::ProcessEnd> end = running_[i].process.poll();
    if (!end) {
      ++i;
      continue;
    }
    // A run that ended while Ctrl-C was on its way may have been cut short by it.
    if (!interrupted || end->is_done()) finish(running_[i], *end);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

bool RunQueue::work() {
  const process::InterruptGuard interrupt;
  begin_ = Clock::now();
  bool told = false;
  while (!waiting_.empty() || !running_.empty()) {
    const bool interrupted = interrupt.interrupted();
    if (interrupted && !std::exchange(told, true)) {
      for (const Running& running : running_) running.process.send(SIGTERM);
    }
    if (interrupted && running_.empty()) return false;
    while (!interrupted && !waiting_.empty() && std::ssize(running_) < jobs_) {
      const std::size_t task = waiting_.back();
      waiting_.pop_back();
      start(task);
    }
    std::this_thread::sleep_for(kPollPeriod);
    poll_all(interrupted || interrupt.interrupted());
  }
  return !interrupt.interrupted() || done_ == tasks_.size();
}

}  // namespace surefoot::experiments
