// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/vlp16_packet.hpp"

#include <cmath>
#include <cstdio>

#include "dataset/point_table.hpp"

namespace surefoot::dataset {
namespace {

constexpr std::size_t kFlagBytes = 2;
constexpr std::size_t kBlockHeaderBytes = 4;  // flag and azimuth
constexpr std::size_t kReturnBytes = 3;
constexpr std::size_t kTail = vlp16::kBlocks * vlp16::kBlockBytes;

// 1200 rpm turn 0.8 deg between blocks; a larger step, or none, is no turning head [0.01 deg].
constexpr int kLargestStep = 200;

std::uint16_t little_u16(const std::byte* at) {
  return static_cast<std::uint16_t>(std::to_integer<unsigned>(at[0]) |
                                    std::to_integer<unsigned>(at[1]) << 8U);
}

std::array<Vlp16Return, vlp16::kLasers> returns_at(const std::byte* at) {
  std::array<Vlp16Return, vlp16::kLasers> returns;
  for (Vlp16Return& one : returns) {
    one.distance = little_u16(at);
    one.reflectivity = std::to_integer<std::uint8_t>(at[2]);
    at += kReturnBytes;
  }
  return returns;
}

}  // namespace

std::size_t Vlp16Packet::sequences() const {
  return is_dual() ? vlp16::kBlocks : 2 * vlp16::kBlocks;
}

Vlp16Sequence Vlp16Packet::sequence(std::size_t index, double usual_step) const {
  const std::size_t stride = is_dual() ? 2 : 1;  // blocks of one azimuth
  const std::size_t block = index / 2 * stride;
  const std::size_t channel = index % 2 * vlp16::kLasers;
  const bool last = block + stride >= vlp16::kBlocks;
  const std::size_t from = last ? block - stride : block;
  const int turn = (azimuths[from + stride] - azimuths[from] + vlp16::kAzimuthUnitsPerTurn) %
                   vlp16::kAzimuthUnitsPerTurn;

  Vlp16Sequence sequence;
  const bool turning = turn > 0 && turn <= kLargestStep;
  sequence.azimuth_step = turning ? 0.5 * turn : usual_step;  // a block holds two sequences
  sequence.azimuth = azimuths[block] + (channel > 0 ? sequence.azimuth_step : 0.0);
  sequence.azimuth -=
      sequence.azimuth >= vlp16::kAzimuthUnitsPerTurn ? vlp16::kAzimuthUnitsPerTurn : 0;
  sequence.offset_ns = std::llround(vlp16::firing_offset_ns(block, channel, is_dual()));
  const std::byte* at =
      bytes.data() + block * vlp16::kBlockBytes + kBlockHeaderBytes + channel * kReturnBytes;
  sequence.first = returns_at(at);
  if (is_dual()) {
    sequence.second = returns_at(at + vlp16::kBlockBytes);
  }
  return sequence;
}

std::optional<Vlp16Packet> parse_vlp16_packet(std::span<const std::byte> payload) {
  if (payload.size() != vlp16::kPacketBytes) {
    return std::nullopt;
  }
  Vlp16Packet packet;
  packet.bytes = payload;
  for (std::size_t block = 0; block < vlp16::kBlocks; ++block) {
    const std::byte* at = payload.data() + block * vlp16::kBlockBytes;
    packet.azimuths[block] = little_u16(at + kFlagBytes);
    const bool flagged = at[0] == std::byte{0xff} && at[1] == std::byte{0xee};
    if (!flagged || packet.azimuths[block] >= vlp16::kAzimuthUnitsPerTurn) {
      return std::nullopt;
    }
  }
  const std::byte* tail = payload.data() + kTail;
  packet.past_hour_us = static_cast<std::uint32_t>(little_u16(tail)) |
                        static_cast<std::uint32_t>(little_u16(tail + 2)) << 16U;
  packet.return_mode = std::to_integer<std::uint8_t>(tail[4]);
  packet.product = std::to_integer<std::uint8_t>(tail[5]);
  return packet;
}

std::string product_name(std::uint8_t product) {
  struct Known {
    std::uint8_t product;
    const char* name;
  };
  static constexpr Known kKnown[] = {{0x21, "HDL-32E"},     {0x22, "VLP-16 or Puck LITE"},
                                     {0x24, "Puck Hi-Res"}, {0x28, "VLP-32C"},
                                     {0x31, "Velarray"},    {0xa1, "VLS-128"}};
  char hex[8];
  std::snprintf(hex, sizeof(hex), "0x%02X", product);
  for (const Known& known : kKnown) {
    if (known.product == product) {
      return std::string(hex) + " (" + known.name + ")";
    }
  }
  return std::string(hex) + " (unknown)";
}

std::string return_mode_name(std::uint8_t return_mode) {
  switch (return_mode) {
    case vlp16::kStrongest:
      return "single, strongest";
    case vlp16::kLast:
      return "single, last";
    case vlp16::kDual:
      return "dual";
    default:
      return {};
  }
}

}  // namespace surefoot::dataset
