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
      spans_.push_back({stamp_ns, stamp_ns, stamp_ns});
    } else if (stamp_ns < spans_.back().last_ns) {
      spans_.push_back({stamp_ns, stamp_ns, last_ns_ + kRefused});
    }
    spans_.back().last_ns = stamp_ns;
    last_ns_ = spans_.back().at(stamp_ns);
    return last_ns_;
  }

  /// Of the first pose.
  [[nodiscard]] std::int64_t begin_ns() const { return spans_.empty() ? 0 : spans_[0].time_ns; }

  /// When the clock showed a stamp; for the last time, if it did so before it was set back and
  /// after; as if it had gone on to there, or come from there, if it never did.
  [[nodiscard]] std::int64_t at(std::int64_t stamp_ns) const {
    if (spans_.empty()) return stamp_ns;
    stamp_ns = std::clamp(stamp_ns, -kFarthest, kFarthest);
    const auto nearer = [&](const Span& a, const Span& b) {
      return a.away(stamp_ns) < b.away(stamp_ns);
    };
    return std::min_element(spans_.rbegin(), spans_.rend(), nearer)->at(stamp_ns);
  }

 private:
  // [ns] An odometry refuses about so long of scans before it follows a clock that was set back.
  static constexpr std::int64_t kRefused = 1'000'000'000;
  // [ns] Anything may be asked for; what a sensor shows can be subtracted from these.
  static constexpr std::int64_t kFarthest = std::int64_t{1} << 62;

  /// From a pose on until the clock is set back.
  struct Span {
    std::int64_t stamp_ns = 0, last_ns = 0;  // the first pose's and the last one's
    std::int64_t time_ns = 0;                // of the first one

    [[nodiscard]] std::int64_t away(std::int64_t stamp) const {
      return std::max({stamp_ns - stamp, stamp - last_ns, std::int64_t{0}});
    }
    [[nodiscard]] std::int64_t at(std::int64_t stamp) const { return time_ns + (stamp - stamp_ns); }
  };

  std::vector<Span> spans_;
  std::int64_t last_ns_ = 0;
};

}  // namespace surefoot::mapping
