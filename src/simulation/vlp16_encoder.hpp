// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Simulated returns as the data packets that a VLP-16 sends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sensors/velodyne/vlp16.hpp"
#include "simulation/scanner.hpp"

namespace surefoot::simulation {

struct Vlp16DataPacket {
  std::int64_t first_firing_ns = 0;  ///< sensor's epoch
  std::int64_t sent_ns = 0;          ///< after the last firing
  std::array<std::byte, vlp16::kPacketBytes> payload{};
};

/// Fills packets with firing sequences, 24 a packet, or 12 where both returns are sent.
class Vlp16Encoder {
 public:
  /// @param start_ns stamp of firing sequence 0. @param dual last and strongest return.
  Vlp16Encoder(std::int64_t start_ns, bool dual);

  /// Packets that became full. Scans must come in order and without gaps.
  [[nodiscard]] std::vector<Vlp16DataPacket> add(const SimulatedScan& scan);
  /// The packet at hand when the recording ends, if there is one. The sensor sends whole packets
  /// only: the firings that are missing in it are there, with their azimuths, but met nothing.
  [[nodiscard]] std::optional<Vlp16DataPacket> finish();

 private:
  void begin_packet(std::uint64_t sequence);
  void put(const RawReturn& value, bool only_return);
  [[nodiscard]] std::size_t sequences_per_packet() const { return dual_ ? 12 : 24; }

  std::int64_t start_ns_;
  bool dual_;
  bool open_ = false;
  std::uint64_t packet_first_ = 0;  ///< sequence that the open packet begins with
  Vlp16DataPacket packet_;
};

}  // namespace surefoot::simulation
