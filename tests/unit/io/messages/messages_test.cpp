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
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::big;
using test::bytes_of;
using test::little;
using Encoding = MessageEncoding;

std::string word(std::uint32_t value) { return little(value); }
std::string zeros(std::size_t count) { return std::string(count, '\0'); }
const std::string kCdr("\0\1\0\0", 4);

// Two points of 18 bytes in a row of 40: x y z f32, time f32, ring u16, and 4 of padding.
std::string points(std::size_t padding) {
  std::string bytes;
  for (int i = 0; i < 2; ++i) {
    const auto f = static_cast<float>(i);
    bytes += little(1.0F + f) + little(2.0F + f) + little(3.0F + f) + little(0.05F * f);
    bytes += little(static_cast<std::uint16_t>(7 + i));
  }
  return bytes + zeros(padding);
}

struct FieldBytes {
  const char* name;
  std::uint32_t offset;
  char type;
};
constexpr FieldBytes kFields[] = {
    {"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}, {"time", 12, 7}, {"ring", 16, 4}};

// CDR pads to the size of what follows, counted after the first four bytes.
std::string padded(std::string bytes, std::size_t unit) {
  while ((bytes.size() - 4) % unit != 0) bytes += '\0';
  return bytes;
}

std::string cdr_cloud(char big_endian = 0, std::uint32_t height = 1) {
  std::string m = kCdr + word(100) + word(5) + word(6) + "lidar" + zeros(1);
  m = padded(m, 4) + word(height) + word(2) + word(5);
  for (const FieldBytes& field : kFields) {
    const std::string name(field.name);
    m = padded(m, 4) + word(static_cast<std::uint32_t>(name.size() + 1)) + name + zeros(1);
    m = padded(m, 4) + word(field.offset) + field.type;
    m = padded(m, 4) + word(1);
  }
  m += big_endian;
  m = padded(m, 4) + word(18) + word(40);
  std::string data;
  for (std::uint32_t row = 0; row < height; ++row) data += points(4);
  return m + word(static_cast<std::uint32_t>(data.size())) + data + '\1' + zeros(2);
}

std::string ros1_cloud() {
  std::string m = word(9) + word(100) + word(5) + word(5) + "lidar" + word(1) + word(2) + word(5);
  for (const FieldBytes& field : kFields) {
    const std::string name(field.name);
    m += word(static_cast<std::uint32_t>(name.size())) + name + word(field.offset) + field.type +
         word(1);
  }
  return m + zeros(1) + word(18) + word(36) + word(36) + points(0) + '\1';
}

CloudMessage read(Encoding encoding, const std::string& bytes) {
  return read_cloud("sensor_msgs/PointCloud2", encoding, bytes_of(bytes));
}

void expect_two_points(const CloudMessage& cloud, std::size_t size = 2) {
  EXPECT_EQ(cloud.stamp_ns, 100'000'000'005);
  EXPECT_EQ(cloud.frame, "lidar");
  ASSERT_EQ(cloud.table.size, size);
  const BuiltScan built =
      build_scan(cloud.table, find_scan_columns(cloud.table, {}),
                 PointTimeRule{TimeUnit::seconds, TimeReference::relative, true}, cloud.stamp_ns,
                 StampAt::start);
  ASSERT_EQ(built.scan.points.size(), size);
  EXPECT_EQ(built.scan.points[size - 1], Eigen::Vector3f(2, 3, 4));
  EXPECT_EQ(built.scan.times_ns[size - 1], 50'000'001);  // 0.05 as a float
  EXPECT_EQ(built.scan.rings[size - 1], 8);
}

TEST(PointCloud2, CdrAndRos1) {
  const std::string cdr = cdr_cloud();
  expect_two_points(read(Encoding::cdr, cdr));
  const std::string ros1 = ros1_cloud();
  expect_two_points(read(Encoding::ros1, ros1));
}

TEST(PointCloud2, RowsArePutTogetherWithoutTheirPadding) {
  const std::string cdr = cdr_cloud(0, 3);
  expect_two_points(read(Encoding::cdr, cdr), 6);
}

// Twelve bytes would be made of each of them.
TEST(PointCloud2, CoordinatesOfAByteOrThatShareBytesAreRefused) {
  const std::string good = ros1_cloud();
  const std::size_t y = good.find("\1\0\0\0y", 0, 5) + 5;
  for (const auto& [bytes, message] :
       {std::pair{word(4) + '\2', "field 'y' is u8; expected coordinates of 2, 4 or 8 bytes"},
        std::pair{word(2) + '\7', "fields 'x' and 'y' share bytes"}}) {
    std::string bad = good;
    bad.replace(y, 5, bytes);
    const CloudMessage cloud = read(Encoding::ros1, bad);
    EXPECT_EQ(test::message_of<ReadError>([&] { (void)find_scan_columns(cloud.table, {}); }),
              message);
  }
}

/// The field's offset in the message: of the name, with its size before.
std::size_t field_at(const std::string& message, const std::string& name) {
  return message.find(word(static_cast<std::uint32_t>(name.size())) + name) + 4 + name.size();
}

// Drivers write 0 where they mean 1, or a count that a point has no room for.
TEST(PointCloud2, AFieldHasOneValueUnlessThereIsRoomForAll) {
  for (const std::uint32_t count : {0U, 9U}) {
    std::string cloud = ros1_cloud();
    cloud.replace(field_at(cloud, "ring") + 5, 4, word(count));
    EXPECT_EQ(read(Encoding::ros1, cloud).table.columns.back().count, 1U);
    expect_two_points(read(Encoding::ros1, cloud));
  }
}

TEST(PointCloud2, AFieldThatLeavesItsPointIsRefused) {
  std::string cloud = ros1_cloud();
  cloud.replace(field_at(cloud, "ring"), 4, word(17));
  EXPECT_EQ(test::message_of<ReadError>([&] { (void)read(Encoding::ros1, cloud); }),
            "field 'ring' at byte 17 of points of 18 bytes");
}

TEST(PointCloud2, BigEndianPointsAreRefused) {
  const std::string cdr = cdr_cloud(1);
  const std::string message = test::message_of<ReadError>([&] { (void)read(Encoding::cdr, cdr); });
  EXPECT_NE(message.find("big-endian"), std::string::npos) << message;
}

TEST(PointCloud2, EveryCutIsRefused) {
  const std::string cdr =
      cdr_cloud().substr(0, cdr_cloud().size() - 3);  // without is_dense and tail
  for (std::size_t size = 0; size < cdr.size(); ++size) {
    const std::string cut = cdr.substr(0, size);
    EXPECT_THROW((void)read(Encoding::cdr, cut), ReadError) << size;
  }
}

TEST(PointCloud2, SizesThatLieAreRefused) {
  const std::string good = ros1_cloud();
  const std::size_t width_at = 4 + 8 + 4 + 5 + 4;
  const std::size_t fields_at = width_at + 4;
  for (const std::size_t at : {width_at, width_at - 4, fields_at, std::size_t{12}}) {
    std::string bad = good;
    bad.replace(at, 4, word(0xffff'fff0));
    EXPECT_THROW((void)read(Encoding::ros1, bad), ReadError) << at;
  }
}

TEST(PointCloud2, FieldsHaveALimit) {
  const auto cloud_of = [](std::uint32_t fields) {
    std::string m = word(9) + word(100) + word(5) + word(0) + word(1) + word(0) + word(fields);
    for (std::uint32_t i = 0; i < fields; ++i) m += word(1) + "x" + word(0) + '\1' + word(1);
    return m + zeros(1) + word(18) + word(0) + word(0) + '\1';
  };
  EXPECT_EQ(read(Encoding::ros1, cloud_of(1000)).table.columns.size(), 1000U);
  EXPECT_EQ(test::message_of<ReadError>([&] { (void)read(Encoding::ros1, cloud_of(1001)); }),
            "1001 fields; expected at most 1000");
}

// CDR 2 aligns to 4 at most, and has a size before a sequence of structures; "delimited" before
// every structure. The sizes' values are not needed.
std::string cdr2_cloud(bool delimited) {
  const std::string size = delimited ? word(0) : "";
  std::string m = std::string("\0", 1) + (delimited ? '\x09' : '\x07') + zeros(2);
  m += size + size + size + word(100) + word(5) + word(6) + "lidar" + zeros(1);
  m = padded(m, 4) + word(1) + word(2) + word(0) + word(5);
  for (const FieldBytes& field : kFields) {
    const std::string name(field.name);
    m = padded(m, 4) + size + word(static_cast<std::uint32_t>(name.size() + 1)) + name + zeros(1);
    m = padded(m, 4) + word(field.offset) + field.type;
    m = padded(m, 4) + word(1);
  }
  m += zeros(1);
  m = padded(m, 4) + word(18) + word(36) + word(36);
  return m + points(0) + '\1';
}

TEST(PointCloud2, Cdr2) {
  const std::string plain = cdr2_cloud(false);
  expect_two_points(read(Encoding::cdr, plain));
  const std::string delimited = cdr2_cloud(true);
  expect_two_points(read(Encoding::cdr, delimited));
}

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
  EXPECT_THROW(MessageReader(Encoding::other, bytes_of(list)), ReadError);
  EXPECT_THROW(MessageReader(Encoding::cdr, bytes_of(list).first(3)), ReadError);
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
