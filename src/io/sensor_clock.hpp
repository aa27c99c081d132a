// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sensors/firings.hpp"

namespace surefoot::io {

/// Turns the times in a sensor's packets into absolute stamps.
///
/// The sensor's clock says how packets follow each other; the clock of whoever received them (the
/// arrival) says no more than which hour it is, of sensors that count within the hour, and where to
/// begin, of sensors that count from their own start or disagree with it by more than 2 s. A time
/// since the epoch (GPS or PTP) is taken as it is. Either clock may be set: where the sensor's goes
/// on by less than 2 s, it is believed.
class SensorClock {
 public:
  struct Reading {
    std::int64_t stamp_ns = 0;
    std::int64_t since_last_ns = 0;  ///< 0 for the first packet
    /// The sensor's clock was set; the arrival's clock bridges the jump, or, if that was set back
    /// as well, as much as passed between the two packets before.
    bool jumped = false;
  };

  /// Stamp of a packet, or nothing for one that is not later than the one before (repeated or out
  /// of order) or whose time is none. Where packets stay behind for longer than a tenth of a second
  /// of arrivals, the clock was set back: a jump.
  [[nodiscard]] std::optional<Reading> read(std::int64_t time_ns, sensors::TimeBase base,
                                            std::int64_t arrival_ns);

  /// Stamp of a packet that is earlier than the last one by less than a set clock would be.
  [[nodiscard]] std::optional<std::int64_t> stamp_before_last(std::int64_t time_ns,
                                                              sensors::TimeBase base) const;

  /// What was decided, for the user.
  [[nodiscard]] const std::string& note() const { return note_; }
  /// "GPS or PTP", "time past the hour", ...
  [[nodiscard]] const std::string& source() const { return source_; }

 private:
  Reading start(std::int64_t time_ns, sensors::TimeBase base, std::int64_t arrival_ns);
  [[nodiscard]] std::optional<Reading> go_on(std::int64_t time_ns, bool past_hour,
                                             std::int64_t arrival_ns) const;

  bool started_ = false;
  std::int64_t last_time_ns_ = 0;
  std::int64_t last_arrival_ns_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  std::int64_t last_step_ns_ = 1'000'000;  // [ns] about a packet, until it is known
  std::string note_;
  std::string source_;
};

}  // namespace surefoot::io
