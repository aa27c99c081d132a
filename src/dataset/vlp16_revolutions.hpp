// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Cuts the endless stream of a VLP-16's firings into revolutions.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "dataset/recording.hpp"
#include "dataset/vlp16_packet.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::dataset {

/// A revolution: a scan stamped with its first firing, every point with the time of its own.
struct Revolution {
  Scan scan;
  double turned_deg = 0.0;  ///< what the firings cover; less than 360 if partial or with losses

  [[nodiscard]] bool is_whole() const { return turned_deg > 359.0; }
};

/// Frame as in the ROS driver: x forward where the azimuth is zero, azimuth clockwise seen from
/// above: x = d cos(el) cos(az), y = -d cos(el) sin(az), z = d sin(el) (+ the laser's own height).
/// Lasers without a return give no point.
class Vlp16Revolutions {
 public:
  explicit Vlp16Revolutions(const OpenOptions& options);

  /// Adds a packet whose first firing was at `stamp_ns`, `since_last_ns` after the one before.
  void add(const Vlp16Packet& packet, std::int64_t stamp_ns, std::int64_t since_last_ns);
  /// Ends the revolution at hand, wherever the head is: the end of the stream, or a break in it.
  /// A partial one without any point is dropped.
  void finish();
  /// The next revolution that is ended.
  [[nodiscard]] std::optional<Revolution> take();
  /// Whether any firing waits in a revolution that is not ended.
  [[nodiscard]] bool pending() const { return begun_; }

 private:
  void begin(std::int64_t stamp_ns);
  [[nodiscard]] bool starts_revolution(double position, std::int64_t stamp_ns) const;
  void add_sequence(const Vlp16Sequence& sequence, bool dual, std::int64_t stamp_ns);
  void add_point(int laser, Vlp16Return measured, double cosine, double sine, std::int32_t time_ns);

  struct Laser {
    double cosine, sine, height;  ///< of the elevation; origin above the sensor's [m]
  };
  std::array<Laser, vlp16::kLasers> lasers_;
  ReturnChoice choice_;
  double cut_;                  ///< [0.01 deg]
  double usual_step_ = 19.9;    ///< of the last good sequence; at first that of 600 rpm [0.01 deg]
  double last_position_ = 0.0;  ///< azimuth past the cut [0.01 deg]
  std::size_t usual_points_ = 0;
  bool begun_ = false;
  Revolution current_;
  std::deque<Revolution> ended_;
};

}  // namespace surefoot::dataset
