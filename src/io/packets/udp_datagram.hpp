// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// UDP over IPv4 inside captured frames of the link layers that recorders use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace surefoot::io {

inline constexpr std::size_t kUdpHeader = 8;  // [bytes]

enum class LinkLayer { ethernet, linux_cooked, linux_cooked2, loopback, raw_ip };

enum class FrameContent { udp, other, truncated, fragment };

struct UdpDatagram {
  FrameContent content = FrameContent::other;
  std::uint32_t source_address = 0;
  std::uint16_t destination_port = 0;
  std::span<const std::byte> payload;  ///< looks into the frame
};

/// Part of a datagram that was too long for one frame, as an Ouster's are.
struct IpFragment {
  std::uint32_t source_address = 0;
  std::uint32_t destination_address = 0;
  std::uint16_t id = 0;
  std::size_t offset = 0;  ///< in the datagram's bytes, UDP header included
  bool last = false;
  std::span<const std::byte> bytes;  ///< looks into the frame
};

/// Finds the datagram in a captured frame: through VLAN tags and IPv4 options. All that is not IPv4
/// UDP is other, a datagram that the capture cut short truncated, a part of one fragment.
/// @param fragment where not null, receives a part.
[[nodiscard]] UdpDatagram find_udp(LinkLayer link, std::span<const std::byte> frame,
                                   IpFragment* fragment = nullptr);

/// Puts datagrams together from their parts, in any order; forgets those that stay incomplete, and
/// holds a fixed amount of memory whatever is sent.
class FragmentBuffer {
 public:
  /// The datagram that a part completes, valid until the next call; fragment if none.
  [[nodiscard]] UdpDatagram add(const IpFragment& fragment);

 private:
  struct Pending {
    std::uint32_t source_address = 0, destination_address = 0;
    std::uint16_t id = 0;
    std::uint64_t used = 0;    ///< when a part was added last; 0: free
    std::size_t size = 0;      ///< known with the last part; 0: not yet
    std::size_t received = 0;  ///< bytes
    std::vector<bool> units;   ///< of 8 bytes, that are there
    std::vector<std::byte> bytes;
  };
  [[nodiscard]] Pending& pending_for(const IpFragment& fragment);

  std::array<Pending, 16> pending_;
  std::uint64_t clock_ = 0;
};

}  // namespace surefoot::io
