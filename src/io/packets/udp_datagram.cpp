// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/udp_datagram.hpp"

#include <algorithm>

namespace surefoot::io {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::uint16_t kEtherIpv4 = 0x0800;

// So many parts after its last one a datagram is not completed any more: later ones have its number
// again.
constexpr std::uint64_t kMostParts = 256;

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
    case LinkLayer::ethernet:
      return ip_in_ethernet(frame);
    case LinkLayer::linux_cooked:
      return ip_in_cooked(frame, 14, 16);
    case LinkLayer::linux_cooked2:
      return ip_in_cooked(frame, 0, 20);
    case LinkLayer::loopback:
      return ip_in_loopback(frame);
    case LinkLayer::raw_ip:
      return frame;
  }
  return std::nullopt;
}

// The datagram that begins with a UDP header.
UdpDatagram datagram_in(Bytes udp, std::uint32_t source) {
  if (udp.size() < kUdpHeader) {
    return {FrameContent::truncated, source, 0, {}};
  }
  const std::uint16_t port = u16(udp, 2);
  const std::size_t length = u16(udp, 4);
  if (length < kUdpHeader || length > udp.size()) {
    return {FrameContent::truncated, source, port, {}};
  }
  return {FrameContent::udp, source, port, udp.subspan(kUdpHeader, length - kUdpHeader)};
}

constexpr std::size_t kMostDatagramBytes = 65'535;
constexpr std::size_t kUnitBytes = 8;  // of a fragment's offset

}  // namespace

UdpDatagram find_udp(LinkLayer link, std::span<const std::byte> frame, IpFragment* fragment) {
  constexpr std::size_t kLeastIpHeader = 20;
  constexpr std::uint8_t kUdpProtocol = 17;
  const std::optional<Bytes> ip = ip_in(link, frame);
  if (!ip || ip->empty() || u8(*ip, 0) >> 4 != 4) {
    return {};
  }
  if (ip->size() < kLeastIpHeader) {
    return {FrameContent::truncated, 0, 0, {}};
  }
  const std::size_t ip_header = 4U * (u8(*ip, 0) & 0x0fU);
  if (u8(*ip, 9) != kUdpProtocol || ip_header < kLeastIpHeader) {
    return {};
  }
  const std::uint32_t source = static_cast<std::uint32_t>(u16(*ip, 12)) << 16 | u16(*ip, 14);
  if (ip->size() < ip_header) {
    return {FrameContent::truncated, source, 0, {}};
  }
  const std::uint16_t flags = u16(*ip, 6);
  const bool more = (flags & 0x2000U) != 0;
  const std::size_t offset = kUnitBytes * (flags & 0x1fffU);
  if (!more && offset == 0) {
    return datagram_in(ip->subspan(ip_header), source);
  }
  const std::size_t length = u16(*ip, 2);
  if (length < ip_header || length > ip->size()) {
    return {FrameContent::truncated, source, 0, {}};
  }
  if (fragment != nullptr) {
    *fragment = {source,      static_cast<std::uint32_t>(u16(*ip, 16)) << 16 | u16(*ip, 18),
                 u16(*ip, 4), offset,
                 !more,       ip->subspan(ip_header, length - ip_header)};
  }
  return {FrameContent::fragment, source, 0, {}};
}

FragmentBuffer::Pending& FragmentBuffer::pending_for(const IpFragment& fragment) {
  Pending* oldest = &pending_.front();
  for (Pending& one : pending_) {
    const bool known = one.used > 0 && clock_ - one.used <= kMostParts;
    if (known && one.id == fragment.id && one.source_address == fragment.source_address &&
        one.destination_address == fragment.destination_address) {
      return one;
    }
    oldest = one.used < oldest->used ? &one : oldest;
  }
  oldest->source_address = fragment.source_address;
  oldest->destination_address = fragment.destination_address;
  oldest->id = fragment.id;
  oldest->size = 0;
  oldest->received = 0;
  oldest->units.assign((kMostDatagramBytes + 1) / kUnitBytes, false);
  oldest->bytes.resize(kMostDatagramBytes + 1);
  return *oldest;
}

UdpDatagram FragmentBuffer::add(const IpFragment& fragment) {
  const UdpDatagram none = {FrameContent::fragment, fragment.source_address, 0, {}};
  const std::size_t end = fragment.offset + fragment.bytes.size();
  // All but the last are of whole units.
  if (fragment.bytes.empty() || end > kMostDatagramBytes ||
      (!fragment.last && fragment.bytes.size() % kUnitBytes != 0)) {
    return none;
  }
  Pending& pending = pending_for(fragment);
  pending.used = ++clock_;
  for (std::size_t at = fragment.offset; at < end; at += kUnitBytes) {
    if (!pending.units[at / kUnitBytes]) {
      pending.units[at / kUnitBytes] = true;
      pending.received += std::min(kUnitBytes, end - at);
    }
  }
  std::copy(fragment.bytes.begin(), fragment.bytes.end(),
            pending.bytes.begin() + static_cast<std::ptrdiff_t>(fragment.offset));
  pending.size = fragment.last ? end : pending.size;
  if (pending.size == 0 || pending.received != pending.size) {
    return none;
  }
  pending.used = 0;  // free, though its bytes stay until they are needed
  return datagram_in(Bytes(pending.bytes).first(pending.size), fragment.source_address);
}

}  // namespace surefoot::io
