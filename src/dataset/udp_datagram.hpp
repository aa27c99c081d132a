// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// UDP over IPv4 inside captured frames of the link layers that recorders use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace surefoot::dataset {

enum class LinkLayer { kEthernet, kLinuxCooked, kLinuxCooked2, kLoopback, kRawIp };

enum class FrameContent { kUdp, kOther, kTruncated };

struct UdpDatagram {
  FrameContent content = FrameContent::kOther;
  std::uint16_t destination_port = 0;
  std::span<const std::byte> payload;  ///< looks into the frame
};

/// Finds the datagram in a captured frame: through VLAN tags and IPv4 options; fragments and all
/// that is not IPv4 UDP are kOther, datagrams that the capture cut short kTruncated.
[[nodiscard]] UdpDatagram find_udp(LinkLayer link, std::span<const std::byte> frame);

}  // namespace surefoot::dataset
