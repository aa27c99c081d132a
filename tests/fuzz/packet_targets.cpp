// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <bzlib.h>
#include <libdeflate.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "fuzz/whole_way.hpp"
#include "io/ascii_values.hpp"
#include "io/bags/compression.hpp"
#include "io/packets/capture_recording.hpp"
#include "io/packets/packet_scans.hpp"
#include "io/recording.hpp"
#include "sensors/sensor_list.hpp"
#include "sensors/velodyne/vlp16.hpp"
#include "unit/io/support.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::fuzz {
namespace {

std::string packet(unsigned mode, unsigned azimuth, std::uint32_t time) {
  return io::test::vlp16_payload(azimuth, 40, time, mode, [](auto block, auto channel) {
    return io::test::Measured{static_cast<std::uint16_t>(500 + channel),
                              static_cast<std::uint8_t>(block)};
  });
}

// Payloads of one size one after the other, 1.3 ms apart.
void read_packets(Bytes bytes, std::size_t size, const std::string& sensor = "",
                  const std::string& metadata = "") {
  io::OpenOptions options;
  options.dual_return = io::ReturnChoice::both;
  options.sensor = sensor;
  io::PacketScans scans(options, metadata);
  std::int64_t arrival_ns = 0;
  while (!bytes.empty()) {
    const Bytes payload = bytes.first(std::min(size, bytes.size()));
    scans.add(arrival_ns, payload);
    arrival_ns += 1'327'104;
    bytes = bytes.subspan(payload.size());
  }
  scans.finish();
  while (scans.take()) {
  }
}
void read_vlp16(Bytes bytes) { read_packets(bytes, vlp16::kPacketBytes); }
Seeds vlp16_seeds() {
  return {packet(0x37, 35700, 5) + packet(0x37, 180, 1332), packet(0x39, 35900, 5)};
}

// The other Velodynes, whose packets are as large.
Seeds velodyne_seeds() {
  const std::vector<unsigned> turning = {0, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200, 220};
  using sensors::test::velodyne_packet;
  std::string dual =
      velodyne_packet({0xeeff, 0xeeff, 0xddff, 0xddff, 0xccff, 0xccff, 0xbbff, 0xbbff},
                      std::vector<unsigned>(12, 35'999), 7, 0x39, 0xa1);
  sensors::test::set_velodyne(dual, 3, 5, 1000, 200);
  std::string two_banks = velodyne_packet({0xeeff, 0xddff}, turning, 5, 'V', 1);
  sensors::test::set_velodyne(two_banks, 3, 5, 1000, 200);
  return {dual + dual, two_banks + two_banks,
          velodyne_packet({0xeeff}, turning, 5, 0x37, 0x28) +
              velodyne_packet({0xeeff}, turning, 560, 0x37, 0x28)};
}

// The first byte chooses the model.
void read_hesai(Bytes bytes) {
  const auto& layouts = sensors::test::hesai_layouts();
  if (!bytes.empty()) {
    const auto choice = std::to_integer<std::size_t>(bytes.front()) % layouts.size();
    read_packets(bytes.subspan(1), layouts[choice].size);
  }
}
Seeds hesai_seeds() {
  Seeds seeds;
  for (const sensors::test::HesaiLayout& layout : sensors::test::hesai_layouts()) {
    std::string packets(1, static_cast<char>(seeds.size()));
    for (const std::uint32_t i : {0U, 1U}) {
      std::string one = sensors::test::hesai_packet(layout, 35'900, 20, 2, 0x39, 400 * i, i);
      sensors::test::set_hesai(one, layout, i, 3, 500, 7);
      packets += one;
    }
    seeds.push_back(packets);
  }
  return seeds;
}

struct OusterFormat {
  const char* profile;
  std::size_t pixel_bytes;
  bool legacy;
};
constexpr OusterFormat kOusterFormats[] = {{"LEGACY", 12, true},
                                           {"RNG19_RFL8_SIG16_NIR16", 12, false},
                                           {"RNG19_RFL8_SIG16_NIR16_DUAL", 16, false},
                                           {"RNG15_RFL8_NIR8", 4, false},
                                           {"RNG15_RFL8_NIR8_DUAL", 8, false}};

// The first byte chooses the profile.
void read_ouster(Bytes bytes) {
  if (!bytes.empty()) {
    const OusterFormat& format =
        kOusterFormats[std::to_integer<std::size_t>(bytes.front()) % std::size(kOusterFormats)];
    const std::string packet =
        sensors::test::ouster_packet(format.pixel_bytes, format.legacy, 0, 0, 0);
    read_packets(bytes.subspan(1), packet.size(), "", sensors::test::ouster_json(format.profile));
  }
}
Seeds ouster_seeds() {
  Seeds seeds;
  for (const OusterFormat& format : kOusterFormats) {
    std::string packets(1, static_cast<char>(seeds.size()));
    for (const int i : {0, 1}) {
      std::string one = sensors::test::ouster_packet(format.pixel_bytes, format.legacy, 65'535,
                                                     static_cast<std::uint16_t>(16 * i),
                                                     1'000'000 + 25'000'000ULL * i);
      sensors::test::put(one, sensors::test::ouster_pixel(format.pixel_bytes, format.legacy, 3, 5),
                         std::uint16_t{3000});
      packets += one;
    }
    seeds.push_back(packets);
  }
  return seeds;
}

void read_livox(Bytes bytes) { read_packets(bytes, 36 + 96 * 14); }
Seeds livox_seeds() {
  return {sensors::test::livox_packet(1'000, 1, 14) + sensors::test::livox_packet(481'000, 1, 14),
          sensors::test::livox_packet(1'000, 2, 8), sensors::test::livox_packet(1'000, 3, 10)};
}

void read_rs16(Bytes bytes) { read_packets(bytes, 1248); }
Seeds rs16_seeds() {
  return {sensors::test::rs16_packet(35'900, 40, 5'000) +
          sensors::test::rs16_packet(380, 40, 6'332)};
}

// A calibration or metadata file, tried on a packet of each maker that reads one.
void read_calibration(Bytes bytes) {
  static const std::string packets[] = {
      sensors::test::velodyne_packet({0xeeff}, std::vector<unsigned>(12, 0), 5, 0x37, 0x28),
      sensors::test::hesai_packet(sensors::test::hesai_layouts().front(), 0, 18, 1, 0x37, 0, 0),
      sensors::test::ouster_packet(12, true, 0, 0, 0)};
  sensors::DecoderOptions options;
  options.calibration = std::string(io::text_of(bytes));
  for (const std::string& packet : packets) {
    try {
      std::string reason;
      (void)sensors::find_decoder(io::test::bytes_of(packet), "", options, reason);
    } catch (const sensors::CalibrationError&) {
    }
  }
}
Seeds calibration_seeds() {
  std::string yaml = "lasers:\n";
  std::string csv = "Laser id,Elevation,Azimuth\n";
  for (int id = 0; id < 32; ++id) {
    yaml +=
        "- {laser_id: " + std::to_string(id) + ", rot_correction: 0.1, vert_correction: -0.2}\n";
  }
  for (int id = 1; id <= 16; ++id) {
    csv += std::to_string(id) + "," + std::to_string(16 - 2 * id) + ",0.1\n";
  }
  return {yaml, csv, sensors::test::ouster_json("LEGACY"),
          sensors::test::ouster_json("RNG15_RFL8_NIR8", true)};
}

void read_stream(std::FILE* file) {
  try {
    const auto recording = io::open_capture(file, "capture", {});
    while (recording->next()) {
    }
  } catch (const io::ReadError&) {
  }
}
void read_capture(Bytes bytes) {
  if (bytes.empty()) {
    return;
  }
  std::string content(io::text_of(bytes));
  if (std::FILE* file = fmemopen(content.data(), content.size(), "rb")) {
    read_stream(file);
  }
}
Seeds capture_seeds() {
  Seeds seeds;
  for (const std::uint32_t link_type : {1U, 101U}) {
    io::test::PcapFile file(link_type);
    for (unsigned i = 0; i < 2; ++i) {
      const std::string ip = io::test::ip_packet(packet(0x37, 35700 + 480 * i, 1327 * i), 2368, i);
      file.add(1'000'000'000 + i * 1'327'000,
               link_type == 1 ? io::test::ethernet_frame(ip, i) : ip);
    }
    seeds.push_back(file.content());
  }
  for (const bool big_endian : {false, true}) {
    io::test::PcapngFile file(1, big_endian ? 9 : 6, big_endian);
    for (unsigned i = 0; i < 2; ++i) {
      const std::string ip = io::test::ip_packet(packet(0x37, 35700 + 480 * i, 1327 * i), 2368, i);
      file.add(1'000'000'000 + i * 1'327'000, io::test::ethernet_frame(ip, i));
    }
    seeds.push_back(file.content());
  }
  return seeds;
}

// A file that is compressed as a whole, whatever is in it: as it is, or (by the first byte) the
// bytes inside, which mutations of compressed ones would hardly reach.
void read_compressed(Bytes bytes) {
  if (bytes.empty()) return;
  constexpr io::Compression kInside[] = {io::Compression::none, io::Compression::zstd,
                                         io::Compression::lz4};
  const io::Compression inside = kInside[std::to_integer<std::size_t>(bytes.front()) % 3];
  const std::string content = io::compress(inside, io::text_of(bytes.subspan(1)));
  static const MemoryFile file;
  try {
    const auto recording = io::open_recording(file.holding(io::test::bytes_of(content)));
    while (recording->next()) {
    }
  } catch (const io::ReadError&) {
  }
}

std::string bzip2(std::string bytes) {
  auto size = static_cast<unsigned>(bytes.size() + bytes.size() / 100 + 600);  // as its manual says
  std::string packed(size, '\0');
  BZ2_bzBuffToBuffCompress(packed.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()),
                           1, 0, 0);
  return packed.substr(0, size);
}
std::string gzip(const std::string& bytes) {
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(1);
  std::string packed(libdeflate_gzip_compress_bound(compressor, bytes.size()), '\0');
  packed.resize(libdeflate_gzip_compress(compressor, bytes.data(), bytes.size(), packed.data(),
                                         packed.size()));
  libdeflate_free_compressor(compressor);
  return packed;
}
Seeds compressed_seeds() {
  std::vector<std::string> files = capture_seeds();
  for (const Target& target : bag_targets()) {
    const std::string_view name = target.name;
    if (name != "mcap" && name != "ros1_bag" && name != "sqlite_bag") continue;
    for (std::string& bag : target.seeds()) files.push_back(std::move(bag));
  }
  Seeds seeds;
  for (const std::string& file : files) {
    switch (seeds.size() % 4) {
      case 0:
        seeds.push_back('\1' + file);  // Zstandard
        break;
      case 1:
        seeds.push_back('\2' + file);  // LZ4
        break;
      case 2:
        seeds.push_back('\0' + bzip2(file));
        break;
      default:
        seeds.push_back('\0' + gzip(file));
    }
  }
  return seeds;
}

constexpr Target kPacketTargets[] = {{"vlp16", read_vlp16, vlp16_seeds},
                                     {"velodyne", read_vlp16, velodyne_seeds},
                                     {"hesai", read_hesai, hesai_seeds},
                                     {"ouster", read_ouster, ouster_seeds},
                                     {"livox", read_livox, livox_seeds},
                                     {"rs16", read_rs16, rs16_seeds},
                                     {"calibration", read_calibration, calibration_seeds},
                                     {"capture", read_capture, capture_seeds},
                                     {"compressed", read_compressed, compressed_seeds}};

}  // namespace

std::span<const Target> packet_targets() { return kPacketTargets; }

}  // namespace surefoot::fuzz
