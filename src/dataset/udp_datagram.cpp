// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/udp_datagram.hpp"

namespace surefoot::dataset {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::uint16_t kEtherIpv4 = 0x0800;

std::uint8_t u8(Bytes bytes, std::size_t at) { return std::to_integer<std::uint8_t>(bytes[at]); }

// Network byte order.
std::uint16_t u16(Bytes bytes, std::size_t at) {
  return static_cast<std::uint16_t>((u8(bytes, at) << 8) | u8(bytes, at + 1));
}

bool is_vlan(std::uint16_t ether_type) {
  return ether_type == 0x8100 || ether_type == 0x88a8 || ether_type == 0x9100;
}

std::optional<Bytes> ip_in_ethernet(Bytes frame) {
  std::size_t at = 12;  // past the two addresses
  while (frame.size() >= at + 2 && is_vlan(u16(frame, at))) {
    at += 4;
  }
  const bool is_ip = frame.size() >= at + 2 && u16(frame, at) == kEtherIpv4;
  return is_ip ? std::optional(frame.subspan(at + 2)) : std::nullopt;
}

// A header of fixed size that names the protocol as an EtherType at `type_at`.
std::optional<Bytes> ip_in_cooked(Bytes frame, std::size_t type_at, std::size_t header_size) {
  const bool is_ip = frame.size() >= header_size && u16(frame, type_at) == kEtherIpv4;
  return is_ip ? std::optional(frame.subspan(header_size)) : std::nullopt;
}

// Four bytes of address family, AF_INET = 2, in the byte order of the machine that captured.
std::optional<Bytes> ip_in_loopback(Bytes frame) {
  const bool is_ip = frame.size() >= 4 && (u8(frame, 0) == 2 || u8(frame, 3) == 2);
  return is_ip ? std::optional(frame.subspan(4)) : std::nullopt;
}

std::optional<Bytes> ip_in(LinkLayer link, Bytes frame) {
  switch (link) {
    case LinkLayer::kEthernet:
      return ip_in_ethernet(frame);
    case LinkLayer::kLinuxCooked:
      return ip_in_cooked(frame, 14, 16);
    case LinkLayer::kLinuxCooked2:
      return ip_in_cooked(frame, 0, 20);
    case LinkLayer::kLoopback:
      return ip_in_loopback(frame);
    case LinkLayer::kRawIp:
      return frame;
  }
  return std::nullopt;
}

}  // namespace

UdpDatagram find_udp(LinkLayer link, std::span<const std::byte> frame) {
  constexpr std::size_t kLeastIpHeader = 20;
  constexpr std::size_t kUdpHeader = 8;
  constexpr std::uint8_t kUdpProtocol = 17;
  const std::optional<Bytes> ip = ip_in(link, frame);
  if (!ip || ip->empty() || u8(*ip, 0) >> 4 != 4) {
    return {};
  }
  if (ip->size() < kLeastIpHeader) {
    return {FrameContent::kTruncated, 0, {}};
  }
  const std::size_t ip_header = 4U * (u8(*ip, 0) & 0x0fU);
  const bool is_fragment = (u16(*ip, 6) & 0x3fffU) != 0;  // offset, or more to come
  if (u8(*ip, 9) != kUdpProtocol || ip_header < kLeastIpHeader || is_fragment) {
    return {};
  }
  if (ip->size() < ip_header + kUdpHeader) {
    return {FrameContent::kTruncated, 0, {}};
  }
  const Bytes udp = ip->subspan(ip_header);
  const std::uint16_t port = u16(udp, 2);
  const std::size_t length = u16(udp, 4);
  if (length < kUdpHeader || length > udp.size()) {
    return {FrameContent::kTruncated, port, {}};
  }
  return {FrameContent::kUdp, port, udp.subspan(kUdpHeader, length - kUdpHeader)};
}

}  // namespace surefoot::dataset
