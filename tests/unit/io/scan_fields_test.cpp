// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Fields that a scan has no room for, carried from one format to another.
#include <gtest/gtest.h>

#include "io/scan_fields.hpp"
#include "io/scan_sink.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

using test::little;
using test::read_all;
using test::TemporaryFolder;

constexpr int kPoints = 300;

template <typename T>
FurtherField field(const std::string& name, ScalarType type, std::size_t count = 1) {
  std::string bytes;
  for (std::size_t i = 0; i < kPoints * count; ++i) {
    bytes += little(static_cast<T>(static_cast<T>(7) * static_cast<T>(i) - static_cast<T>(3)));
  }
  const auto values = test::bytes_of(bytes);
  return {name, type, count, {values.begin(), values.end()}};
}

Scan scan_with_times() {
  Scan scan;
  scan.stamp_ns = 5'000'000'000;
  for (int i = 0; i < kPoints; ++i) {
    scan.points.emplace_back(1.0F + static_cast<float>(i), -2.0F, 0.25F);
    scan.times_ns.push_back(i * 300'000);
    scan.rings.push_back(static_cast<std::uint16_t>(i % 16));
  }
  return scan;
}

std::vector<FurtherField> all_types() {
  return {
      field<std::int8_t>("tag", ScalarType::i8),     field<std::uint8_t>("label", ScalarType::u8),
      field<std::int16_t>("depth", ScalarType::i16), field<std::uint16_t>("range", ScalarType::u16),
      field<std::int32_t>("a", ScalarType::i32),     field<std::uint32_t>("rgba", ScalarType::u32),
      field<float>("curve", ScalarType::f32),        field<double>("precise", ScalarType::f64)};
}

// The fields of the second of two scans, read from what a sink wrote.
std::vector<FurtherField> through(ScanFormat format, const std::vector<FurtherField>& fields,
                                  std::string* lost = nullptr) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / (format == ScanFormat::mcap       ? "a.mcap"
                                                      : format == ScanFormat::ros1_bag ? "a.bag"
                                                                                       : "folder");
  const auto sink = make_scan_sink(path, format);
  Scan scan = scan_with_times();
  sink->add(scan);
  scan.stamp_ns += 100'000'000;
  sink->add(scan, fields);
  sink->finish();
  if (lost != nullptr) *lost = sink->lost();
  OpenOptions options;
  options.further_fields = true;
  const std::vector<ScanItem> items = read_all(path, options);
  EXPECT_EQ(items.size(), 2U);
  EXPECT_TRUE(items[0].further.empty());
  EXPECT_EQ(items[1].scan->points, scan.points);
  if (format != ScanFormat::kitti_bin) {
    EXPECT_EQ(items[1].scan->times_ns, scan.times_ns);
    EXPECT_EQ(items[1].scan->rings, scan.rings);
  }
  return items[1].further;
}

void expect_same(const std::vector<FurtherField>& fields, const std::vector<FurtherField>& others) {
  ASSERT_EQ(fields.size(), others.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    EXPECT_EQ(fields[i].name, others[i].name);
    EXPECT_EQ(fields[i].type, others[i].type) << fields[i].name;
    EXPECT_EQ(fields[i].count, others[i].count) << fields[i].name;
    EXPECT_EQ(fields[i].values, others[i].values) << fields[i].name;
  }
}

TEST(ScanFields, EveryTypeGoesThroughEveryFormat) {
  for (const ScanFormat format : {ScanFormat::pcd, ScanFormat::ply, ScanFormat::mcap,
                                  ScanFormat::rosbag2, ScanFormat::ros1_bag}) {
    SCOPED_TRACE(scan_format_names()[static_cast<std::size_t>(format)]);
    std::string lost = "not told";
    expect_same(through(format, all_types(), &lost), all_types());
    EXPECT_EQ(lost, "");
  }
}

TEST(ScanFields, WhatAFormatDoesNotHoldIsNamed) {
  const std::vector<FurtherField> fields = {field<std::uint64_t>("id", ScalarType::u64),
                                            field<float>("normal", ScalarType::f32, 3),
                                            field<std::uint8_t>("tag", ScalarType::u8)};
  std::string lost;
  expect_same(through(ScanFormat::pcd, fields, &lost), fields);
  EXPECT_EQ(lost, "");
  expect_same(through(ScanFormat::mcap, fields, &lost), {fields[1], fields[2]});
  EXPECT_EQ(lost, "id");
  expect_same(through(ScanFormat::ply, fields, &lost), {fields[2]});
  EXPECT_EQ(lost, "id, normal");
  expect_same(through(ScanFormat::kitti_bin, fields, &lost), {});
  EXPECT_EQ(lost, "id, normal, ring, t, tag");
}

TEST(ScanFields, NamesBecomeWordsThatDiffer) {
  const std::vector<FurtherField> fields = {
      field<float>("t", ScalarType::f32), field<float>("two words", ScalarType::f32),
      field<float>("two\nwords", ScalarType::f32), field<float>("_", ScalarType::f32),
      field<float>("", ScalarType::f32)};
  std::vector<FurtherField> expected = fields;
  const char* const names[] = {"t_2", "two_words", "two_words_2", "field", "field_2"};
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i].name = names[i];
  expect_same(through(ScanFormat::pcd, fields), expected);
}

// Of the point that has no time, and of the one whose bytes are in the other order.
TEST(ScanFields, FollowTheirPoints) {
  const TemporaryFolder folder;
  std::string rows;
  for (int i = 0; i < kPoints; ++i) {
    const float time = i == 7 ? std::numeric_limits<float>::quiet_NaN() : 0.0003F * float(i);
    rows += test::big(1.0F) + test::big(2.0F) + test::big(3.0F) + test::big(time) +
            test::big(std::uint16_t(1000 + i));
  }
  folder.write("a.ply",
               "ply\nformat binary_big_endian 1.0\nelement vertex " + std::to_string(kPoints) +
                   "\nproperty float x\nproperty float y\nproperty float z\nproperty float time\n"
                   "property ushort ambient\nend_header\n" +
                   rows);
  OpenOptions options;
  EXPECT_TRUE(read_all(folder.path(), options).front().further.empty());
  options.further_fields = true;
  const std::vector<ScanItem> items = read_all(folder.path(), options);
  ASSERT_EQ(items.front().further.size(), 1U);
  std::string expected;
  for (int i = 0; i < kPoints; ++i) expected += i == 7 ? "" : little(std::uint16_t(1000 + i));
  const std::vector<std::byte>& values = items.front().further.front().values;
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(values.data()), values.size()), expected);
}

// A header of a thousand names for the same bytes takes no more than the points do.
TEST(ScanFields, ThatShareBytesAreOne) {
  PointTable table;
  table.storage.resize(4 * kPoints);
  table.size = kPoints;
  for (int i = 0; i < 1000; ++i) {
    table.columns.push_back({"f", ScalarType::u8, table.storage.data() + i % 4, 4});
  }
  EXPECT_EQ(further_fields(table, {}, {}).size(), 4U);
}

// Their columns look nowhere.
TEST(ScanFields, OfNoPointsAreAllThere) {
  PointTable table;
  for (const char* name : {"a", "b"}) table.columns.push_back({name, ScalarType::f32, nullptr, 8});
  const std::vector<FurtherField> fields = further_fields(table, {}, {});
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_TRUE(fields[1].values.empty());
}

}  // namespace
}  // namespace surefoot::io
