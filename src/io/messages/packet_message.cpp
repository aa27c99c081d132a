// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/packet_message.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "io/messages/message_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

/// How a type serialises its packets.
struct PacketLayout {
  std::string_view type;
  bool is_frame;            ///< header and a sequence of {stamp, bytes, size}; else bytes alone
  std::size_t fixed_bytes;  ///< of the array in each packet; 0: a sequence
  bool has_size;            ///< the number of valid bytes follows
};
constexpr std::array<PacketLayout, 9> kLayouts = {
    {{"velodyne_msgs/VelodyneScan", true, 1206, false},
     {"pandar_msgs/PandarScan", true, 1500, true},
     {"hesai_ros_driver/UdpFrame", true, 0, true},
     {"hesai_lidar/UdpFrame", true, 0, true},
     {"nebula_msgs/NebulaPackets", true, 0, false},
     {"ouster_ros/PacketMsg", false, 0, false},
     {"ouster_msgs/PacketMsg", false, 0, false},
     {"ouster_sensor_msgs/PacketMsg", false, 0, false},
     {"ouster_srvs/PacketMsg", false, 0, false}}};

const PacketLayout* layout_of(std::string_view type) {
  const auto found = std::find_if(kLayouts.begin(), kLayouts.end(),
                                  [type](const PacketLayout& one) { return one.type == type; });
  return found == kLayouts.end() ? nullptr : &*found;
}

MessagePacket read_packet(MessageReader& reader, const PacketLayout& layout) {
  MessagePacket packet;
  reader.begin_structure();
  packet.stamp_ns = reader.time("packet's stamp");
  const std::size_t size =
      layout.fixed_bytes > 0 ? layout.fixed_bytes : reader.count("bytes of a packet", 1);
  packet.bytes = reader.take(size, "packet");
  if (layout.has_size) {
    const auto valid = reader.number<std::uint32_t>("packet's size");
    packet.bytes = packet.bytes.first(std::min<std::size_t>(valid, packet.bytes.size()));
  }
  return packet;
}

}  // namespace

bool is_packet_type(std::string_view type) { return layout_of(type) != nullptr; }

void for_each_packet(const Message& message,
                     const std::function<void(const MessagePacket&)>& visitor) {
  const PacketLayout* const layout = layout_of(message.topic->type);
  if (layout == nullptr) throw ReadError("a " + message.topic->type + " holds no packets");
  MessageReader reader(message.topic->encoding, message.bytes);
  reader.begin_structure();
  if (!layout->is_frame) {
    const auto size = reader.count("bytes of a packet", 1);
    return visitor({message.logged_ns, reader.take(size, "packet")});
  }
  (void)read_header(reader);
  const std::size_t least = sizeof(std::uint64_t) + std::max<std::size_t>(layout->fixed_bytes, 4);
  for (auto left = reader.structures("packets", least); left > 0; --left) {
    visitor(read_packet(reader, *layout));
  }
}

}  // namespace surefoot::io
