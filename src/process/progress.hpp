// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace surefoot::process {

/// A time span as "2:07" or "1:02:07".
[[nodiscard]] std::string clock_text(double seconds);

/// Progress on stderr: a bar with rate and remaining time on a terminal, a plain line now and then
/// elsewhere.
class Progress {
 public:
  /// `unit`: what is counted, "scans". `quiet`: nothing is shown.
  Progress(std::string unit, bool quiet);
  /// `share` of the work that is done, 0..1.
  void update(std::size_t done, double share);
  /// Clears the bar's line, so that other lines can be printed.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string unit_;
  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
};

}  // namespace surefoot::process
