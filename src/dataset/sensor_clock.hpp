// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::dataset {

/// Turns a Velodyne's time past the hour into absolute stamps.
///
/// The sensor's clock says how packets follow each other, the capture's clock only which hour it
/// is. Where the two disagree by more than 2 s (a sensor without GPS counts from power-on), the
/// first packet gets the capture's time and the others count on from it by the sensor's clock.
class SensorClock {
 public:
  struct Reading {
    std::int64_t stamp_ns = 0;
    std::int64_t since_last_ns = 0;  ///< 0 for the first packet
    bool jumped = false;  ///< the sensor's clock was set; the capture's time bridges the jump
  };

  /// Stamp of a packet, or nothing for one that is not later than the one before (repeated or out
  /// of order). `past_hour_us` is taken modulo one hour.
  [[nodiscard]] std::optional<Reading> read(std::uint32_t past_hour_us, std::int64_t capture_ns);

  /// What was decided, for the user.
  [[nodiscard]] const std::string& note() const { return note_; }

 private:
  Reading start(std::int64_t past_hour_ns, std::int64_t capture_ns);

  bool started_ = false;
  std::int64_t last_past_hour_ns_ = 0;
  std::int64_t last_capture_ns_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  std::string note_;
};

}  // namespace surefoot::dataset
