// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace surefoot::process {

namespace {

constexpr double kTerminalPeriod = 0.1;  // [s]
constexpr double kPlainPeriod = 5.0;     // [s]
constexpr int kBarWidth = 30;

}  // namespace

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

Progress::Progress(std::string unit, bool quiet)
    : unit_(std::move(unit)), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(std::size_t done, double share) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const double since_shown = std::chrono::duration<double>(now - shown_).count();
  if (since_shown < (terminal_ ? kTerminalPeriod : kPlainPeriod)) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double part = std::clamp(share, 0.0, 1.0);
  std::string text = fmt::format("{:3.0f} %  {} {}  {:.0f} {}/s", 100.0 * part, done, unit_,
                                 static_cast<double>(done) / elapsed, unit_);
  if (part > 0.0) text += fmt::format("  {} left", clock_text(elapsed / part * (1.0 - part)));
  if (terminal_) {
    const int filled = static_cast<int>(part * kBarWidth);
    fmt::print(stderr, "\r\033[K[{:=<{}}{:{}}] {}", "", filled, "", kBarWidth - filled, text);
    bar_shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
}

void Progress::finish() {
  if (bar_shown_) fmt::print(stderr, "\r\033[K");
  bar_shown_ = false;
  std::fflush(stderr);
}

}  // namespace surefoot::process
