// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace surefoot {

/// The clock that scans are stamped with, as the odometry needs it: one that only goes on. A scan
/// that comes late, or twice, is refused; where the clock was set, the scans after it are followed
/// at the time that the clock would have had.
class ScanClock {
 public:
  /// Why a scan with these stamps [ns] cannot be used; empty: it can.
  [[nodiscard]] std::string objection(std::int64_t mid_ns, std::int64_t end_ns) const;
  /// Remembers that this scan was refused for its stamps.
  void refuse(std::int64_t mid_ns);
  /// Follows a scan that nothing is said against. Returns by how much what goes on is ahead of what
  /// the scans are stamped with [ns].
  std::int64_t follow(std::int64_t mid_ns);
  /// The middle of the last scan that was used, by the time that goes on.
  void used(std::int64_t mid_ns) { last_mid_ns_ = mid_ns; }
  /// By which the time that goes on is ahead of the stamps of the last scan that was followed [ns].
  [[nodiscard]] std::int64_t ahead_ns() const { return ahead_ns_; }

 private:
  [[nodiscard]] bool stays(std::int64_t mid_ns) const;

  std::optional<std::int64_t> last_mid_ns_;  // by the time that goes on
  std::int64_t ahead_ns_ = 0;                // by which the clock was set back, in all
  int refused_ = 0;                          // scans in a row, of stamps that rise
  std::int64_t refused_mid_ns_ = 0;          // of the last of these
};

}  // namespace surefoot
