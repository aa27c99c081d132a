// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// This program once more, as a process of its own: what kills it, or what it needs of memory, is
// its own affair.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/exit_codes.hpp"

namespace surefoot::process {

/// How a process ended and what it needed.
struct ProcessEnd {
  int exit_code = -1;  ///< -1: ended by a signal
  int signal = 0;
  double wall_seconds = 0.0;
  double processor_seconds = 0.0;       ///< user and system, all threads
  std::uint64_t peak_memory_bytes = 0;  ///< largest resident set

  /// It did what it was to do, be it with something that failed on the way.
  [[nodiscard]] bool is_done() const { return exit_code == kDone || exit_code == kSomeFailed; }
};

class ChildProcess {
 public:
  /// Starts this program with the arguments; both of its output streams go to `log`. It ends with
  /// its parent. Throws std::system_error.
  ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log);
  /// Nothing while it runs; to be called until it gives the end, once.
  [[nodiscard]] std::optional<ProcessEnd> poll();
  void send(int signal) const;

 private:
  pid_t id_;
  std::chrono::steady_clock::time_point begin_;
};

/// "ended with exit code 2", "killed by signal 9 (Killed): ...".
[[nodiscard]] std::string describe(const ProcessEnd& end);

}  // namespace surefoot::process
