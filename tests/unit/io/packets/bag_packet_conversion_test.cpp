// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Packets in a bag into a capture: which go, that they are the same, and what goes with them.
#include "io/bag_packet_conversion.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/ascii_values.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/file_reader.hpp"
#include "io/messages/message_writer.hpp"
#include "io/packets/capture_file.hpp"
#include "io/packets/udp_datagram.hpp"
#include "unit/io/support.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
using Flavour = MessageWriter::Flavour;

constexpr std::int64_t kWholeHour = 1'453'363'200'000'000'000;
constexpr unsigned kRevolutions = 5;

/// What a capture has to hold, or holds.
struct Packets {
  std::vector<std::int64_t> stamps;
  std::vector<std::string> payloads;

  void add(std::int64_t stamp_ns, std::string payload) {
    stamps.push_back(stamp_ns);
    payloads.push_back(std::move(payload));
  }
};

Packets packets_in(const fs::path& capture, unsigned port) {
  Packets packets;
  CaptureFile file(capture);
  while (const std::optional<CapturedFrame> frame = file.next()) {
    const UdpDatagram datagram = find_udp(file.link(), frame->bytes);
    EXPECT_EQ(datagram.destination_port, port);
    packets.add(frame->stamp_ns, std::string(text_of(datagram.payload)));
  }
  return packets;
}

MessageDefinition definition_named(const std::string& type) {
  MessageDefinition definition;
  definition.type = type;
  return definition;
}

class BagPacketConversion : public testing::Test {
 protected:
  BagPacketConversion() {
    request_.input = folder_.path() / "walk.bag";
    request_.output = folder_.path() / "out.pcap";
  }
  ConversionOutcome convert() {
    std::error_code ignored;
    fs::remove(request_.output, ignored);
    return convert_recording(
        request_, {[](std::size_t, double) {}, [](const std::string& text) { FAIL() << text; },
                   [] { return false; }});
  }
  /// All that was written is what of the bag's is to go, in its order.
  template <typename IsIn>
  void expect(const Packets& bag, unsigned port, IsIn&& is_in) {
    const ConversionOutcome outcome = convert();
    const Packets written = packets_in(request_.output, port);
    Packets expected;
    for (std::size_t i = 0; i < bag.payloads.size(); ++i) {
      if (is_in(i)) expected.add(bag.stamps[i], bag.payloads[i]);
    }
    EXPECT_TRUE(written.payloads == expected.payloads)
        << written.payloads.size() << " of " << expected.payloads.size();
    EXPECT_EQ(written.stamps, expected.stamps);
    EXPECT_EQ(outcome.packets, expected.payloads.size());
  }
  /// All, two turns from the second on, and every other turn.
  void expect_choices(const Packets& bag, unsigned port, unsigned turn) {
    expect(bag, port, [](std::size_t) { return true; });
    request_.start = 1;
    request_.count = 2;
    expect(bag, port, [=](std::size_t i) { return i >= turn && i < 3 * turn; });
    request_.start = 0;
    request_.count = std::numeric_limits<std::size_t>::max();
    request_.stride = 2;
    expect(bag, port, [=](std::size_t i) { return i / turn % 2 == 0; });
    request_.stride = 1;
  }
  const test::TemporaryFolder folder_;
  ConversionRequest request_;
};

/// Fifty to a message, which ends where no turn does.
Packets write_velodyne_bag(const fs::path& file) {
  constexpr std::int64_t kPeriodNs = 1'327'104;
  constexpr unsigned kAtOnce = 50, kPackets = kRevolutions * 75;
  const auto bag = make_ros1_bag(file);
  const std::size_t topic =
      bag->add_topic("/velodyne_packets", definition_named("velodyne_msgs/VelodyneScan"));
  Packets packets;
  for (unsigned i = 0; i < kPackets; i += kAtOnce) {
    MessageWriter message(Flavour::ros1);
    const unsigned end = std::min(i + kAtOnce, kPackets);
    message.header(kWholeHour + i * kPeriodNs, "velodyne").count(end - i);
    for (unsigned k = i; k < end; ++k) {
      packets.add(
          kWholeHour + k * kPeriodNs,
          test::vlp16_payload(k * 480 % 36000, 40, static_cast<std::uint32_t>(k * kPeriodNs / 1000),
                              0x37, [](auto, auto) {
                                return test::Measured{500, 1};
                              }));
      message.time(packets.stamps.back()).raw(packets.payloads.back());
    }
    bag->write(topic, kWholeHour + end * kPeriodNs, message.take());
  }
  bag->finish();
  return packets;
}

TEST_F(BagPacketConversion, OfAVelodyne) {
  const Packets packets = write_velodyne_bag(request_.input);
  expect_choices(packets, 2368, 75);
  request_.topics = {"/velodyne_packets", "/others"};
  EXPECT_THROW((void)convert(), std::invalid_argument);
}

const std::string kProfile = "RNG15_RFL8_NIR8";

/// A packet to a message, as the ROS 2 driver publishes them: stamped by the bag alone. Its
/// metadata come after the first ones.
Packets write_ouster_bag(const fs::path& file) {
  constexpr std::uint64_t kPeriodNs = 25'000'000;  // 16 columns
  const auto bag = make_mcap_bag(file);
  const std::size_t lidar =
      bag->add_topic("/ouster/lidar_packets", definition_named("ouster_sensor_msgs/PacketMsg"));
  const std::size_t imu =
      bag->add_topic("/ouster/imu_packets", definition_named("ouster_sensor_msgs/PacketMsg"));
  const std::size_t metadata =
      bag->add_topic("/ouster/metadata", definition_named("std_msgs/String"));
  Packets packets;
  for (unsigned i = 0; i < kRevolutions * 4; ++i) {
    auto packet = sensors::test::ouster_packet(4, false, static_cast<std::uint16_t>(7 + i / 4),
                                               static_cast<std::uint16_t>(i % 4 * 16),
                                               5'000'000'000 + i * kPeriodNs);
    packet[sensors::test::ouster_pixel(4, false, 3, 5)] = '\x40';  // a return
    packets.add(kWholeHour + static_cast<std::int64_t>(i * kPeriodNs), packet);
    for (const auto& [topic, payload] : {std::pair(lidar, packet), std::pair(imu, packet)}) {
      MessageWriter message(Flavour::cdr);
      message.count(payload.size()).raw(payload);
      bag->write(topic, packets.stamps.back(), message.take());
    }
    if (i == 2) {
      MessageWriter message(Flavour::cdr);
      message.string(sensors::test::ouster_json(kProfile));
      bag->write(metadata, packets.stamps.back(), message.take());
    }
  }
  bag->finish();
  return packets;
}

TEST_F(BagPacketConversion, OfAnOusterWithItsMetadataBesideThem) {
  request_.input = folder_.path() / "walk.mcap";
  const Packets packets = write_ouster_bag(request_.input);
  request_.topics = {"/ouster/lidar_packets"};
  expect_choices(packets, 7502, 4);
  const auto recording = open_recording(request_.output);  // by the metadata beside it alone
  std::size_t scans = 0;
  for (; const auto item = recording->next(); ++scans) {
    ASSERT_TRUE(item->scan.has_value()) << item->error;
    EXPECT_EQ(item->scan->points.size(), 4U);
  }
  EXPECT_EQ(scans, 3U);
  std::vector<std::byte> file;
  read_whole_file(folder_.path() / "out.json", file);
  EXPECT_EQ(text_of(file), sensors::test::ouster_json(kProfile));
}

}  // namespace
}  // namespace surefoot::io
