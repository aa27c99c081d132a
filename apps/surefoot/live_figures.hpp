// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a live run keeps up: as a line, and as a diagnosis that is published.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "io/bags/bag_writer.hpp"
#include "live/live_recording.hpp"

namespace surefoot::app {

/// "90 scans, 0 dropped; from last packet to pose 7.7 ms median, ...".
[[nodiscard]] std::string state_text(const live::LiveFigures& figures);

/// Beside a run's own messages, once a second, also while nothing comes.
class LivePublisher {
 public:
  explicit LivePublisher(std::shared_ptr<io::BagWriter> messages);
  void tell(const live::LiveFigures& figures);

 private:
  std::shared_ptr<io::BagWriter> messages_;
  std::size_t topic_;
  std::chrono::steady_clock::time_point told_;
};

}  // namespace surefoot::app
