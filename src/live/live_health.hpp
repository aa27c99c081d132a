// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a live run keeps up: as a line, and as a diagnosis that is published.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "io/bags/bag_writer.hpp"
#include "io/messages/pose_messages.hpp"
#include "live/live_recording.hpp"

namespace surefoot::live {

/// "90 scans, 0 dropped; from last packet to pose 7.7 ms median, ...".
[[nodiscard]] std::string state_text(const LiveFigures& figures);

/// How a live run keeps up, as a diagnosis: a sensor that says nothing is an error, what was lost
/// to others a warning.
[[nodiscard]] io::Diagnostic health_of(const LiveFigures& figures, std::int64_t stamp_ns);

/// Tells it beside a run's own messages, once a second, also while nothing comes.
class HealthPublisher {
 public:
  explicit HealthPublisher(std::shared_ptr<io::BagWriter> messages);
  void tell(const LiveFigures& figures);

 private:
  std::shared_ptr<io::BagWriter> messages_;
  std::size_t topic_;
  std::chrono::steady_clock::time_point told_;
};

}  // namespace surefoot::live
