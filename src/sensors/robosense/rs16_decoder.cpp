// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/robosense/rs16_decoder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>

#include "sensors/bytes.hpp"
#include "sensors/calendar.hpp"

namespace surefoot::sensors {
namespace {

// RS-LiDAR-16 user guide, chapter 4, and github.com/RoboSense-LiDAR/rs_driver.
constexpr std::size_t kPacketBytes = 1248;
constexpr std::array<std::uint8_t, 8> kMagic = {0x55, 0xaa, 0x05, 0x0a, 0x5a, 0xa5, 0x50, 0xa0};
constexpr std::size_t kDate = 20;
constexpr std::size_t kModel = 30;
constexpr std::uint8_t kRs32 = 2, kBpearl = 3;  // whose packets are alike but for this
constexpr std::size_t kBlocksAt = 42;
constexpr std::size_t kBlocks = 12;
constexpr std::size_t kBlockBytes = 100;
constexpr std::size_t kBlockHeaderBytes = 4;
constexpr std::size_t kReturnBytes = 3;
constexpr std::size_t kLasers = 16;
constexpr double kDistanceUnit = 0.005;  // [m]
constexpr double kLens = 0.03825;        // the beams' origin is so far from the axis [m]
constexpr double kSequenceNs = 55'500.0;
constexpr double kLaserNs = 2'800.0;
constexpr int kUnitsPerTurn = 36'000;
constexpr int kLargestStep = 100;  // rs_driver's, too [0.01 deg]
constexpr double kUnit = 0.01 * std::numbers::pi / 180.0;

// Big-endian on the wire.
std::uint16_t u16(const std::byte* at) {
  return load<std::uint16_t>(at, std::endian::native == std::endian::little);
}

constexpr int elevation_deg(std::size_t laser) {
  const int index = static_cast<int>(laser);
  return index < 8 ? -15 + 2 * index : 15 - 2 * (index - 8);
}

bool has_magic(std::span<const std::byte> payload) {
  return payload.size() == kPacketBytes &&
         std::equal(kMagic.begin(), kMagic.end(), payload.begin(),
                    [](std::uint8_t a, std::byte b) { return std::byte{a} == b; });
}

}  // namespace

std::string other_robosense_model(std::span<const std::byte> payload) {
  if (!has_magic(payload)) return {};
  const auto model = std::to_integer<std::uint8_t>(payload[kModel]);
  return model == kRs32 ? "RS-LiDAR-32" : model == kBpearl ? "RS-Bpearl" : "";
}

struct Rs16Decoder::Sequence {
  std::size_t channel = 0;  ///< of the first laser
  double azimuth = 0.0;     ///< [0.01 deg]
  double per_ns = 0.0;      ///< how fast the head turns [0.01 deg / ns]
};

/// The packet's time and its blocks' azimuths, and whether they hold two returns each.
PacketKind Rs16Decoder::read_head(std::span<const std::byte> payload, Azimuths& azimuths,
                                  Firings& firings) {
  if (!has_magic(payload) || !other_robosense_model(payload).empty()) return PacketKind::other;
  const std::optional<std::int64_t> second = unix_seconds(payload.subspan(kDate));
  const std::uint16_t milliseconds = u16(&payload[kDate + 6]);
  const std::uint16_t microseconds = u16(&payload[kDate + 8]);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const std::byte* at = &payload[kBlocksAt + block * kBlockBytes];
    azimuths[block] = u16(at + 2);
    if (u16(at) != 0xffee || azimuths[block] >= kUnitsPerTurn) return PacketKind::malformed;
  }
  if (!second || milliseconds > 999 || microseconds > 999) return PacketKind::malformed;
  firings.base = TimeBase::absolute;
  firings.time_ns = *second * 1'000'000'000 + milliseconds * 1'000'000LL + microseconds * 1'000LL;
  if (last_time_ns_) learn_mode(firings.time_ns - *last_time_ns_);
  last_time_ns_ = firings.time_ns;
  return PacketKind::data;
}

/// A block holds two firing sequences, or one with both its returns: then packets come twice as
/// often, by which they are known. Where one is lost the next two are as far apart as single ones.
void Rs16Decoder::learn_mode(std::int64_t since_ns) {
  constexpr std::int64_t kBetween = 1'000'000;  // 0.67 ms and 1.33 ms
  constexpr int kNotLost = 8;
  if (since_ns <= 0) return;
  far_apart_ = since_ns < kBetween ? 0 : std::min(far_apart_ + 1, kNotLost);
  if (far_apart_ == 0) dual_ = true;
  if (far_apart_ >= kNotLost) dual_ = false;
}

PacketKind Rs16Decoder::decode(std::span<const std::byte> payload, Firings& firings) {
  firings.clear();
  Azimuths azimuths{};
  static_assert(std::tuple_size_v<Azimuths> == kBlocks);
  if (const PacketKind kind = read_head(payload, azimuths, firings); kind != PacketKind::data) {
    return kind;
  }
  const std::size_t per_block = dual_ ? 1 : 2;
  const double block_ns = kSequenceNs * static_cast<double>(per_block);
  firings.period_ns = std::llround(block_ns * kBlocks);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const int turn = block + 1 < kBlocks
                         ? (azimuths[block + 1] - azimuths[block] + kUnitsPerTurn) % kUnitsPerTurn
                         : 0;
    usual_step_ = turn > 0 && turn <= kLargestStep ? turn : usual_step_;
    for (std::size_t i = 0; i < per_block; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(per_block);
      Sequence sequence{i * kLasers, azimuths[block] + part * usual_step_, usual_step_ / block_ns};
      Firing firing;
      firing.offset_ns = std::llround(block_ns * (static_cast<double>(block) + part));
      firing.duration_ns = std::llround(kSequenceNs);
      firing.azimuth_deg = 0.01 * std::fmod(sequence.azimuth, kUnitsPerTurn);
      firing.turned_deg = 0.01 * usual_step_ / static_cast<double>(per_block);
      add_sequence(&payload[kBlocksAt + block * kBlockBytes], sequence, firings);
      firing.end = firings.points.size();
      firings.firings.push_back(firing);
    }
  }
  return PacketKind::data;
}

void Rs16Decoder::add_sequence(const std::byte* block, const Sequence& sequence,
                               Firings& firings) const {
  struct Return {
    std::uint16_t distance = 0;
    std::uint8_t intensity = 0;
  };
  const auto return_at = [&](std::size_t channel) {
    const std::byte* at = block + kBlockHeaderBytes + channel * kReturnBytes;
    return Return{u16(at), std::to_integer<std::uint8_t>(at[2])};
  };
  for (std::size_t laser = 0; laser < kLasers; ++laser) {
    const double time_ns = kLaserNs * static_cast<double>(laser);
    const double azimuth = (sequence.azimuth + sequence.per_ns * time_ns) * kUnit;
    const double elevation = elevation_deg(laser) * std::numbers::pi / 180.0;
    const auto add = [&](const Return& measured) {
      if (measured.distance == 0) {
        return;
      }
      const double range = kDistanceUnit * measured.distance;
      const double horizontal = range * std::cos(elevation) + kLens;
      firings.points.push_back({{static_cast<float>(horizontal * std::cos(azimuth)),
                                 static_cast<float>(-horizontal * std::sin(azimuth)),
                                 static_cast<float>(range * std::sin(elevation))},
                                static_cast<float>(measured.intensity),
                                static_cast<std::int32_t>(time_ns),
                                static_cast<std::uint16_t>((elevation_deg(laser) + 15) / 2)});
    };
    const Return first = return_at(sequence.channel + laser);
    const Return second = dual_ ? return_at(kLasers + laser) : Return{};
    const bool other =
        choice_ == ReturnChoice::last
            ? second.distance > first.distance
            : second.distance != 0 && (first.distance == 0 || second.intensity > first.intensity);
    if (choice_ == ReturnChoice::both || !other) {
      add(first);
    }
    if (choice_ == ReturnChoice::both ? second.distance != first.distance : other) {
      add(second);
    }
  }
}

}  // namespace surefoot::sensors
