// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/vlp16_encoder.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::simulation {

namespace {

constexpr double kTurnNs = 1e8;  // 600 rpm
constexpr std::int64_t kHourUs = 3'600'000'000;
constexpr std::size_t kTrailer = vlp16::kBlocks * vlp16::kBlockBytes;

void put_u16(std::byte* at, std::uint16_t value) {
  at[0] = static_cast<std::byte>(value & 0xffU);
  at[1] = static_cast<std::byte>(value >> 8);
}

std::uint16_t azimuth_of(std::uint64_t sequence) {
  const double part = std::fmod(static_cast<double>(sequence) * vlp16::kSequenceNs, kTurnNs);
  const long units = std::lround(part / kTurnNs * vlp16::kAzimuthUnitsPerTurn);
  return static_cast<std::uint16_t>(units % vlp16::kAzimuthUnitsPerTurn);
}

}  // namespace

Vlp16Encoder::Vlp16Encoder(std::int64_t start_ns, bool dual) : start_ns_(start_ns), dual_(dual) {}

void Vlp16Encoder::begin_packet(std::uint64_t sequence) {
  open_ = true;
  packet_first_ = sequence - sequence % sequences_per_packet();
  packet_ = Vlp16DataPacket{};
  const auto instant = [&](std::uint64_t at) {
    return start_ns_ + std::llround(static_cast<double>(at) * vlp16::kSequenceNs);
  };
  packet_.first_firing_ns = instant(packet_first_);
  packet_.sent_ns = instant(packet_first_ + sequences_per_packet());
  for (std::size_t block = 0; block < vlp16::kBlocks; ++block) {
    std::byte* at = &packet_.payload[block * vlp16::kBlockBytes];
    const std::size_t pair = dual_ ? block / 2 : block;
    at[0] = std::byte{0xff};
    at[1] = std::byte{0xee};
    put_u16(at + 2, azimuth_of(packet_first_ + 2 * pair));
  }
  std::byte* trailer = &packet_.payload[kTrailer];
  const auto past_hour = static_cast<std::uint32_t>(packet_.first_firing_ns / 1000 % kHourUs);
  put_u16(trailer, static_cast<std::uint16_t>(past_hour & 0xffffU));
  put_u16(trailer + 2, static_cast<std::uint16_t>(past_hour >> 16));
  trailer[4] = static_cast<std::byte>(dual_ ? vlp16::kDual : vlp16::kStrongest);
  trailer[5] = static_cast<std::byte>(vlp16::kProductVlp16);
}

void Vlp16Encoder::put(const RawReturn& value, bool only_return) {
  const std::size_t sequence = value.sequence - packet_first_;
  const std::size_t channel = (sequence % 2) * vlp16::kLasers + value.laser;
  const auto write = [&](std::size_t block) {
    std::byte* at = &packet_.payload[block * vlp16::kBlockBytes + 4 + 3 * channel];
    const long units = std::lround(value.range / vlp16::kDistanceUnit);
    put_u16(at, static_cast<std::uint16_t>(std::clamp(units, 0L, 65535L)));
    at[2] = static_cast<std::byte>(value.intensity);
  };
  if (!dual_) return write(sequence / 2);
  // Even blocks hold the last return, odd ones the strongest, or the second strongest where the
  // last is the strongest itself. A single return stands in both.
  const std::size_t even = 2 * (sequence / 2);
  if (only_return || value.last) write(even);
  if (only_return || !value.last) write(even + 1);
}

std::vector<Vlp16DataPacket> Vlp16Encoder::add(const SimulatedScan& scan) {
  std::vector<Vlp16DataPacket> full;
  std::size_t next = 0;
  for (std::uint64_t sequence = scan.first_sequence; sequence < scan.end_sequence; ++sequence) {
    if (open_ && sequence >= packet_first_ + sequences_per_packet()) {
      full.push_back(packet_);
      open_ = false;
    }
    if (!open_) begin_packet(sequence);
    for (; next < scan.raw.size() && scan.raw[next].sequence == sequence; ++next) {
      const auto same_beam = [&](std::size_t other) {
        return other < scan.raw.size() && scan.raw[other].sequence == sequence &&
               scan.raw[other].laser == scan.raw[next].laser;
      };
      const bool paired = same_beam(next + 1) || (next > 0 && same_beam(next - 1));
      put(scan.raw[next], !paired);
    }
  }
  return full;
}

std::optional<Vlp16DataPacket> Vlp16Encoder::finish() {
  if (!open_) return std::nullopt;
  open_ = false;
  return packet_;
}

}  // namespace surefoot::simulation
