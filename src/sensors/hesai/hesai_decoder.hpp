// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sensors/hesai/hesai_model.hpp"
#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {

/// Frame as in Hesai's driver: y forward where the azimuth is zero, azimuth clockwise seen from
/// above: x = d cos(el) sin(az), y = d cos(el) cos(az), z = d sin(el). While a block's channels
/// fire the head turns on, by which their azimuths are corrected, as Hesai's own driver does.
class HesaiDecoder final : public PacketDecoder {
 public:
  /// Throws CalibrationError where the options bring a calibration that does not fit the model.
  HesaiDecoder(HesaiModel model, const DecoderOptions& options);

  [[nodiscard]] PacketKind decode(std::span<const std::byte> payload, Firings& firings) override;
  [[nodiscard]] std::string sensor() const override { return model_.name; }
  [[nodiscard]] std::string return_mode() const override;
  [[nodiscard]] SweepEnd sweep_end() const override { return SweepEnd::azimuth; }

 private:
  struct Group;  // blocks of one azimuth, one for each return
  struct Channel {
    HesaiChannel table;
    double cosine = 1.0, sine = 0.0;  ///< of the elevation
    std::uint16_t ring = 0;
  };
  [[nodiscard]] std::size_t read_tail(std::span<const std::byte> payload, Firings& firings);
  void learn_step(std::span<const std::byte> payload, std::size_t at, std::size_t groups,
                  std::size_t returns);
  [[nodiscard]] double distance_unit(std::span<const std::byte> payload) const;
  void add_group(std::span<const std::byte> payload, const Group& group, Firings& firings) const;

  HesaiModel model_;
  ReturnChoice choice_;
  std::vector<Channel> channels_;
  double usual_step_;      ///< from block to block of another azimuth [0.01 deg]
  int last_azimuth_ = -1;  ///< of the last block of the packet before [0.01 deg]; -1: not known
  std::int64_t last_time_ns_ = 0;
  std::uint8_t mode_ = 0;
};

/// The model of a data packet of Hesai's, by its size and header; nothing where it is none.
[[nodiscard]] const HesaiModel* find_hesai_model(std::span<const std::byte> payload);

}  // namespace surefoot::sensors
