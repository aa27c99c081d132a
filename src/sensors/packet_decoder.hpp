// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The seam between sensors and all that reads packets: a decoder turns the payload of one packet
// into firings. Where packets come from (a capture, a bag, a socket) it does not know.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#include "sensors/firings.hpp"

namespace surefoot::sensors {

/// A calibration or metadata file that cannot be used; says what was seen and what was expected.
class CalibrationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which of several returns of one laser pulse are kept.
enum class ReturnChoice { strongest, last, both };

struct DecoderOptions {
  ReturnChoice returns = ReturnChoice::strongest;
  /// Let beams start where they leave the sensor, where the maker's formula leaves that open.
  bool beam_origins = true;
  /// Content of the unit's calibration or metadata file; empty: the table of its manual.
  std::string calibration;
  /// What came with the packets and may be what the sensor says about itself (Ouster's JSON).
  std::string metadata;
};

/// What ends a sweep.
enum class SweepEnd {
  azimuth,  ///< the head passes the azimuth of the cut
  frame,    ///< the sensor counts the next frame
  time      ///< a tenth of a second is over
};

enum class PacketKind {
  data,      ///< firings
  other,     ///< the sensor's or another's, but no firings: IMU, status, another product
  malformed  ///< firings by its size, but its content contradicts itself
};

/// Knows one sensor's packets. Keeps what has to be known from earlier packets.
class PacketDecoder {
 public:
  virtual ~PacketDecoder() = default;

  /// Fills `firings` (cleared first) where the payload holds some. Any payload is safe.
  [[nodiscard]] virtual PacketKind decode(std::span<const std::byte> payload, Firings& firings) = 0;
  /// "VLP-16".
  [[nodiscard]] virtual std::string sensor() const = 0;
  /// Of the last data packet: "single, strongest".
  [[nodiscard]] virtual std::string return_mode() const = 0;
  [[nodiscard]] virtual SweepEnd sweep_end() const = 0;
  /// What a whole sweep covers [deg]; less for a sensor that is set to a window.
  [[nodiscard]] virtual double sweep_deg() const { return 360.0; }
};

}  // namespace surefoot::sensors
