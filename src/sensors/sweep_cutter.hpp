// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Cuts the endless stream of a LiDAR's firings into sweeps.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "sensors/packet_decoder.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::sensors {

/// A scan stamped with its first firing, every point with the time of its own.
struct Sweep {
  Scan scan;
  double turned_deg = 0.0;       ///< what the firings cover; less than a turn if partial
  std::int64_t duration_ns = 0;  ///< what the firings last
  bool whole = false;
  bool shares_packet = false;  ///< its last one, with the sweep after it
};

class SweepCutter {
 public:
  /// @param cut_azimuth_deg where a sweep that ends by azimuth begins, in [0, 360).
  /// @param sweep_deg what a whole one covers.
  SweepCutter(SweepEnd end, double cut_azimuth_deg, double sweep_deg);

  /// Adds a packet's firings; its time was `stamp_ns`, `since_last_ns` after the packet before.
  void add(const Firings& packet, std::int64_t stamp_ns, std::int64_t since_last_ns);
  /// Adds a packet that came after one that it precedes, where the sweep at hand has a place for
  /// it. False where that sweep is over, or began later.
  [[nodiscard]] bool add_late(const Firings& packet, std::int64_t stamp_ns);
  /// Ends the sweep at hand, wherever the head is: the end of the stream, or a break in it. A
  /// partial one without any point is dropped.
  void finish();
  /// The next sweep that is ended.
  [[nodiscard]] std::optional<Sweep> take();
  /// Whether any firing waits in a sweep that is not ended.
  [[nodiscard]] bool pending() const { return begun_; }

 private:
  void begin(std::int64_t stamp_ns, std::uint32_t frame);
  [[nodiscard]] bool starts_sweep(const Firing& firing, double past_cut_deg,
                                  std::int64_t stamp_ns) const;
  [[nodiscard]] bool is_whole(const Sweep& sweep) const;

  SweepEnd end_;
  double cut_deg_;
  double sweep_deg_;
  double last_past_cut_deg_ = 0.0;
  std::int64_t turn_ns_ = 0;  ///< by the last firing; 0: the head stands
  std::uint32_t frame_ = 0;
  std::size_t usual_points_ = 0;
  bool begun_ = false;
  Sweep current_;
  std::deque<Sweep> ended_;
};

}  // namespace surefoot::sensors
