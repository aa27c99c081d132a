// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a VLP-16 data packet says, one firing sequence of 16 lasers after the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "sensor/vlp16.hpp"

namespace surefoot::dataset {

struct Vlp16Return {
  std::uint16_t distance = 0;  ///< [2 mm]; 0: no return
  std::uint8_t reflectivity = 0;
};

/// One firing of all 16 lasers, 2.304 us apart, while the head turns on.
struct Vlp16Sequence {
  std::int64_t offset_ns = 0;  ///< first laser's firing after the packet's stamp
  double azimuth = 0.0;        ///< of the first laser [0.01 deg], in [0, 36000)
  double azimuth_step = 0.0;   ///< from this sequence to the next [0.01 deg]
  /// By laser id. A single-return packet fills `first` alone; in a dual-return one `first` is the
  /// last return and `second` the strongest, or the second strongest where the last one is it.
  std::array<Vlp16Return, vlp16::kLasers> first, second;
};

struct Vlp16Packet {
  std::uint32_t past_hour_us = 0;  ///< of the first firing
  std::uint8_t return_mode = 0;
  std::uint8_t product = 0;
  std::array<std::uint16_t, vlp16::kBlocks> azimuths{};  ///< by block [0.01 deg]
  std::span<const std::byte> bytes;                      ///< looks into the payload

  [[nodiscard]] bool is_dual() const { return return_mode == vlp16::kDual; }
  /// Firing sequences: 24 with one return, 12 with two.
  [[nodiscard]] std::size_t sequences() const;
  /// Sequence `index`; the azimuth is interpolated to the block that follows, over zero too. For
  /// the last block the turn of the one before is taken, and `usual_step` [0.01 deg] wherever the
  /// step between two blocks is not one that a turning head makes.
  [[nodiscard]] Vlp16Sequence sequence(std::size_t index, double usual_step) const;
};

/// Nothing where the payload is not a Velodyne data packet: its size, a block's flag or an azimuth
/// is wrong. Return mode and product are for the caller to judge.
[[nodiscard]] std::optional<Vlp16Packet> parse_vlp16_packet(std::span<const std::byte> payload);

/// "0x21 (HDL-32E)".
[[nodiscard]] std::string product_name(std::uint8_t product);
/// "single, strongest"; empty for a mode that is not known.
[[nodiscard]] std::string return_mode_name(std::uint8_t return_mode);

}  // namespace surefoot::dataset
