// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {

/// Of a packet that is like an RS-LiDAR-16's but says that it is another model's: that model's
/// name, else empty.
[[nodiscard]] std::string other_robosense_model(std::span<const std::byte> payload);

/// The RoboSense RS-LiDAR-16, at its nominal elevations of -15 to 15 deg. Frame as in its driver: x
/// forward where the azimuth is zero, azimuth clockwise seen from above.
class Rs16Decoder final : public PacketDecoder {
 public:
  explicit Rs16Decoder(const DecoderOptions& options) : choice_(options.returns) {}

  [[nodiscard]] PacketKind decode(std::span<const std::byte> payload, Firings& firings) override;
  [[nodiscard]] std::string sensor() const override { return "RS-LiDAR-16"; }
  [[nodiscard]] std::string return_mode() const override { return dual_ ? "dual" : "single"; }
  [[nodiscard]] SweepEnd sweep_end() const override { return SweepEnd::azimuth; }

 private:
  struct Sequence;
  using Azimuths = std::array<int, 12>;  // of the blocks [0.01 deg]
  [[nodiscard]] PacketKind read_head(std::span<const std::byte> payload, Azimuths& azimuths,
                                     Firings& firings);
  void learn_mode(std::int64_t since_ns);
  void add_sequence(const std::byte* block, const Sequence& sequence, Firings& firings) const;

  ReturnChoice choice_;
  bool dual_ = false;
  int far_apart_ = 0;          ///< packets in a row, as of single returns or with lost ones between
  double usual_step_ = 39.96;  ///< from block to block; at first of 600 rpm [0.01 deg]
  std::optional<std::int64_t> last_time_ns_;
};

}  // namespace surefoot::sensors
