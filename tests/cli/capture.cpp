// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "capture.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "io/file_writer.hpp"
#include "sensors/velodyne/vlp16.hpp"
#include "support/scene.hpp"

namespace surefoot::test {

namespace {

using io::append_bytes;

constexpr double kSequencesPerTurn = 0.1e9 / vlp16::kSequenceNs;
constexpr double kPacketNs = 2.0 * vlp16::kBlocks * vlp16::kSequenceNs;
constexpr std::uint64_t kFirstStampUs = 1'700'000'000'000'000;

double azimuth_deg(std::size_t sequence) {
  return std::fmod(360.0 / kSequencesPerTurn * static_cast<double>(sequence), 360.0);
}

// The sensor's azimuth counts clockwise from its y axis; the library's x axis lies there.
std::uint16_t measured_distance(const Scene& scene, double azimuth, double elevation) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double flat = std::cos(elevation * kDegree);
  const Eigen::Vector3d direction(flat * std::cos(azimuth * kDegree),
                                  -flat * std::sin(azimuth * kDegree),
                                  std::sin(elevation * kDegree));
  const double distance = scene.cast({-2.0, 0.5, 0.5}, direction);
  return static_cast<std::uint16_t>(std::lround(distance / vlp16::kDistanceUnit));
}

std::string packet_at(const Scene& scene, std::size_t index) {
  std::string packet;
  for (std::size_t block = 0; block < vlp16::kBlocks; ++block) {
    const std::size_t first = 2 * (index * vlp16::kBlocks + block);
    packet += "\xff\xee";
    append_bytes(packet, static_cast<std::uint16_t>(100.0 * azimuth_deg(first)));
    for (std::size_t channel = 0; channel < vlp16::kChannelsPerBlock; ++channel) {
      const double azimuth = azimuth_deg(first + channel / vlp16::kLasers);
      const double elevation = vlp16::kElevationDeg[channel % vlp16::kLasers];
      append_bytes(packet, measured_distance(scene, azimuth, elevation));
      append_bytes(packet, std::uint8_t{50});
    }
  }
  append_bytes(packet, static_cast<std::uint32_t>(1e-3 * kPacketNs * static_cast<double>(index)));
  append_bytes(packet, vlp16::kStrongest);
  append_bytes(packet, vlp16::kProductVlp16);
  return packet;
}

void append_network_u16(std::string& out, std::size_t value) {
  out += static_cast<char>(value >> 8);
  out += static_cast<char>(value & 0xff);
}

std::string ethernet_frame(const std::string& payload) {
  constexpr std::size_t kUdpHeader = 8;
  constexpr std::size_t kIpHeader = 20;
  std::string frame(12, '\x02');  // addresses
  append_network_u16(frame, 0x0800);
  frame += "\x45";  // IPv4, 20 bytes of header
  frame += '\0';
  append_network_u16(frame, kIpHeader + kUdpHeader + payload.size());
  frame += std::string(4, '\0');   // identification, no fragments
  frame += "\x40\x11";             // time to live, UDP
  frame += std::string(10, '\0');  // checksum, addresses
  append_network_u16(frame, vlp16::kUdpPort);
  append_network_u16(frame, vlp16::kUdpPort);
  append_network_u16(frame, kUdpHeader + payload.size());
  append_network_u16(frame, 0);  // no checksum
  return frame + payload;
}

std::uint64_t stamp_us(std::size_t packet) {
  return kFirstStampUs + static_cast<std::uint64_t>(1e-3 * kPacketNs * static_cast<double>(packet));
}

void append_block(std::string& file, std::uint32_t type, const std::string& body) {
  const auto length = static_cast<std::uint32_t>((body.size() + 3) / 4 * 4 + 12);
  append_bytes(file, type);
  append_bytes(file, length);
  file += body + std::string(length - 12 - body.size(), '\0');
  append_bytes(file, length);
}

}  // namespace

std::vector<std::string> vlp16_packets(int revolutions) {
  const Scene scene = furnished_hall();
  const auto count =
      static_cast<std::size_t>(std::ceil(revolutions * kSequencesPerTurn / (2.0 * vlp16::kBlocks)));
  std::vector<std::string> packets;
  for (std::size_t index = 0; index < count; ++index) packets.push_back(packet_at(scene, index));
  return packets;
}

std::string pcap_file(const std::vector<std::string>& packets) {
  std::string file;
  append_bytes(file, std::uint32_t{0xa1b2c3d4});  // microseconds
  append_bytes(file, std::uint16_t{2});
  append_bytes(file, std::uint16_t{4});
  append_bytes(file, std::uint64_t{0});       // time zone, accuracy
  append_bytes(file, std::uint32_t{65'535});  // longest frame
  append_bytes(file, std::uint32_t{1});       // Ethernet
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const std::string frame = ethernet_frame(packets[i]);
    append_bytes(file, static_cast<std::uint32_t>(stamp_us(i) / 1'000'000));
    append_bytes(file, static_cast<std::uint32_t>(stamp_us(i) % 1'000'000));
    append_bytes(file, static_cast<std::uint32_t>(frame.size()));
    append_bytes(file, static_cast<std::uint32_t>(frame.size()));
    file += frame;
  }
  return file;
}

std::string pcapng_file(const std::vector<std::string>& packets) {
  std::string section, interface;
  append_bytes(section, std::uint32_t{0x1a2b3c4d});  // byte order
  append_bytes(section, std::uint32_t{1});           // version 1.0
  append_bytes(section, ~std::uint64_t{0});          // length not told
  append_bytes(interface, std::uint32_t{1});         // Ethernet
  append_bytes(interface, std::uint32_t{65'535});
  std::string file;
  append_block(file, 0x0a0d0d0a, section);
  append_block(file, 1, interface);
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const std::string frame = ethernet_frame(packets[i]);
    std::string body;
    append_bytes(body, std::uint32_t{0});  // interface
    append_bytes(body, static_cast<std::uint32_t>(stamp_us(i) >> 32));
    append_bytes(body, static_cast<std::uint32_t>(stamp_us(i)));
    append_bytes(body, static_cast<std::uint32_t>(frame.size()));
    append_bytes(body, static_cast<std::uint32_t>(frame.size()));
    append_block(file, 6, body + frame);
  }
  return file;
}

}  // namespace surefoot::test
