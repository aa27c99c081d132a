// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {

/// Point packets of the Livox Mid-360 and its kin (HAP), which have no turn: a sweep is a tenth of
/// a second. Points come in the sensor's own frame; rings are the Mid-360's four lines. A HAP has
/// six, but no packet says whose it is: a HAP's rings are wrong.
class LivoxDecoder final : public PacketDecoder {
 public:
  [[nodiscard]] PacketKind decode(std::span<const std::byte> payload, Firings& firings) override;
  [[nodiscard]] std::string sensor() const override { return "Livox Mid-360"; }
  [[nodiscard]] std::string return_mode() const override { return "single"; }
  [[nodiscard]] SweepEnd sweep_end() const override { return SweepEnd::time; }
};

}  // namespace surefoot::sensors
