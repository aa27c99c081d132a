// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/datagram_writer.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kIpHeader = 20;

void append_network_u16(std::string& out, std::size_t value) {
  out += static_cast<char>(value >> 8 & 0xff);
  out += static_cast<char>(value & 0xff);
}

void append_network_u32(std::string& out, std::uint32_t value) {
  append_network_u16(out, value >> 16);
  append_network_u16(out, value & 0xffff);
}

std::string file_header() {
  constexpr std::uint32_t kNanoseconds = 0xa1b23c4d;
  constexpr std::uint32_t kLongest = 65'535;
  constexpr std::uint32_t kRawIp = 101;
  std::string header;
  append_bytes(header, kNanoseconds);
  append_bytes(header, std::uint16_t{2});
  append_bytes(header, std::uint16_t{4});
  append_bytes(header, std::uint64_t{0});  // time zone and accuracy
  append_bytes(header, kLongest);
  append_bytes(header, kRawIp);
  return header;
}

/// Where it was sent to is not kept, but for the port; checksums are left to whoever asks for them.
std::string ip_packet(const UdpDatagram& datagram) {
  const std::size_t udp_length = kUdpHeader + datagram.payload.size();
  std::string packet;
  append_network_u16(packet, 0x4500);  // IPv4, a header of 20 bytes
  append_network_u16(packet, kIpHeader + udp_length);
  append_network_u32(packet, 0);           // identification, no fragments
  append_network_u32(packet, 0x40110000);  // time to live, UDP, no checksum
  append_network_u32(packet, datagram.source_address);
  append_network_u32(packet, 0);
  append_network_u16(packet, datagram.destination_port);
  append_network_u16(packet, datagram.destination_port);
  append_network_u16(packet, udp_length);
  append_network_u16(packet, 0);
  packet.append(reinterpret_cast<const char*>(datagram.payload.data()), datagram.payload.size());
  return packet;
}

}  // namespace

DatagramWriter::DatagramWriter(const std::filesystem::path& file)
    : path_(file), file_(file, std::ios::binary) {
  file_ << file_header();
  flush();
}

void DatagramWriter::add(std::int64_t arrival_ns, const UdpDatagram& datagram) {
  constexpr std::size_t kMost = 65'535 - kIpHeader - kUdpHeader;
  if (datagram.payload.size() > kMost) return;  // nor could it have arrived
  const std::string packet = ip_packet(datagram);
  std::string record;
  append_bytes(record, static_cast<std::uint32_t>(arrival_ns / 1'000'000'000));
  append_bytes(record, static_cast<std::uint32_t>(arrival_ns % 1'000'000'000));
  append_bytes(record, static_cast<std::uint32_t>(packet.size()));
  append_bytes(record, static_cast<std::uint32_t>(packet.size()));
  file_ << record << packet;
  if (!file_) fail();
}

void DatagramWriter::flush() {
  file_.flush();
  if (!file_) fail();
}

void DatagramWriter::fail() const {
  throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace surefoot::io
