// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sensors/packet_decoder.hpp"
#include "sensors/velodyne/velodyne_model.hpp"

namespace surefoot::sensors {

/// Frame as in the ROS driver: x forward where the azimuth is zero, azimuth clockwise seen from
/// above: x = d cos(el) cos(az), y = -d cos(el) sin(az), z = d sin(el) (+ the laser's own height).
class VelodyneDecoder final : public PacketDecoder {
 public:
  /// Throws CalibrationError where the options bring a calibration that does not fit the model.
  VelodyneDecoder(VelodyneModel model, const DecoderOptions& options);

  [[nodiscard]] PacketKind decode(std::span<const std::byte> payload, Firings& firings) override;
  [[nodiscard]] std::string sensor() const override { return model_.name; }
  [[nodiscard]] std::string return_mode() const override;
  [[nodiscard]] SweepEnd sweep_end() const override { return SweepEnd::azimuth; }

 private:
  struct Head;  // where the head was at a sequence, and where its returns lie in the packet
  struct Laser {
    VelodyneLaser table;
    double cosine = 1.0, sine = 0.0;  ///< of the elevation
    std::uint16_t ring = 0;
  };
  struct Return {
    std::uint16_t distance = 0;
    std::uint8_t reflectivity = 0;
  };
  struct Shot;    // a laser as it fired
  struct Layout;  // how a packet's blocks follow each other
  [[nodiscard]] Layout layout_of(bool dual) const;
  void learn_step(std::span<const std::byte> payload, const Layout& layout, std::size_t position);
  void learn_pace(double sequence_ns);
  [[nodiscard]] bool is_dual(std::span<const std::byte> payload) const;
  void add_sequence(std::span<const std::byte> payload, const Head& head, Firings& firings) const;
  void add_point(const Shot& shot, Return measured, Firings& firings) const;

  VelodyneModel model_;
  ReturnChoice choice_;
  std::vector<Laser> lasers_;
  double usual_step_;      ///< a sequence; of the last good one, at first of 600 rpm [0.01 deg]
  int last_azimuth_ = -1;  ///< of the last position of the packet before [0.01 deg]; -1: not known
  std::int64_t last_time_ns_ = 0;
  double pace_ = 1.0;  ///< firings take so many times as long as the model's
  std::uint8_t mode_ = 0;
};

/// The model of a data packet of Velodyne's, by its factory bytes or its blocks' flags; nothing
/// where it is none. `reason` says what is wrong with one that is of Velodyne's but not known.
/// VLP-16s of 2014 call themselves HDL-32E: what they measured tells.
[[nodiscard]] std::optional<VelodyneModel> find_velodyne_model(std::span<const std::byte> payload,
                                                               std::string& reason);

}  // namespace surefoot::sensors
