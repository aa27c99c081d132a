// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages that hold a sensor's raw packets, as it sent them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// One packet: when the driver received it, and its bytes as in the UDP datagram.
struct MessagePacket {
  std::int64_t stamp_ns = 0;
  std::span<const std::byte> bytes;
};

/// velodyne_msgs/VelodyneScan, pandar_msgs/PandarScan, Hesai's UdpFrame, nebula_msgs/NebulaPackets,
/// ouster's PacketMsg.
[[nodiscard]] bool is_packet_type(std::string_view type);

/// The packets of a message in their order. Ouster's packets have no stamp of their own and get
/// `logged_ns`. Throws ReadError where the message is not what its type asks for; the packets
/// before the damage have been visited.
void for_each_packet(const Message& message,
                     const std::function<void(const MessagePacket&)>& visitor);

}  // namespace surefoot::io
