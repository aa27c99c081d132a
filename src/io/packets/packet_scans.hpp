// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans from the packets of one sensor, whoever brings them: a capture, a bag, a socket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/recording.hpp"
#include "io/sensor_clock.hpp"
#include "sensors/packet_decoder.hpp"
#include "sensors/sweep_cutter.hpp"

namespace surefoot::io {

/// What became of a packet.
enum class PacketUse {
  used,
  late,      ///< repeated, or so late that its sweep is over: skipped
  other,     ///< not firings: skipped
  malformed  ///< contradicts itself: skipped
};

/// Feed it packets with add() and take scans with take() until there is none; at the end of the
/// stream call finish() and take the rest. The sensor is found out from the packets.
class PacketScans {
 public:
  /// @param metadata what comes with the packets and may be what the sensor says about itself
  /// (Ouster's JSON: a file beside a capture, a topic of a bag); the options' calibration file goes
  /// before it. Throws ReadError where that cannot be read, or the options' sensor is not known.
  explicit PacketScans(const OpenOptions& options, std::string metadata = {});
  ~PacketScans();
  PacketScans(const PacketScans&) = delete;
  PacketScans& operator=(const PacketScans&) = delete;

  /// @param arrival_ns when the packet was received: the capture's stamp, the message's stamp.
  /// @param payload of the UDP datagram, no longer needed afterwards. Any bytes are safe.
  /// Throws ReadError where the calibration does not fit the sensor that the packet is from.
  PacketUse add(std::int64_t arrival_ns, std::span<const std::byte> payload);
  /// Ends the sweep at hand.
  void finish();
  /// The next scan that is whole or ended, named "revolution N".
  [[nodiscard]] std::optional<ScanItem> take();

  /// Whether the scan that was taken last shares its last packet with the one after it.
  [[nodiscard]] bool shared_packet() const { return shared_packet_; }

  /// Whether the sensor is known: a data packet was seen.
  [[nodiscard]] bool found() const { return decoder_ != nullptr; }
  /// Whether any firing waits in a scan that is not ended.
  [[nodiscard]] bool pending() const;
  /// Why packets that look like a LiDAR's were not taken; empty: none did.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// "VLP-16".
  [[nodiscard]] std::string sensor() const;
  /// "single, strongest".
  [[nodiscard]] std::string return_mode() const;
  /// Data packets that are missing, by the packets' numbers or the sensor's clock.
  [[nodiscard]] std::size_t lost() const { return lost_; }
  /// Data packets that came after one that they precede, and were put where they belong.
  [[nodiscard]] std::size_t reordered() const { return reordered_; }
  /// Return mode, clock, and what happened to it: grows while packets are added.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Where stamps come from: "the sensor's time past the hour".
  [[nodiscard]] const std::string& time_source() const { return clock_.source(); }

 private:
  void begin();
  void note_other_name(std::span<const std::byte> payload);
  void note_jump();
  void count_lost(const SensorClock::Reading& reading);
  PacketUse add_late();

  /// Where packets were missing when the next one came; they may come yet.
  struct Hole {
    std::int64_t after_ns = 0, before_ns = 0;  ///< stamps of those at its ends
    std::uint64_t missing = 0;
    std::vector<std::int64_t> filled_ns;
  };

  OpenOptions options_;
  sensors::DecoderOptions decoder_options_;
  std::string calibration_name_;
  std::unique_ptr<sensors::PacketDecoder> decoder_;
  std::optional<sensors::SweepCutter> cutter_;
  SensorClock clock_;
  sensors::Firings firings_;
  std::optional<std::uint64_t> last_number_;
  std::int64_t last_period_ns_ = 0;
  std::deque<Hole> holes_;  ///< the last ones
  std::size_t lost_ = 0, reordered_ = 0;
  std::size_t next_ = 0;
  std::size_t jumps_ = 0;
  bool shared_packet_ = false;
  std::string reason_;
  std::vector<std::string> notes_;
};

}  // namespace surefoot::io
