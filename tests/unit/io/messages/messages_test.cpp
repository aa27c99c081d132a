// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages byte by byte, as CDR's and ROS 1's rules have them.
#include <gtest/gtest.h>

#include "io/messages/cloud_message.hpp"
#include "io/messages/message_reader.hpp"
#include "io/messages/packet_message.hpp"
#include "io/recording.hpp"
#include "io/scan_builder.hpp"
#include "unit/io/messages/message_bytes.hpp"

namespace surefoot::io {
namespace {

using test::big;
using test::bytes_of;
using test::kCdr;
using test::little;
using test::padded;
using test::word;
using test::zeros;
using Encoding = MessageEncoding;

TEST(MessageReader, AlignsEightBytesByVersion) {
  const std::string cdr = kCdr + word(1) + zeros(4) + little(std::uint64_t{77});
  MessageReader first(Encoding::cdr, bytes_of(cdr));
  (void)first.number<std::uint32_t>("a");
  EXPECT_EQ(first.number<std::uint64_t>("b"), 77U);
  const std::string cdr2 = std::string("\0\7\0\0", 4) + word(1) + little(std::uint64_t{77});
  MessageReader second(Encoding::cdr, bytes_of(cdr2));
  (void)second.number<std::uint32_t>("a");
  EXPECT_EQ(second.number<std::uint64_t>("b"), 77U);
  const std::string swapped = zeros(4) + big(std::uint32_t{3}) + "ab" + zeros(1);
  EXPECT_EQ(MessageReader(Encoding::cdr, bytes_of(swapped)).string("text"), "ab");
}

TEST(MessageReader, RefusesOtherRepresentations) {
  const std::string list = std::string("\0\3\0\0", 4) + zeros(8);
  const std::string message =
      test::message_of<ReadError>([&] { MessageReader(Encoding::cdr, bytes_of(list)); });
  EXPECT_NE(message.find("representation is 3"), std::string::npos) << message;
  const std::string first_byte = std::string("\1\1\0\0", 4) + zeros(8);
  EXPECT_THROW(MessageReader(Encoding::cdr, bytes_of(first_byte)), ReadError);
  EXPECT_THROW(MessageReader(Encoding::other, bytes_of(list)), ReadError);
  EXPECT_THROW(MessageReader(Encoding::cdr, bytes_of(list).first(3)), ReadError);
}

TEST(MessageReader, AStringOfCdrNeedNotEndWithItsNul) {
  const std::string bytes = kCdr + word(3) + "abc";
  EXPECT_EQ(MessageReader(Encoding::cdr, bytes_of(bytes)).string("text"), "abc");
}

TEST(MessageReader, AStringOfRos1KeepsItsNul) {
  const std::string bytes = word(3) + "ab" + zeros(1);
  EXPECT_EQ(MessageReader::packed(bytes_of(bytes)).string("text"), "ab" + zeros(1));
}

// What a number is aligned to may lie behind the end.
TEST(MessageReader, NothingIsReadBehindTheEnd) {
  const std::string bytes = kCdr + "x";
  MessageReader reader(Encoding::cdr, bytes_of(bytes));
  (void)reader.number<std::uint8_t>("a");
  EXPECT_EQ(test::message_of<ReadError>([&] { (void)reader.number<std::uint64_t>("b"); }),
            "the message ends within its b: 8 bytes expected, 0 left");
}

TEST(MessageReader, SecondsHaveASignInRos2Alone) {
  const std::string time = word(0xffff'ffff) + word(5);
  const std::string cdr = kCdr + time;
  EXPECT_EQ(MessageReader(Encoding::cdr, bytes_of(cdr)).time("stamp"), -999'999'995);
  EXPECT_EQ(MessageReader::packed(bytes_of(time)).time("stamp"), 4'294'967'295'000'000'005);
}

TEST(CloudMessage, WhatIsSaidOfTopicsThatHoldNoScans) {
  EXPECT_EQ(why_no_scans("/robot/points_raw", "robot/lidar"), "");
  EXPECT_EQ(why_no_scans("/points", "robot/odom"),
            "points in frame 'odom', a world's, are no scans as measured");
  for (const std::string word : {"undistorted", "deskewed", "registered"}) {
    for (const std::string& topic : {"/" + word + "/points", "/points_" + word}) {
      EXPECT_EQ(why_no_scans(topic, "lidar"),
                "points that are " + word + " are no scans as measured");
    }
    EXPECT_EQ(why_no_scans("/not" + word, "lidar"), "");
  }
  EXPECT_EQ(why_no_scans("/camera/depth_registered/points", "camera"), "");
}

TEST(CloudMessage, EveryDriversTypesAreKnown) {
  for (const char* type : {"sensor_msgs/PointCloud2", "livox_ros_driver/CustomMsg",
                           "livox_ros_driver2/CustomMsg", "livox_interfaces/CustomMsg"}) {
    EXPECT_TRUE(is_cloud_type(type)) << type;
  }
  EXPECT_FALSE(is_cloud_type("sensor_msgs/PointCloud"));
  CloudMessage cloud;
  cloud.frame = "a\x1b[2Jb";
  EXPECT_EQ(sensor_of(cloud).find('\x1b'), std::string::npos);
}

TEST(MessageReader, ALengthThatTheRestHasNoRoomForIsRefused) {
  const std::string three = word(3) + zeros(12);
  EXPECT_EQ(MessageReader::packed(bytes_of(three)).count("things", 4), 3U);
  EXPECT_EQ(test::message_of<ReadError>(
                [&] { (void)MessageReader::packed(bytes_of(three)).count("things", 5); }),
            "3 things announced in 12 bytes");
}

// Three points, 1 ms apart; the time base 3 ns after the header's stamp.
std::string livox(bool cdr, std::int64_t base) {
  std::string m = cdr ? kCdr : word(0);
  m += word(100) + word(0) + (cdr ? word(2) + "l" + zeros(1) : word(1) + "l");
  if (cdr) m = padded(m, 8);
  m += little(base) + word(3) + "\x02" + zeros(3) + word(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (cdr) m = padded(m, 4);
    m += word(i * 1'000'000) + little(1.0F) + little(2.0F) + little(static_cast<float>(i));
    m += std::string("\x09\x10", 2) + static_cast<char>(i);
  }
  return m;
}

TEST(LivoxMessage, BothDrivers) {
  for (const bool cdr : {false, true}) {
    const std::string bytes = livox(cdr, 100'000'000'003);
    const CloudMessage cloud =
        read_cloud(cdr ? "livox_ros_driver2/CustomMsg" : "livox_ros_driver/CustomMsg",
                   cdr ? Encoding::cdr : Encoding::ros1, bytes_of(bytes));
    EXPECT_EQ(cloud.stamp_ns, 100'000'000'003);
    EXPECT_EQ(sensor_of(cloud), "frame 'l', LiDAR 2");
    const BuiltScan built =
        build_scan(cloud.table, find_scan_columns(cloud.table, {}),
                   PointTimeRule{TimeUnit::nanoseconds, TimeReference::relative, true},
                   cloud.stamp_ns, StampAt::start);
    ASSERT_EQ(built.scan.points.size(), 3U);
    EXPECT_EQ(built.scan.times_ns, (std::vector<std::int32_t>{0, 1'000'000, 2'000'000}));
    EXPECT_EQ(built.scan.points[2], Eigen::Vector3f(1, 2, 2));
    EXPECT_EQ(built.scan.rings, (std::vector<std::uint16_t>{0, 1, 2}));
    EXPECT_EQ(built.scan.intensities[1], 9.0F);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_THROW(
          (void)read_cloud("livox_ros_driver2/CustomMsg", cdr ? Encoding::cdr : Encoding::ros1,
                           bytes_of(bytes).first(size)),
          ReadError)
          << size;
    }
  }
}

TEST(LivoxMessage, TimeBaseOfAnotherClockDoesNotCount) {
  const std::string bytes = livox(true, 5'000'000'000);
  EXPECT_EQ(read_cloud("livox_ros_driver2/CustomMsg", Encoding::cdr, bytes_of(bytes)).stamp_ns,
            100'000'000'000);
}

std::string big_word(std::uint32_t value) { return big(value); }

// One point, by the driver of a big-endian machine.
TEST(LivoxMessage, NumbersMayBeginWithTheirHighestByte) {
  std::string m = zeros(4) + big_word(100) + zeros(4) + big_word(2) + "l" + zeros(1);
  m = padded(m, 8) + big(std::int64_t{100'000'000'003}) + big_word(1) + "\x02" + zeros(3);
  m += big_word(1) + big_word(1'000'000) + big(1.0F) + big(2.0F) + big(3.0F) + "\x09\x10\x03";
  const CloudMessage cloud = read_cloud("livox_ros_driver2/CustomMsg", Encoding::cdr, bytes_of(m));
  const BuiltScan built =
      build_scan(cloud.table, find_scan_columns(cloud.table, {}),
                 PointTimeRule{TimeUnit::nanoseconds, TimeReference::relative, true},
                 cloud.stamp_ns, StampAt::start);
  EXPECT_EQ(built.scan.stamp_ns, 100'000'000'003);
  ASSERT_EQ(built.scan.points.size(), 1U);
  EXPECT_EQ(built.scan.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(built.scan.times_ns[0], 1'000'000);
  EXPECT_EQ(built.scan.rings[0], 3);
}

TEST(LivoxMessage, MayHoldNoPoints) {
  const std::string bytes = word(0) + word(100) + zeros(8) + zeros(8) + zeros(8) + word(0);
  const CloudMessage cloud =
      read_cloud("livox_ros_driver/CustomMsg", Encoding::ros1, bytes_of(bytes));
  EXPECT_EQ(cloud.table.size, 0U);
  for (const Column& column : cloud.table.columns) EXPECT_EQ(column.first, nullptr) << column.name;
}

// Every point would have its size before it.
TEST(LivoxMessage, DelimitedPointsAreRefused) {
  std::string m = std::string("\0\x09\0\0", 4) + word(0) + word(0) + word(0) + word(100) + word(0);
  m += word(2) + "l" + zeros(1);
  m = padded(m, 4) + little(std::int64_t{100'000'000'003}) + word(1) + "\x02" + zeros(3);
  m += word(23) + word(1) + word(19) + zeros(19);
  EXPECT_EQ(test::message_of<ReadError>([&] {
              (void)read_cloud("livox_ros_driver2/CustomMsg", Encoding::cdr, bytes_of(m));
            }),
            "Livox points in delimited CDR 2 are not read");
}

std::vector<MessagePacket> packets_of(const Topic& topic, const std::string& bytes) {
  std::vector<MessagePacket> packets;
  for_each_packet({&topic, 42, bytes_of(bytes)},
                  [&](const MessagePacket& packet) { packets.push_back(packet); });
  return packets;
}

TEST(PacketMessage, EveryType) {
  const std::string header = kCdr + word(1) + word(2) + word(1) + zeros(4);
  std::string velodyne = header + word(2);
  std::string pandar = header + word(2);
  std::string hesai = header + word(2);
  std::string nebula = header + word(2);
  for (std::uint32_t i = 0; i < 2; ++i) {
    const std::string stamp = word(10 + i) + word(7);
    velodyne = padded(velodyne, 4) + stamp + std::string(1206, 'a');
    pandar = padded(pandar, 4) + stamp + std::string(1500, 'b') + word(568);
    hesai = padded(hesai, 4) + stamp + word(5) + "abcde";
    hesai = padded(hesai, 4) + word(5);
    nebula = padded(nebula, 4) + stamp + word(3) + "xyz";
  }
  const struct {
    const char* type;
    std::string bytes;
    std::size_t size;
  } cases[] = {{"velodyne_msgs/VelodyneScan", velodyne + zeros(2), 1206},
               {"pandar_msgs/PandarScan", pandar, 568},
               {"hesai_ros_driver/UdpFrame", hesai, 5},
               {"nebula_msgs/NebulaPackets", nebula, 3}};
  for (const auto& one : cases) {
    const Topic topic{"/t", one.type, Encoding::cdr};
    const std::vector<MessagePacket> packets = packets_of(topic, one.bytes);
    ASSERT_EQ(packets.size(), 2U) << one.type;
    EXPECT_EQ(packets[1].stamp_ns, 11'000'000'007) << one.type;
    EXPECT_EQ(packets[1].bytes.size(), one.size) << one.type;
    EXPECT_THROW((void)packets_of(topic, one.bytes.substr(0, one.bytes.size() / 2)), ReadError);
  }
  const Topic ouster{"/t", "ouster_ros/PacketMsg", Encoding::ros1};
  const auto packets = packets_of(ouster, word(4) + "abcd");
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(packets[0].stamp_ns, 42);
  EXPECT_EQ(packets[0].bytes.size(), 4U);
}

TEST(PacketMessage, MorePacketsThanItsBytesHoldAreRefusedAtOnce) {
  const std::string header = word(9) + word(1) + word(2) + word(0);
  const auto refusal = [&](const char* type, std::size_t least) {
    const Topic topic{"/t", type, Encoding::ros1};
    const std::string bytes = header + word(3) + zeros(3 * least - 1);
    return test::message_of<ReadError>([&] { (void)packets_of(topic, bytes); });
  };
  EXPECT_EQ(refusal("velodyne_msgs/VelodyneScan", 1214), "3 packets announced in 3641 bytes");
  EXPECT_EQ(refusal("nebula_msgs/NebulaPackets", 12), "3 packets announced in 35 bytes");
}

TEST(PacketMessage, APacketIsNoLongerThanItsArray) {
  const std::string bytes = word(9) + word(1) + word(2) + word(0) + word(1) + word(1) + word(2) +
                            zeros(1500) + word(1501);
  const auto packets = packets_of({"/t", "pandar_msgs/PandarScan", Encoding::ros1}, bytes);
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(packets[0].bytes.size(), 1500U);
}

TEST(PacketMessage, OtherTypesHoldNone) {
  EXPECT_EQ(test::message_of<ReadError>([] {
              (void)packets_of({"/t", "sensor_msgs/Imu", Encoding::ros1}, word(0));
            }),
            "a sensor_msgs/Imu holds no packets");
}

// SemanticKITTI's clouds of some programs: a label where LOAM's have milliseconds.
TEST(BuildScan, LabelsInCurvatureAreNoTimes) {
  constexpr std::size_t kMany = 20'000;
  const std::vector<Eigen::Vector3f> points(kMany, Eigen::Vector3f::Ones());
  std::vector<float> curvatures(kMany);
  PointTable table;
  table.size = kMany;
  table.columns = coordinate_columns(points);
  table.columns.push_back({"curvature", ScalarType::f32,
                           reinterpret_cast<const std::byte*>(curvatures.data()), sizeof(float)});
  const auto filled = [&](std::size_t different) {
    for (std::size_t i = 0; i < kMany; ++i) {
      curvatures[i] = 100.0F * static_cast<float>(i % different) / static_cast<float>(different);
    }
    return find_scan_columns(table, {}).time != nullptr;
  };
  EXPECT_TRUE(filled(1800));
  EXPECT_TRUE(filled(64));
  EXPECT_FALSE(filled(34));
  // Of a few points each may have a time of its own.
  table.size = 40;
  EXPECT_TRUE(filled(40));
  EXPECT_FALSE(filled(4));
}

TEST(BuildScan, PointsOfAClockOfItsOwnCountFromTheFirst) {
  const std::array<double, 3> at = {49.5, 49.55, 49.6};
  const std::vector<Eigen::Vector3f> points(3, Eigen::Vector3f::Ones());
  PointTable table;
  table.size = 3;
  table.columns = coordinate_columns(points);
  table.columns.push_back({"timestamp", ScalarType::f64,
                           reinterpret_cast<const std::byte*>(at.data()), sizeof(double)});
  const PointTimeRule rule{TimeUnit::seconds, TimeReference::own_clock, false};
  const ScanColumns columns = find_scan_columns(table, {});
  constexpr std::int64_t kStamp = 1'700'000'000'000'000'000;
  const Scan start = build_scan(table, columns, rule, kStamp, StampAt::start).scan;
  EXPECT_EQ(start.stamp_ns, kStamp);
  EXPECT_EQ(start.times_ns, (std::vector<std::int32_t>{0, 50'000'000, 100'000'000}));
  const Scan end = build_scan(table, columns, rule, kStamp, StampAt::end).scan;
  EXPECT_EQ(end.times_ns, (std::vector<std::int32_t>{-100'000'000, -50'000'000, 0}));
  // The same for absolute times under a stamp that is far off: stamps are repaired later.
  const PointTimeRule absolute{TimeUnit::seconds, TimeReference::absolute, true};
  EXPECT_EQ(build_scan(table, columns, absolute, kStamp, StampAt::start).scan.times_ns,
            start.times_ns);
  const Scan near = build_scan(table, columns, absolute, 49'400'000'000, StampAt::start).scan;
  EXPECT_EQ(near.times_ns.front(), 100'000'000);
}

TEST(PlainTypeName, OfEverySpelling) {
  for (const char* name :
       {"sensor_msgs/PointCloud2", "sensor_msgs/msg/PointCloud2",
        "sensor_msgs::msg::dds_::PointCloud2_", "sensor_msgs::msg::PointCloud2"}) {
    EXPECT_EQ(plain_type_name(name), "sensor_msgs/PointCloud2") << name;
  }
}

}  // namespace
}  // namespace surefoot::io
