// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/ouster/ouster_decoder.hpp"

#include <cmath>
#include <numbers>

#include "sensors/bytes.hpp"
#include "sensors/rings.hpp"

namespace surefoot::sensors {
namespace {

constexpr double kMillimetre = 1e-3;
// Columns of a packet are measured within milliseconds; one that is not has no time.
constexpr std::int64_t kFarthestNs = 200'000'000;

std::uint32_t field(const std::byte* pixel, const OusterField& where) {
  std::uint32_t value = 0;
  for (unsigned byte = 0; byte < (where.at % 8 + where.bits + 7) / 8; ++byte) {
    value |= std::to_integer<std::uint32_t>(pixel[where.at / 8 + byte]) << (8 * byte);
  }
  return (value >> (where.at % 8) & ((1U << where.bits) - 1U)) << where.shift;
}

}  // namespace

struct OusterDecoder::Column {
  std::size_t id = 0;        ///< of a turn's columns
  std::int64_t time_ns = 0;  ///< when it was measured
};

OusterDecoder::OusterDecoder(OusterMetadata metadata, const DecoderOptions& options)
    : metadata_(std::move(metadata)), choice_(options.returns) {
  const std::vector<std::uint16_t> rings = rings_of(metadata_.elevation_deg);
  for (std::size_t i = 0; i < metadata_.pixels; ++i) {
    const double elevation = metadata_.elevation_deg[i] * std::numbers::pi / 180.0;
    beams_.push_back({metadata_.azimuth_deg[i] * std::numbers::pi / 180.0, std::cos(elevation),
                      std::sin(elevation), rings[i]});
  }
}

std::string OusterDecoder::return_mode() const {
  return std::string(metadata_.profile.is_dual() ? "dual" : "single") + ", profile " +
         metadata_.profile.name;
}

double OusterDecoder::sweep_deg() const {
  return 360.0 * static_cast<double>(metadata_.window_columns()) /
         static_cast<double>(metadata_.columns_per_frame);
}

/// What a column's header says; nothing where it was not measured.
std::optional<OusterDecoder::Column> OusterDecoder::read_column(const std::byte* column) const {
  const bool legacy = metadata_.profile.is_legacy();
  const auto status = legacy ? load<std::uint32_t>(column + metadata_.column_bytes() - 4, false)
                             : std::uint32_t{load<std::uint16_t>(column + 10, false)} & 1U;
  const std::size_t id = load<std::uint16_t>(column + 8, false);
  const auto time = load<std::uint64_t>(column, false);
  // No clock is past 2116, and sums of such times still fit.
  if (status == 0 || (legacy && status != 0xffffffffU) || id >= metadata_.columns_per_frame ||
      time >> 62U != 0) {
    return std::nullopt;
  }
  return Column{id, static_cast<std::int64_t>(time)};
}

PacketKind OusterDecoder::decode(std::span<const std::byte> payload, Firings& firings) {
  firings.clear();
  if (payload.size() != metadata_.packet_bytes()) return PacketKind::other;
  const bool legacy = metadata_.profile.is_legacy();
  constexpr std::uint16_t kLidarPacket = 1;
  if (!legacy && load<std::uint16_t>(payload.data(), false) != kLidarPacket) {
    return PacketKind::other;
  }
  const std::size_t columns = metadata_.columns_per_frame;
  const double column_ns = 1e9 / metadata_.rate_hz / static_cast<double>(columns);
  std::optional<Column> first;
  std::uint64_t frame = 0;
  for (std::size_t i = 0; i < metadata_.columns_per_packet; ++i) {
    const std::byte* at = payload.data() + metadata_.header_bytes() + i * metadata_.column_bytes();
    const std::optional<Column> column = read_column(at);
    if (!column) continue;
    if (!first) {
      first = column;
      firings.time_ns = column->time_ns;
      frame = load<std::uint16_t>(legacy ? at + 10 : payload.data() + 2, false);
    }
    const std::int64_t since_ns = column->time_ns - firings.time_ns;
    if (since_ns < 0 || since_ns > kFarthestNs) continue;
    Firing firing;
    firing.offset_ns = since_ns;
    firing.duration_ns = std::llround(column_ns);
    firing.azimuth_deg = 360.0 * static_cast<double>(column->id) / static_cast<double>(columns);
    firing.turned_deg = 360.0 / static_cast<double>(columns);
    firing.frame = static_cast<std::uint32_t>(frame);
    // The encoder counts against the mathematical sense.
    add_column(at + metadata_.column_header_bytes(), -firing.azimuth_deg * std::numbers::pi / 180.0,
               firings);
    firing.end = firings.points.size();
    firings.firings.push_back(firing);
  }
  if (!first) return PacketKind::other;  // one that measures a window sends empty packets beside it
  if (metadata_.window_columns() == columns) {
    const std::size_t packets = columns / metadata_.columns_per_packet;
    firings.number = frame * packets + first->id / metadata_.columns_per_packet;
    firings.numbers = 65'536 * packets;
  }
  firings.base = TimeBase::absolute;
  return PacketKind::data;
}

void OusterDecoder::add_column(const std::byte* pixels, double encoder, Firings& firings) const {
  const OusterProfile& profile = metadata_.profile;
  const OusterField& strength = profile.signal.bits > 0 ? profile.signal : profile.reflectivity;
  const OusterField& strength_2 =
      profile.signal_2.bits > 0 ? profile.signal_2 : profile.reflectivity_2;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const std::byte* pixel = pixels + i * profile.pixel_bytes;
    const std::uint32_t range = field(pixel, profile.range);
    const auto intensity = static_cast<float>(field(pixel, strength));
    if (!profile.is_dual()) {
      add_point(beams_[i], kMillimetre * range, intensity, encoder, firings);
      continue;
    }
    const std::uint32_t range_2 = field(pixel, profile.range_2);
    const auto intensity_2 = static_cast<float>(field(pixel, strength_2));
    const bool second = choice_ == ReturnChoice::last
                            ? range_2 > range
                            : range_2 != 0 && (range == 0 || intensity_2 > intensity);
    if (choice_ == ReturnChoice::both || !second) {
      add_point(beams_[i], kMillimetre * range, intensity, encoder, firings);
    }
    if (choice_ == ReturnChoice::both ? range_2 != range : second) {
      add_point(beams_[i], kMillimetre * range_2, intensity_2, encoder, firings);
    }
  }
}

// The range is measured from the lidar's centre along the path of the light, which leaves the
// mirror at the beam's origin ("Lidar range to XYZ" in Ouster's sensor documentation).
void OusterDecoder::add_point(const Beam& beam, double range, float intensity, double encoder,
                              Firings& firings) const {
  if (range == 0.0) {
    return;
  }
  const Eigen::Matrix4d& origin = metadata_.T_lidar_beam;
  const double to_origin = std::hypot(origin(0, 3), origin(2, 3));
  const double along = range - (origin(2, 3) == 0.0 ? origin(0, 3) : to_origin);
  const double angle = encoder - beam.azimuth;
  const Eigen::Vector3d lidar(
      along * std::cos(angle) * beam.cosine + origin(0, 3) * std::cos(encoder),
      along * std::sin(angle) * beam.cosine + origin(0, 3) * std::sin(encoder),
      along * beam.sine + origin(2, 3));
  const Eigen::Matrix4d& to_sensor = metadata_.T_sensor_lidar;
  const Eigen::Vector3d sensor =
      to_sensor.topLeftCorner<3, 3>() * lidar + to_sensor.topRightCorner<3, 1>();
  firings.points.push_back({sensor.cast<float>(), intensity, 0, beam.ring});
}

}  // namespace surefoot::sensors
