// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// LAS of every version and point format, and files that say what is not so.
#include "io/files/las.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "io/files/las_writer.hpp"
#include "io/recording.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

constexpr std::array<std::size_t, 11> kRecord = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

template <typename T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(value));
}

/// Two points, written after the specification: (1, -2, 0.5) and (3.25, 4, -1) m, offset 100 0 0.
std::string las(int minor, unsigned format, double offset_x = 100.0) {
  const std::size_t header = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
  const std::size_t record = kRecord[format];
  std::string bytes(header + 2 * record, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = static_cast<char>(minor);
  put(bytes, 94, static_cast<std::uint16_t>(header));
  put(bytes, 96, static_cast<std::uint32_t>(header));
  bytes[104] = static_cast<char>(format);
  put(bytes, 105, static_cast<std::uint16_t>(record));
  if (minor >= 4 && format >= 6) {
    put(bytes, 247, std::uint64_t{2});
  } else {
    put(bytes, 107, std::uint32_t{2});
  }
  for (std::size_t axis = 0; axis < 3; ++axis) put(bytes, 131 + 8 * axis, 0.001);
  put(bytes, 155, offset_x);
  const std::array<std::array<std::int32_t, 3>, 2> points = {
      {{1000, -2000, 500}, {3250, 4000, -1000}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t at = header + i * record;
    for (std::size_t axis = 0; axis < 3; ++axis) put(bytes, at + 4 * axis, points[i][axis]);
    put(bytes, at + 12, static_cast<std::uint16_t>(7 + i));
    const bool timed = format != 0 && format != 2;
    if (timed) put(bytes, at + (format < 6 ? 20 : 22), 0.25 * static_cast<double>(i));
  }
  return bytes;
}

template <typename T>
T get(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

std::span<const std::byte> las_bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::vector<double> values(const PointTable& table, const char* name) {
  std::vector<double> result;
  const Column* column = table.find(name);
  if (column == nullptr) return result;
  for_each_value(*column, table.size,
                 [&](std::size_t, auto value) { result.push_back(static_cast<double>(value)); });
  return result;
}

TEST(Las, EveryVersionAndFormatIsRead) {
  for (int minor = 0; minor <= 4; ++minor) {
    for (unsigned format = 0; format < (minor < 4 ? 6U : 11U); ++format) {
      const std::string file = las(minor, format);
      const PointTable table = parse_las(las_bytes_of(file));
      ASSERT_EQ(table.size, 2U) << minor << " " << format;
      EXPECT_EQ(values(table, "x"), (std::vector<double>{101.0, 103.25}));
      EXPECT_EQ(values(table, "y"), (std::vector<double>{-2.0, 4.0}));
      EXPECT_EQ(values(table, "z"), (std::vector<double>{0.5, -1.0}));
      EXPECT_EQ(values(table, "intensity"), (std::vector<double>{7.0, 8.0}));
      const bool timed = format != 0 && format != 2;
      EXPECT_EQ(values(table, "time"),
                timed ? (std::vector<double>{0.0, 0.25}) : std::vector<double>{});
    }
  }
}

// A map's grid begins far away: floats would hold its points to half a metre.
TEST(Las, AGridsOffsetIsLeftOutAndSaid) {
  const std::string file = las(2, 1, 500'000.0);
  const PointTable table = parse_las(las_bytes_of(file));
  EXPECT_EQ(values(table, "x"), (std::vector<double>{1.0, 3.25}));
  EXPECT_NE(table.format.find("without the offset 500000 0 0 m"), std::string::npos)
      << table.format;
}

// Whoever writes the points anew is told, of every file where they differ.
TEST(Las, AGridsOffsetIsALoss) {
  const test::TemporaryFolder folder;
  folder.write("0.las", las(2, 1));
  folder.write("1.las", las(2, 1, 500'000.0));
  std::string other = las(2, 1, -20'000.5);
  put(other, 227, std::int32_t{1500});  // the same points would be a scan that was sent again
  folder.write("2.las", other);
  OpenOptions options;
  options.further_fields = true;
  const std::vector<ScanItem> items = test::read_all(folder.path(), options);
  ASSERT_EQ(items.size(), 3U);
  const auto told = [&](std::size_t scan, const std::string& text) {
    return std::any_of(
        items[scan].losses.begin(), items[scan].losses.end(),
        [&](const std::string& loss) { return loss.find(text) != std::string::npos; });
  };
  EXPECT_FALSE(told(0, "offset"));
  EXPECT_TRUE(told(1, "the offset of a file's grid"));
  EXPECT_EQ(items[1].losses, items[2].losses) << "of many files it is one";
}

std::string las_error_of(const std::string& file) {
  try {
    (void)parse_las(las_bytes_of(file));
  } catch (const ReadError& error) {
    return error.what();
  }
  return "taken";
}

TEST(Las, WhatIsNotSoIsRefusedWithAWord) {
  std::string file = las(2, 1);
  file[104] = static_cast<char>(1 | 0x80);
  EXPECT_NE(las_error_of(file).find("LAZ"), std::string::npos);
  file = las(2, 1);
  put(file, 107, std::uint32_t{0xffffffff});
  EXPECT_NE(las_error_of(file).find("4294967295 points"), std::string::npos) << las_error_of(file);
  file = las(4, 6);
  put(file, 247, ~std::uint64_t{0});
  EXPECT_NE(las_error_of(file).find("points of 30 bytes"), std::string::npos) << las_error_of(file);
  file = las(2, 1);
  put(file, 105, std::uint16_t{4});
  EXPECT_NE(las_error_of(file).find("at least 28"), std::string::npos) << las_error_of(file);
  file = las(2, 1);
  file[25] = 9;
  EXPECT_NE(las_error_of(file).find("1.9"), std::string::npos) << las_error_of(file);
  EXPECT_NE(las_error_of("LASF").find("no header"), std::string::npos);
  file = las(2, 1);
  put(file, 131, 0.0);
  EXPECT_NE(las_error_of(file).find("scale"), std::string::npos);
  file = las(3, 5);
  for (std::size_t size = 0; size < file.size(); size += 7) {
    EXPECT_NE(las_error_of(file.substr(0, size)), "taken") << size;
  }
}

TEST(Las, WhatIsWrittenIsReadBackToTheMillimetre) {
  const std::vector<Eigen::Vector3d> points = {
      {1.0004, -2.5, 0.25}, {-30.7, 4000.1236, 12.0}, {8.0, 0.0, -3.0}};
  const std::string file = format_las(points);
  const PointTable table = parse_las(las_bytes_of(file));
  ASSERT_EQ(table.size, 3U);
  EXPECT_EQ(file.size(), 375U + 3 * 20U);
  EXPECT_EQ(table.format, "LAS 1.4, point format 0");
  const std::array<const char*, 3> names = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> found = values(table, names[static_cast<std::size_t>(axis)]);
    double high = -1e9, low = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(found[i], points[i][axis], 0.000501);
      high = std::max(high, found[i]);  // as it is written, so that the box holds it
      low = std::min(low, found[i]);
    }
    const std::size_t at = 179 + 16 * static_cast<std::size_t>(axis);
    EXPECT_DOUBLE_EQ(get<double>(file, at), high);
    EXPECT_DOUBLE_EQ(get<double>(file, at + 8), low);
  }
  EXPECT_EQ(get<std::uint64_t>(file, 247), 3U);
  EXPECT_EQ(get<std::uint64_t>(file, 255), 3U);               // first returns
  EXPECT_EQ(static_cast<unsigned char>(file[375 + 14]), 9U);  // the first of one
}

/// A world with UTM coordinates keeps its digits; the reader leaves such an offset out.
TEST(Las, AMapFarFromItsOriginKeepsItsDigits) {
  const std::vector<Eigen::Vector3d> points = {{448'262.125, 5'412'040.25, 310.5},
                                               {448'263.375, 5'412'041.5, 311.0}};
  const std::string file = format_las(points);
  EXPECT_EQ(get<double>(file, 155), 448'262.0);
  EXPECT_EQ(get<double>(file, 163), 5'412'040.0);
  EXPECT_EQ(values(parse_las(las_bytes_of(file)), "x"), (std::vector<double>{0.125, 1.375}));
}

TEST(Las, WhatTheFormatCannotHoldIsNotWritten) {
  EXPECT_EQ(parse_las(las_bytes_of(format_las({}))).size, 0U);
  const std::vector<Eigen::Vector3d> nowhere = {{0.0, std::nan(""), 0.0}};
  EXPECT_THROW((void)format_las(nowhere), std::invalid_argument);
  const std::vector<Eigen::Vector3d> apart = {{0.0, 0.0, 0.0}, {3e6, 0.0, 0.0}};
  EXPECT_THROW((void)format_las(apart), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::io
