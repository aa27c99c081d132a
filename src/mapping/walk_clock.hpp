// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace surefoot::mapping {

/// Time along a walk [ns]: the sensor's, by which poses are stamped, but where its clock was set
/// back, since nothing of a map may be of a time before what was walked before it.
class WalkClock {
 public:
  /// The next pose's, of those that are asked for in the order in which they came.
  std::int64_t next(std::int64_t stamp_ns) {
    if (spans_.empty()) {
      spans_.push_back({stamp_ns, stamp_ns});
    } else if (stamp_ns < last_stamp_ns_) {
      spans_.push_back({stamp_ns, last_ns_ + kRefused});
    }
    last_stamp_ns_ = stamp_ns;
    last_ns_ = spans_.back().at(stamp_ns);
    return last_ns_;
  }

  /// Of the first pose.
  [[nodiscard]] std::int64_t begin_ns() const { return spans_.empty() ? 0 : spans_[0].time_ns; }

  /// When the clock showed a stamp; for the last time, if it did so before it was set back and
  /// after.
  [[nodiscard]] std::int64_t at(std::int64_t stamp_ns) const {
    const auto shown = [&](const Span& span) { return span.stamp_ns <= stamp_ns; };
    const auto last = std::find_if(spans_.rbegin(), spans_.rend(), shown);
    if (last != spans_.rend()) return last->at(stamp_ns);
    return spans_.empty() ? stamp_ns : spans_.front().at(stamp_ns);
  }

 private:
  // [ns] An odometry refuses about so long of scans before it follows a clock that was set back.
  static constexpr std::int64_t kRefused = 1'000'000'000;

  /// From a pose on until the clock is set back.
  struct Span {
    std::int64_t stamp_ns = 0, time_ns = 0;  // of its first pose

    [[nodiscard]] std::int64_t at(std::int64_t stamp) const { return time_ns + (stamp - stamp_ns); }
  };

  std::vector<Span> spans_;
  std::int64_t last_stamp_ns_ = 0, last_ns_ = 0;
};

}  // namespace surefoot::mapping
