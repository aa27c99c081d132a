// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "surefoot/odometry.hpp"

namespace surefoot::live {

/// Who watches a live run, told on the run's thread.
class LiveViewer {
 public:
  virtual ~LiveViewer() = default;
  /// A scan's answer, and what `odometry` has of it yet.
  virtual void answered(const std::string& name, const Estimate& estimate,
                        const Odometry& odometry) = 0;
  /// Its pose is written.
  virtual void used(double latency_ms) = 0;
};

}  // namespace surefoot::live
