// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/capture_writer.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace surefoot::simulation {

namespace {

/// Numbers appended byte by byte: little-endian for pcap, big-endian on the wire.
class Bytes {
 public:
  template <typename Value>
  void little(Value value) {
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
      text_.push_back(static_cast<char>((value >> (8 * i)) & 0xffU));
    }
  }
  template <typename Value>
  void big(Value value) {
    for (std::size_t i = sizeof(Value); i-- > 0;) {
      text_.push_back(static_cast<char>((value >> (8 * i)) & 0xffU));
    }
  }
  void raw(std::span<const std::byte> bytes) {
    text_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

constexpr std::uint32_t kSnapLength = 65'535;
constexpr std::uint32_t kLinkEthernet = 1;
constexpr std::size_t kIpHeader = 20;
constexpr std::size_t kUdpHeader = 8;

/// Ones' complement sum of the header's 16-bit words (RFC 791).
std::uint16_t ip_checksum(const std::array<std::uint16_t, kIpHeader / 2>& words) {
  std::uint32_t sum = 0;
  for (const std::uint16_t word : words) sum += word;
  while (sum > 0xffffU) sum = (sum & 0xffffU) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum);
}

void append_ethernet(Bytes& out) {
  constexpr std::array<std::uint16_t, 3> kBroadcast = {0xffff, 0xffff, 0xffff};
  constexpr std::array<std::uint16_t, 3> kSensor = {0x6076, 0x8800, 0x0000};  // maker's prefix
  for (const std::uint16_t word : kBroadcast) out.big(word);
  for (const std::uint16_t word : kSensor) out.big(word);
  out.big(std::uint16_t{0x0800});  // IPv4
}

void append_ipv4(Bytes& out, std::size_t payload_bytes) {
  const auto length = static_cast<std::uint16_t>(kIpHeader + kUdpHeader + payload_bytes);
  // Version and header length, total length, id, no fragments, TTL 255 and UDP, checksum,
  // 192.168.1.201 to 255.255.255.255.
  std::array<std::uint16_t, kIpHeader / 2> words = {0x4500, length, 0,      0x4000, 0xff11,
                                                    0,      0xc0a8, 0x01c9, 0xffff, 0xffff};
  words[5] = ip_checksum(words);
  for (const std::uint16_t word : words) out.big(word);
}

}  // namespace

CaptureWriter::CaptureWriter(const std::filesystem::path& file, std::uint16_t port)
    : path_(file), port_(port), file_(file, std::ios::binary) {
  Bytes header;
  header.little(std::uint32_t{0xa1b2c3d4});
  header.little(std::uint16_t{2});
  header.little(std::uint16_t{4});
  header.little(std::uint64_t{0});  // time zone and accuracy
  header.little(kSnapLength);
  header.little(kLinkEthernet);
  file_.write(header.text().data(), static_cast<std::streamsize>(header.text().size()));
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
}

void CaptureWriter::write(std::int64_t sent_ns, std::span<const std::byte> payload) {
  Bytes frame;
  append_ethernet(frame);
  append_ipv4(frame, payload.size());
  frame.big(port_);
  frame.big(port_);
  frame.big(static_cast<std::uint16_t>(kUdpHeader + payload.size()));
  frame.big(std::uint16_t{0});  // no UDP checksum, as the sensor sends it
  frame.raw(payload);

  Bytes record;
  record.little(static_cast<std::uint32_t>(sent_ns / 1'000'000'000));
  record.little(static_cast<std::uint32_t>(sent_ns % 1'000'000'000 / 1000));
  record.little(static_cast<std::uint32_t>(frame.text().size()));
  record.little(static_cast<std::uint32_t>(frame.text().size()));
  file_.write(record.text().data(), static_cast<std::streamsize>(record.text().size()));
  file_.write(frame.text().data(), static_cast<std::streamsize>(frame.text().size()));
}

void CaptureWriter::finish() {
  file_.close();
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
}

}  // namespace surefoot::simulation
