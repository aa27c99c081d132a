// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sensors/ouster/ouster_metadata.hpp"
#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {

/// Frame as in Ouster's SDK, the sensor's: x forward, away from the connector, z up, the origin on
/// the base plate. Intensities are the signal, or the reflectivity in profiles without it.
class OusterDecoder final : public PacketDecoder {
 public:
  OusterDecoder(OusterMetadata metadata, const DecoderOptions& options);

  [[nodiscard]] PacketKind decode(std::span<const std::byte> payload, Firings& firings) override;
  [[nodiscard]] std::string sensor() const override { return metadata_.product; }
  [[nodiscard]] std::string return_mode() const override;
  [[nodiscard]] SweepEnd sweep_end() const override { return SweepEnd::frame; }
  [[nodiscard]] double sweep_deg() const override;

 private:
  struct Beam {
    double azimuth = 0.0;  ///< [rad]
    double cosine = 1.0, sine = 0.0;
    std::uint16_t ring = 0;
  };
  struct Column;  // one measurement of all beams
  [[nodiscard]] std::optional<Column> read_column(const std::byte* column) const;
  void add_column(const std::byte* pixels, double encoder, Firings& firings) const;
  void add_point(const Beam& beam, double range, float intensity, double encoder,
                 Firings& firings) const;

  OusterMetadata metadata_;
  ReturnChoice choice_;
  std::vector<Beam> beams_;
};

}  // namespace surefoot::sensors
