// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The runs of a comparison: each a process of its own, several at a time, none done twice.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "experiments/run_record.hpp"

namespace surefoot::experiments {

struct RunTask {
  std::string name;                    ///< for the progress: "campus-trot, paper"
  std::filesystem::path folder;        ///< of the run's output
  std::vector<std::string> arguments;  ///< of this program
  std::string key;
  double weight = 1.0;  ///< of its work against the others': the recording's bytes
};

class RunQueue {
 public:
  /// `jobs`: runs at a time.
  RunQueue(std::vector<RunTask> tasks, int jobs, bool quiet);
  ~RunQueue();
  RunQueue(const RunQueue&) = delete;
  RunQueue& operator=(const RunQueue&) = delete;

  /// Takes what is done for done; with `retry_failed` only what succeeded. Throws
  /// std::runtime_error.
  void skip_done(bool retry_failed);
  [[nodiscard]] std::size_t tasks() const { return tasks_.size(); }
  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t failed() const { return failed_; }  ///< of those that are done

  /// Does the rest. @returns false if it was interrupted; the runs that had not ended are not
  /// counted as done. Throws std::runtime_error for a run that cannot be started or recorded.
  [[nodiscard]] bool work();

 private:
  struct Running;
  using Clock = std::chrono::steady_clock;

  void start(std::size_t task);
  void finish(const Running& running, const process::ProcessEnd& end);
  void tell(const RunTask& task, const RunRecord& record) const;
  void poll_all(bool interrupted);

  std::vector<RunTask> tasks_;
  int jobs_;
  bool quiet_;
  std::vector<std::size_t> waiting_;  ///< tasks, the next one last
  std::vector<Running> running_;
  std::size_t done_ = 0, failed_ = 0;
  double weight_left_ = 0.0, weight_worked_ = 0.0;
  Clock::time_point begin_;
};

}  // namespace surefoot::experiments
