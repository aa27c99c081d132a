// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The one place that knows all sensors.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {

/// "VLP-16", "VLP-32C", ...: what `sensor` may name below, in any case, with or without hyphens.
[[nodiscard]] std::vector<std::string> sensor_names();

/// Whether a name is one of them. "" is not.
[[nodiscard]] bool is_sensor_name(const std::string& name);

/// The sensor that a packet names itself, by its factory bytes; "" where it names none.
[[nodiscard]] std::string named_sensor(std::span<const std::byte> payload);

/// The decoder for the sensor that sent a packet; nothing where it is no data packet that is known,
/// with `reason` set where it is nearly one.
/// @param sensor one of sensor_names(), instead of what the packet itself says; "": found out.
/// Throws CalibrationError where the calibration does not fit the sensor.
[[nodiscard]] std::unique_ptr<PacketDecoder> find_decoder(std::span<const std::byte> payload,
                                                          const std::string& sensor,
                                                          const DecoderOptions& options,
                                                          std::string& reason);

}  // namespace surefoot::sensors
