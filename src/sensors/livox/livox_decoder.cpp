// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/livox/livox_decoder.hpp"

#include <cmath>
#include <numbers>

#include "sensors/bytes.hpp"

namespace surefoot::sensors {
namespace {

// Livox SDK2 communication protocol, "Point cloud and IMU data": a header, then points.
constexpr std::size_t kLength = 1;
constexpr std::size_t kInterval = 3;  // of the whole packet [0.1 us]
constexpr std::size_t kPoints = 5;
constexpr std::size_t kDataType = 10;
constexpr std::size_t kTime = 28;
constexpr std::size_t kHeaderBytes = 36;
constexpr std::size_t kLines = 4;

enum class DataType : std::uint8_t { millimetres = 1, centimetres = 2, spherical = 3 };

std::size_t point_bytes(std::uint8_t type) {
  switch (static_cast<DataType>(type)) {
    case DataType::millimetres:
      return 14;
    case DataType::centimetres:
      return 8;
    case DataType::spherical:
      return 10;
  }
  return 0;
}

template <typename T>
T number(const std::byte* at) {
  return load<T>(at, false);
}

Eigen::Vector3d position(const std::byte* at, DataType type) {
  switch (type) {
    case DataType::millimetres:
      return 1e-3 * Eigen::Vector3d(number<std::int32_t>(at), number<std::int32_t>(at + 4),
                                    number<std::int32_t>(at + 8));
    case DataType::centimetres:
      return 1e-2 * Eigen::Vector3d(number<std::int16_t>(at), number<std::int16_t>(at + 2),
                                    number<std::int16_t>(at + 4));
    case DataType::spherical: {
      constexpr double kUnit = 0.01 * std::numbers::pi / 180.0;
      const double range = 1e-3 * number<std::uint32_t>(at);
      const double zenith = kUnit * number<std::uint16_t>(at + 4);
      const double azimuth = kUnit * number<std::uint16_t>(at + 6);
      return range * Eigen::Vector3d(std::sin(zenith) * std::cos(azimuth),
                                     std::sin(zenith) * std::sin(azimuth), std::cos(zenith));
    }
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

PacketKind LivoxDecoder::decode(std::span<const std::byte> payload, Firings& firings) {
  firings.clear();
  if (payload.size() < kHeaderBytes || payload.front() != std::byte{0} ||
      number<std::uint16_t>(payload.data() + kLength) != payload.size()) {
    return PacketKind::other;
  }
  const auto type = std::to_integer<std::uint8_t>(payload[kDataType]);
  const std::size_t bytes = point_bytes(type);
  const std::size_t points = number<std::uint16_t>(payload.data() + kPoints);
  if (bytes == 0) {
    return PacketKind::other;  // IMU
  }
  const auto time = number<std::uint64_t>(payload.data() + kTime);
  if (points == 0 || kHeaderBytes + points * bytes != payload.size() || time >> 63U != 0) {
    return PacketKind::malformed;
  }
  const std::int64_t lasts_ns = 100LL * number<std::uint16_t>(payload.data() + kInterval);
  firings.time_ns = static_cast<std::int64_t>(time);
  firings.base = TimeBase::absolute;
  firings.period_ns = lasts_ns;
  for (std::size_t i = 0; i < points; ++i) {
    const std::byte* at = payload.data() + kHeaderBytes + i * bytes;
    const Eigen::Vector3d place = position(at, static_cast<DataType>(type));
    if (place.isZero(0.0)) {
      continue;  // no return
    }
    const auto count = static_cast<std::int64_t>(points);
    firings.points.push_back(
        {place.cast<float>(), static_cast<float>(std::to_integer<int>(at[bytes - 2])),
         static_cast<std::int32_t>(lasts_ns * static_cast<std::int64_t>(i) / count),
         static_cast<std::uint16_t>(i % kLines)});
  }
  Firing firing;
  firing.duration_ns = lasts_ns;
  firing.end = firings.points.size();
  firings.firings.push_back(firing);
  return PacketKind::data;
}

}  // namespace surefoot::sensors
