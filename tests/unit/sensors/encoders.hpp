// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Packets made byte by byte from the sensors' documentation, by code that knows nothing of the
// decoders. What is not set is zero: a beam without return.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "unit/io/support.hpp"

namespace surefoot::sensors::test {

using io::test::big;
using io::test::bytes_of;
using io::test::little;

inline void put_bytes(std::string& bytes, std::size_t at, std::string_view value) {
  std::copy(value.begin(), value.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}
template <typename T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// A Velodyne data packet; `flags` and `azimuths` [0.01 deg] by block.
inline std::string velodyne_packet(const std::vector<std::uint16_t>& flags,
                                   const std::vector<unsigned>& azimuths, std::uint32_t time_us,
                                   unsigned mode, unsigned product) {
  std::string packet(1206, '\0');
  for (std::size_t block = 0; block < 12; ++block) {
    put(packet, 100 * block, flags[block % flags.size()]);
    put(packet, 100 * block + 2, static_cast<std::uint16_t>(azimuths[block] % 36000));
  }
  put(packet, 1200, time_us);
  packet[1204] = static_cast<char>(mode);
  packet[1205] = static_cast<char>(product);
  return packet;
}
inline void set_velodyne(std::string& packet, std::size_t block, std::size_t channel,
                         std::uint16_t distance, std::uint8_t intensity) {
  put(packet, 100 * block + 4 + 3 * channel, distance);
  packet[100 * block + 4 + 3 * channel + 2] = static_cast<char>(intensity);
}

/// Sizes of a Hesai packet and where its tail's fields lie, as their manuals draw them.
struct HesaiLayout {
  const char* name;
  std::size_t size, header, blocks, channels, block_header, unit;
  std::size_t mode, date, micros, sequence;  ///< from the packet's beginning; 0: no sequence
  int year_zero;
};
inline const std::vector<HesaiLayout>& hesai_layouts() {
  static const std::vector<HesaiLayout> layouts = {
      {"PandarXT-16", 568, 12, 8, 16, 2, 4, 550, 553, 559, 564, 1900},
      {"PandarXT-32", 1080, 12, 8, 32, 2, 4, 1062, 1065, 1071, 1076, 1900},
      {"PandarXT-32M", 820, 12, 6, 32, 2, 4, 802, 805, 811, 816, 1900},
      {"PandarQT64", 1072, 12, 4, 64, 2, 4, 1060, 1062, 1056, 1068, 1900},
      {"PandarQT128", 1127, 12, 2, 128, 2, 4, 1073, 1076, 1082, 1087, 1900},
      {"Pandar40P", 1262, 0, 10, 40, 4, 3, 1254, 1256, 1250, 0, 2000},
      {"Pandar64", 1198, 8, 6, 64, 2, 3, 1186, 1188, 1182, 1194, 2000}};
  return layouts;
}
/// The time is 2023-01-11 02:15:49 (1673403349 s) and `micros`.
inline std::string hesai_packet(const HesaiLayout& layout, unsigned azimuth, unsigned step,
                                std::size_t returns, unsigned mode, std::uint32_t micros,
                                std::uint32_t sequence) {
  std::string packet(layout.size, '\0');
  if (layout.header > 0) {
    packet[0] = '\xee';
    packet[1] = '\xff';
    const std::size_t counts = layout.header == 12 ? 6 : 2;
    packet[counts] = static_cast<char>(layout.channels);
    packet[counts + 1] = static_cast<char>(layout.blocks);
    packet[counts + 3] = 4;  // millimetres
  }
  for (std::size_t block = 0; block < layout.blocks; ++block) {
    const std::size_t at =
        layout.header + block * (layout.block_header + layout.unit * layout.channels);
    if (layout.block_header == 4) put_bytes(packet, at, "\xff\xee");
    const auto turned = static_cast<unsigned>(block / returns) * step;
    put(packet, at + layout.block_header - 2,
        static_cast<std::uint16_t>((azimuth + turned) % 36000));
  }
  packet[layout.mode] = static_cast<char>(mode);
  const int date[] = {2023 - layout.year_zero, 1, 11, 2, 15, 49};
  for (std::size_t i = 0; i < 6; ++i) packet[layout.date + i] = static_cast<char>(date[i]);
  put(packet, layout.micros, micros);
  if (layout.sequence > 0) put(packet, layout.sequence, sequence);
  return packet;
}
inline void set_hesai(std::string& packet, const HesaiLayout& layout, std::size_t block,
                      std::size_t channel, std::uint16_t distance, std::uint8_t intensity) {
  const std::size_t at = layout.header +
                         block * (layout.block_header + layout.unit * layout.channels) +
                         layout.block_header + layout.unit * channel;
  put(packet, at, distance);
  packet[at + 2] = static_cast<char>(intensity);
}

/// Metadata of an Ouster of 16 beams and 64 columns, in the new form or the old one.
inline std::string ouster_json(const std::string& profile, bool old_form = false) {
  std::string altitude;
  std::string azimuth;
  for (int i = 0; i < 16; ++i) {
    altitude += i > 0 ? ", " : "";
    altitude += std::to_string(15 - 2 * i);
    azimuth += i > 0 ? ", " : "";
    azimuth += std::to_string(i % 4 - 2);
  }
  const std::string beams = R"("beam_altitude_angles": [)" + altitude +
                            R"(], "beam_azimuth_angles": [)" + azimuth +
                            R"(], "lidar_origin_to_beam_origin_mm": 15.8)";
  const std::string lidar =
      R"("lidar_to_sensor_transform": [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36, 0, 0, 0, 1])";
  const std::string format = R"({"columns_per_frame": 64, "columns_per_packet": 16, )"
                             R"("pixels_per_column": 16, "column_window": [0, 63], )"
                             R"("udp_profile_lidar": ")" +
                             profile + R"("})";
  if (old_form) {
    return "{" + beams + ", " + lidar + R"(, "data_format": )" + format +
           R"(, "lidar_mode": "64x10", "prod_line": "OS-1-16"})";
  }
  return R"({"beam_intrinsics": {)" + beams + R"(}, "lidar_intrinsics": {)" + lidar +
         R"(}, "lidar_data_format": )" + format +
         R"(, "config_params": {"lidar_mode": "64x10"}, "sensor_info": {"prod_line": "OS-1-16"}})";
}
/// Sixteen columns from `column` on, the first at `time_ns`, the others 1,562,500 ns apart.
inline std::string ouster_packet(std::size_t pixel_bytes, bool legacy, std::uint16_t frame,
                                 std::uint16_t column, std::uint64_t time_ns) {
  std::string packet(legacy ? 0 : 32, '\0');
  if (!legacy) {
    put(packet, 0, std::uint16_t{1});
    put(packet, 2, frame);
  }
  for (unsigned i = 0; i < 16; ++i) {
    packet += little(time_ns + i * 1'562'500ULL) + little(static_cast<std::uint16_t>(column + i));
    packet += legacy ? little(frame) + little(0U) : little(std::uint16_t{1});
    packet += std::string(16 * pixel_bytes, '\0');
    if (legacy) packet += little(0xffffffffU);
  }
  return packet + std::string(legacy ? 0 : 32, '\0');
}
/// Where the pixel of a column lies.
inline std::size_t ouster_pixel(std::size_t pixel_bytes, bool legacy, std::size_t column,
                                std::size_t pixel) {
  const std::size_t header = legacy ? 16 : 12;
  const std::size_t column_bytes = header + 16 * pixel_bytes + (legacy ? 4 : 0);
  return (legacy ? 0 : 32) + column * column_bytes + header + pixel * pixel_bytes;
}

/// A Livox point packet of 96 points, 480 us long; `type` 1: millimetres.
inline std::string livox_packet(std::uint64_t time_ns, std::uint8_t type, std::size_t point_bytes) {
  std::string packet(36 + 96 * point_bytes, '\0');
  put(packet, 1, static_cast<std::uint16_t>(packet.size()));
  put(packet, 3, std::uint16_t{4800});
  put(packet, 5, std::uint16_t{96});
  packet[10] = static_cast<char>(type);
  put(packet, 28, time_ns);
  return packet;
}

/// A RoboSense RS-16 data packet at 2023-01-11 02:15:49 and `micros`.
inline std::string rs16_packet(unsigned azimuth, unsigned step, unsigned micros) {
  std::string packet("\x55\xaa\x05\x0a\x5a\xa5\x50\xa0", 8);
  packet += std::string(12, '\0') + std::string("\x17\x01\x0b\x02\x0f\x31", 6);
  packet += big(static_cast<std::uint16_t>(micros / 1000)) +
            big(static_cast<std::uint16_t>(micros % 1000)) + std::string(12, '\0');
  for (unsigned block = 0; block < 12; ++block) {
    packet += "\xff\xee" + big(static_cast<std::uint16_t>((azimuth + block * step) % 36000)) +
              std::string(96, '\0');
  }
  return packet + std::string(6, '\0');
}
inline void set_rs16(std::string& packet, std::size_t block, std::size_t channel,
                     std::uint16_t distance, std::uint8_t intensity) {
  const std::size_t at = 42 + 100 * block + 4 + 3 * channel;
  put_bytes(packet, at, big(distance));
  packet[at + 2] = static_cast<char>(intensity);
}

}  // namespace surefoot::sensors::test
