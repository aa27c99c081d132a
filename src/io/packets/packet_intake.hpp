// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// From datagrams to one sensor's scans, whether a capture holds them or a socket brings them: what
// is another's, or no data, is counted and left alone.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/packets/packet_scans.hpp"
#include "io/packets/udp_datagram.hpp"

namespace surefoot::io {

class PacketIntake {
 public:
  /// @param metadata as of PacketScans. Throws what that throws.
  PacketIntake(const OpenOptions& options, std::string metadata)
      : port_(options.udp_port), scans_(options, std::move(metadata)) {}

  /// @param arrival_ns when the datagram was received. Throws ReadError where the calibration does
  /// not fit the sensor.
  void add(std::int64_t arrival_ns, const UdpDatagram& datagram);

  /// Its scans are taken there.
  [[nodiscard]] PacketScans& scans() { return scans_; }
  [[nodiscard]] const PacketScans& scans() const { return scans_; }
  /// The address that its data packets come from, and the port that they go to.
  [[nodiscard]] std::pair<std::uint32_t, std::uint16_t> stream() const { return stream_; }
  /// Of datagrams by what became of them; `lost` by the sensor's clock.
  [[nodiscard]] CaptureCounts counts() const;
  /// What there was instead of a sensor's data, for messages: "; most are of 512 bytes to port 9".
  [[nodiscard]] std::string traffic_seen() const;
  /// Other sensors of the kind, which are not read. Grows while packets are added.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// " to UDP port 2368" where only that one is listened to.
  [[nodiscard]] std::string port_text() const;

 private:
  // Where packets come from: the sensor's address, and the port that they go to.
  using Stream = std::pair<std::uint32_t, std::uint16_t>;

  void use(std::int64_t arrival_ns, const UdpDatagram& datagram);
  void remember_traffic(const UdpDatagram& datagram);
  void look_for_another(const UdpDatagram& datagram);

  std::uint16_t port_;
  PacketScans scans_;
  CaptureCounts counts_;
  Stream stream_ = {};
  std::size_t data_bytes_ = 0;  ///< of a data packet
  std::set<Stream> others_;     ///< that send as many
  std::vector<std::string> notes_;
  std::map<std::pair<std::uint16_t, std::size_t>, std::size_t> traffic_;  ///< by port and size
};

}  // namespace surefoot::io
