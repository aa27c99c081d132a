// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>

#include "surefoot/odometry.hpp"

namespace surefoot::runs {

inline constexpr std::array<const char*, 7> kStepNames = {
    "preprocess", "deskew", "downsample", "search", "solve", "assess", "map"};

/// Milliseconds that each step of one scan took; the clock that the library does not read.
class StepTimes {
 public:
  /// For Odometry::set_step_observer.
  void begin(Step step) {
    const auto now = std::chrono::steady_clock::now();
    if (running_ != Step::idle) {
      milliseconds_[static_cast<std::size_t>(running_)] +=
          std::chrono::duration<double, std::milli>(now - since_).count();
    }
    running_ = step;
    since_ = now;
  }
  void reset() { milliseconds_.fill(0.0); }
  [[nodiscard]] const std::array<double, kStepNames.size()>& milliseconds() const {
    return milliseconds_;
  }
  [[nodiscard]] double total() const {
    double sum = 0.0;
    for (const double part : milliseconds_) sum += part;
    return sum;
  }

 private:
  std::array<double, kStepNames.size()> milliseconds_{};
  Step running_ = Step::idle;
  std::chrono::steady_clock::time_point since_;
};

}  // namespace surefoot::runs
