// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is said of a run while it goes on, counted, and noted for its run.yaml.
#pragma once

#include <string>
#include <vector>

#include "io/recording.hpp"
#include "runs/odometry_run.hpp"

namespace surefoot::runs {

class RunAccount {
 public:
  /// `outcome` is counted in. Both must outlive it.
  RunAccount(const RunListener& listener, RunOutcome& outcome)
      : listener_(listener), outcome_(outcome) {}

  /// Says what the recording has noted since it was asked last.
  void say_notes_of(const io::Recording& recording);
  /// A note of the run's own; not said.
  void note(std::string text) { own_.push_back(std::move(text)); }
  /// A scan that could not be read.
  void leave_out(const io::ScanItem& item);
  /// A scan that was answered in so many milliseconds.
  void add(const io::ScanItem& item, const Estimate& estimate, double milliseconds);

  /// The recording's that were said, then the run's own.
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Scans whose pose is no measurement.
  [[nodiscard]] std::size_t untrusted() const;

 private:
  void tell(const io::ScanItem& item, const Estimate& estimate);

  const RunListener& listener_;
  RunOutcome& outcome_;
  std::vector<std::string> said_;  // the recording's notes
  std::vector<std::string> own_;
  Status last_status_ = Status::ok;
  int last_segment_ = 0;  // of the last trusted scan
};

}  // namespace surefoot::runs
