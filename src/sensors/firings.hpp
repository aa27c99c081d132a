// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a packet of a LiDAR says once its format is understood: points with the instants at which
// they were measured, in the groups in which they were fired. All sensors speak it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace surefoot::sensors {

/// A return. Beams that met nothing give none.
struct FiringPoint {
  Eigen::Vector3f position;    ///< [m], in the frame that the sensor's maker uses
  float intensity = 0.0F;      ///< as the sensor gives it
  std::int32_t offset_ns = 0;  ///< after its firing
  std::uint16_t ring = 0;      ///< laser, counted from the lowest
};

/// What is fired from one place of a sweep: the lasers of a spinning head once, a column.
struct Firing {
  std::int64_t offset_ns = 0;    ///< after the packet's time; may be negative
  std::int64_t duration_ns = 0;  ///< until the next firing
  double azimuth_deg = 0.0;      ///< of the head, clockwise as the sensor counts it, in [0, 360)
  double turned_deg = 0.0;       ///< until the next firing
  std::uint32_t frame = 0;       ///< number of the sweep, of sensors that number them
  std::size_t end = 0;           ///< one past its last point in Firings::points
};

/// What the time in a packet counts from.
enum class TimeBase {
  hour,     ///< GPS or the sensor's start, modulo one hour
  absolute  ///< the epoch (GPS, PTP), or the sensor's start where it is too small for that
};

struct Firings {
  std::int64_t time_ns = 0;  ///< the packet's time, by the sensor's clock
  TimeBase base = TimeBase::absolute;
  std::int64_t period_ns = 0;  ///< until the next packet's time; 0: not known
  /// Number of the packet, counted modulo `numbers`; 0 numbers: it has none.
  std::uint64_t number = 0;
  std::uint64_t numbers = 0;
  std::vector<Firing> firings;
  std::vector<FiringPoint> points;

  void clear() {
    *this = Firings{.firings = std::move(firings), .points = std::move(points)};
    firings.clear();
    points.clear();
  }
};

}  // namespace surefoot::sensors
