// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Fields that a scan has no room for, carried from one format to another.
#include <gtest/gtest.h>

#include <functional>

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

// A scan of two hundred points whose fields are given as PCD has them; `value` of point i.
struct PcdField {
  const char* name;
  const char* type;  // "F 8"
  std::size_t count;
  std::function<double(int)> value;
};
ScanItem item_of(const std::vector<PcdField>& fields, OpenOptions options = {}) {
  const TemporaryFolder folder;
  std::string names = "FIELDS x y z", sizes = "SIZE 4 4 4", types = "TYPE F F F",
              counts = "COUNT 1 1 1", rows;
  for (const PcdField& field : fields) {
    names += std::string(" ") + field.name;
    types += std::string(" ") + field.type[0];
    sizes += std::string(" ") + field.type[2];
    counts += " " + std::to_string(field.count);
  }
  for (int i = 0; i < 200; ++i) {
    rows += "1 2 " + std::to_string(i);
    for (const PcdField& field : fields) {
      for (std::size_t k = 0; k < field.count; ++k) {
        char text[40];
        std::snprintf(text, sizeof(text), " %.17g", field.value(i));
        rows += text;
      }
    }
    rows += '\n';
  }
  folder.write("a.pcd", "VERSION .7\n" + names + "\n" + sizes + "\n" + types + "\n" + counts +
                            "\nWIDTH 200\nHEIGHT 1\nPOINTS 200\nDATA ascii\n" + rows);
  options.further_fields = true;
  return read_all(folder.path(), options).front();
}
std::string losses_of(const std::vector<PcdField>& fields, const OpenOptions& options = {}) {
  std::string text;
  for (const std::string& loss : item_of(fields, options).losses) text += loss + '\n';
  return text;
}

TEST(ScanFields, WhatNeitherTheScanNorItsFieldsHoldIsSaid) {
  const auto tenth = [](int i) { return 0.1 * i; };
  const auto whole = [](int i) { return i; };
  const auto high = [](int i) { return i + 65'500.0; };
  const auto nan = [](int) { return std::numeric_limits<double>::quiet_NaN(); };
  const auto time = [](int i) { return 0.0005 * i; };
  EXPECT_EQ(losses_of({{"intensity", "F 8", 1, whole}, {"ring", "U 4", 1, whole}}), "");
  EXPECT_EQ(losses_of({{"intensity", "F 8", 1, tenth}}),
            "field 'intensity' (f64) becomes a float, which rounds it\n");
  EXPECT_EQ(losses_of({{"ring", "U 4", 1, high}}),
            "field 'ring' (u32) becomes a whole number from 0 to 65535, the nearest where it is "
            "none\n");
  EXPECT_EQ(losses_of({{"intensity", "F 4", 2, tenth}}),
            "field 'intensity' (f32) has 2 numbers a point: the first one stays\n");
  EXPECT_EQ(losses_of({{"t", "F 4", 1, nan}}),
            "field 't' (f32) is left out: its times are not used\n");
  EXPECT_EQ(losses_of({{"t", "F 4", 1, time}}), "");
}

// Times that are left out do not come back by another field.
TEST(ScanFields, ASecondFieldOfTimesIsLeftOutWithTheFirst) {
  const auto time = [](int i) { return 0.0005 * i; };
  const auto milliseconds = [](int i) { return 0.5 * i; };
  const std::vector<PcdField> fields = {{"t", "F 4", 1, time},
                                        {"stamp", "F 4", 1, time},
                                        {"curvature", "F 4", 1, milliseconds},
                                        {"depth", "F 4", 1, time}};
  EXPECT_EQ(item_of(fields).further.size(), 3U);
  OpenOptions options;
  options.time_direction = TimeDirection::none;
  const ScanItem item = item_of(fields, options);
  ASSERT_EQ(item.further.size(), 1U);
  EXPECT_EQ(item.further[0].name, "depth");
  EXPECT_EQ(item.losses.size(), 3U);
}

TEST(ScanFields, OfFieldsThatShareBytesTheSecondIsNamed) {
  const std::string bytes(kPoints * 4, '\1');
  PointTable table;
  table.size = kPoints;
  const std::byte* const first = test::bytes_of(bytes).data();
  table.columns = {{"all", ScalarType::u32, first, 4}, {"low", ScalarType::u16, first, 4}};
  std::vector<std::string> left_out;
  EXPECT_EQ(further_fields(table, {}, {}, &left_out).size(), 1U);
  EXPECT_EQ(left_out, std::vector<std::string>{"low"});
}

// Our own reader takes no larger one.
TEST(ScanSink, AScanWithoutPointsHasTheFieldsOfTheOthers) {
  for (const ScanFormat format : {ScanFormat::pcd, ScanFormat::ply, ScanFormat::rosbag2}) {
    const TemporaryFolder folder;
    const auto sink = make_scan_sink(folder.path() / "out", format);
    Scan scan = scan_with_times();
    const std::vector<FurtherField> fields = {field<float>("curve", ScalarType::f32)};
    sink->add(scan, fields);
    Scan empty;
    empty.stamp_ns = scan.stamp_ns + 100'000'000;
    sink->add(empty);
    scan.stamp_ns += 200'000'000;
    sink->add(scan, fields);
    sink->finish();
    const std::vector<ScanItem> items = read_all(folder.path() / "out");
    ASSERT_EQ(items.size(), 3U);
    EXPECT_EQ(items[1].layout, items[0].layout);
    ASSERT_TRUE(items[1].scan);
    EXPECT_TRUE(items[1].scan->points.empty());
  }
  const TemporaryFolder folder;
  const auto sink = make_scan_sink(folder.path() / "out", ScanFormat::kitti_bin);
  EXPECT_NE(sink->refusal({}).find("no points"), std::string::npos);
  EXPECT_EQ(sink->refusal(scan_with_times()), "");
}

TEST(ScanSink, AMessageThatNobodyReadsIsRefused) {
  const TemporaryFolder folder;
  constexpr std::size_t kMany = 1'000'000;
  Scan scan;
  scan.points.assign(kMany, {1.0F, 2.0F, 3.0F});
  std::vector<FurtherField> fields = {
      {"all", ScalarType::u8, 250, std::vector<std::byte>(kMany * 250)}};
  const auto bag = make_scan_sink(folder.path() / "a.mcap", ScanFormat::mcap);
  EXPECT_EQ(bag->refusal(scan, fields), "");
  fields.push_back({"more", ScalarType::u8, 8, std::vector<std::byte>(kMany * 8)});
  EXPECT_NE(bag->refusal(scan, fields).find("readers take at most 256 MiB"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::io
