// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// PointCloud2 byte by byte, as CDR's and ROS 1's rules have it.
#include <gtest/gtest.h>

#include "io/messages/cloud_message.hpp"
#include "io/recording.hpp"
#include "io/scan_builder.hpp"
#include "unit/io/messages/message_bytes.hpp"

namespace surefoot::io {
namespace {

using test::kCdr;
using test::little;
using test::padded;
using test::word;
using test::zeros;
using Encoding = MessageEncoding;

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

struct Rows {
  std::uint32_t height = 1;
  std::uint32_t width = 2;
  std::uint32_t point_step = 18;
  std::uint32_t row_step = 36;
};
std::string ros1_cloud(const Rows& rows = {}, const std::string& data = points(0),
                       bool has_fields = true) {
  std::string m = word(9) + word(100) + word(5) + word(5) + "lidar";
  m += word(rows.height) + word(rows.width) + word(has_fields ? 5 : 0);
  for (const FieldBytes& field : kFields) {
    const std::string name(field.name);
    if (has_fields) m += word(static_cast<std::uint32_t>(name.size())) + name;
    if (has_fields) m += word(field.offset) + field.type + word(1);
  }
  m += zeros(1) + word(rows.point_step) + word(rows.row_step);
  return m + word(static_cast<std::uint32_t>(data.size())) + data + '\1';
}

CloudMessage read(Encoding encoding, const std::string& bytes) {
  return read_cloud("sensor_msgs/PointCloud2", encoding, test::bytes_of(bytes));
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

// Some drivers write 0 for a row's bytes.
TEST(PointCloud2, RowsThatAreShorterThanTheirPointsFollowEachOther) {
  const std::string other = points(0).replace(18, 4, little(9.0F));
  const std::string cloud = ros1_cloud({2, 2, 18, 0}, other + points(0));
  expect_two_points(read(Encoding::ros1, cloud), 4);
}

TEST(PointCloud2, ARowStepOfAllTheDataIsNoPadding) {
  const std::string cloud = ros1_cloud({2, 2, 18, 72}, points(0) + points(0));
  expect_two_points(read(Encoding::ros1, cloud), 4);
}

TEST(PointCloud2, TheLastRowNeedsNoPaddingAndALoneRowIsNotCopied) {
  const std::string two = ros1_cloud({2, 2, 18, 40}, points(4) + points(0));
  expect_two_points(read(Encoding::ros1, two), 4);
  const std::string one = ros1_cloud({1, 2, 18, 40}, points(4));
  expect_two_points(read(Encoding::ros1, one));
  EXPECT_TRUE(read(Encoding::ros1, one).table.storage.empty());
}

TEST(PointCloud2, PointsThatAreNotThereAreRefused) {
  const auto refusal = [](const Rows& rows, const std::string& data, bool has_fields = true) {
    const std::string cloud = ros1_cloud(rows, data, has_fields);
    return test::message_of<ReadError>([&] { (void)read(Encoding::ros1, cloud); });
  };
  const std::string cut = points(0).substr(0, 35);
  EXPECT_EQ(refusal({1, 2, 18, 36}, cut), "1 x 2 points of 18 bytes do not fit into 35 bytes");
  EXPECT_EQ(refusal({3, 2, 18, 40}, points(4) + points(4) + cut),
            "3 x 2 points of 18 bytes do not fit into 72 bytes");
  EXPECT_EQ(refusal({1, 2, 0, 0}, points(0), false),
            "1 x 2 points of 0 bytes do not fit into 36 bytes");
}

TEST(PointCloud2, ACloudOfNoPointsMayBeOfNothing) {
  const std::string nothing = ros1_cloud({0, 0, 0, 0}, "", false);
  EXPECT_EQ(read(Encoding::ros1, nothing).table.size, 0U);
  EXPECT_EQ(read(Encoding::ros1, ros1_cloud({1, 0, 0, 0}, "")).table.size, 0U);
  const std::string fields = ros1_cloud({1, 0, 18, 0}, "");
  for (const Column& column : read(Encoding::ros1, fields).table.columns) {
    EXPECT_EQ(column.first, nullptr) << column.name;
  }
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

// The types end with 8, float64.
TEST(PointCloud2, AFieldOfADriversOwnTypeIsLeftOut) {
  for (const char type : {'\0', '\x09', '\xff'}) {
    std::string cloud = ros1_cloud();
    cloud[field_at(cloud, "time") + 4] = type;
    const CloudMessage found = read(Encoding::ros1, cloud);
    ASSERT_EQ(found.table.columns.size(), 4U);
    EXPECT_EQ(found.table.columns.back().name, "ring");
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

}  // namespace
}  // namespace surefoot::io
