// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/file_writer.hpp"
#include "io/files/pcd_reader.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::bytes_of;
using test::little;

double value(const PointTable& table, const char* column, std::size_t point) {
  double result = std::nan("");
  const Column* found = table.find(column);
  EXPECT_NE(found, nullptr) << column;
  if (found != nullptr) {
    for_each_value(*found, table.size, [&](std::size_t i, auto v) {
      result = i == point ? static_cast<double>(v) : result;
    });
  }
  return result;
}

std::string header(const std::string& points, const std::string& data,
                   const std::string& fields = "x y z", const std::string& sizes = "4 4 4",
                   const std::string& types = "F F F") {
  return "VERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types + "\n" + points +
         "DATA " + data + "\n";
}

std::string pcd_error_of(const std::string& file) {
  try {
    (void)parse_pcd(bytes_of(file));
  } catch (const ReadError& error) {
    return error.what();
  }
  return "taken";
}

TEST(PcdAscii, AllTypesAndCounts) {
  const std::string file =
      "# .PCD v0.7\r\nVERSION 0.7\r\nFIELDS x y z a b c d e _ h\r\nSIZE 4 8 4 1 1 2 4 8 1 4\r\n"
      "TYPE F F F I U I U U U F\r\nCOUNT 1 1 1 1 1 1 1 1 3 2\r\nWIDTH 1\r\nHEIGHT 2\r\n"
      "VIEWPOINT 0 0 0 1 0 0 0\r\nPOINTS 2\r\nDATA ascii\r\n"
      "1.5 -2.25 +3 -128 255 -32768 4294967295 18446744073709551615 9 9 9 7 8\r\n"
      "\r\n  nan inf -1e-3 127 0 32767 0 1 x y z 5 6";
  const PointTable table = parse_pcd(bytes_of(file));
  ASSERT_EQ(table.size, 2U);
  EXPECT_EQ(table.find("_"), nullptr);
  EXPECT_EQ(value(table, "x", 0), 1.5);
  EXPECT_EQ(value(table, "y", 0), -2.25);
  EXPECT_EQ(value(table, "z", 0), 3.0);
  EXPECT_EQ(value(table, "a", 0), -128.0);
  EXPECT_EQ(value(table, "b", 0), 255.0);
  EXPECT_EQ(value(table, "c", 1), 32767.0);
  EXPECT_EQ(value(table, "d", 0), 4294967295.0);
  EXPECT_EQ(value(table, "e", 0), 18446744073709551615.0);
  EXPECT_EQ(value(table, "h", 0), 7.0);
  EXPECT_EQ(value(table, "h", 1), 5.0);
  EXPECT_TRUE(std::isnan(value(table, "x", 1)));
  EXPECT_TRUE(std::isinf(value(table, "y", 1)));
  EXPECT_EQ(static_cast<float>(value(table, "z", 1)), -1e-3F);
}

// As PCL once wrote bytes: as the characters that they are, a space and a NUL among them.
TEST(PcdAscii, BytesMayBeCharacters) {
  const std::string file =
      header("WIDTH 3\nHEIGHT 1\nPOINTS 3\n", "ascii", "x y z tag line", "4 4 4 1 1", "F F F U U") +
      "1 2 3 16 4\n" + "1.5 -2 3 \x10 " + std::string(1, '\0') + "\n" + "4 5 6   \x05\r\n";
  const PointTable table = parse_pcd(bytes_of(file));
  ASSERT_EQ(table.size, 3U);
  EXPECT_EQ(value(table, "tag", 0), 16.0);
  EXPECT_EQ(value(table, "line", 0), 4.0);
  EXPECT_EQ(value(table, "z", 1), 3.0);
  EXPECT_EQ(value(table, "tag", 1), 16.0);
  EXPECT_EQ(value(table, "line", 1), 0.0);
  EXPECT_EQ(value(table, "tag", 2), 32.0);
  EXPECT_EQ(value(table, "line", 2), 5.0);
  // A word is none of them, and neither is a character where a coordinate is expected.
  const auto of_line = [](const std::string& line) {
    return pcd_error_of(header("WIDTH 1\n", "ascii", "x y z tag", "4 4 4 1", "F F F U") + line);
  };
  EXPECT_NE(of_line("1 2 3 ab\n").find("field 'tag' is 'ab'"), std::string::npos);
  EXPECT_NE(of_line("1 2 3 \x10 \x11\n").find("field 'tag' is '\\x10'"), std::string::npos);
  EXPECT_NE(of_line("1 2 \x10 4\n").find("field 'z' is '\\x10'"), std::string::npos);
}

// Of a cloud that is no grid some writers say so, and how many points it has.
TEST(PcdAscii, PointsServeWhereTheGridIsEmpty) {
  const std::string file =
      header("WIDTH 0\nHEIGHT 0\nPOINTS 2\n", "ascii", "x y z", "4 4 4", "F F F") +
      "1 2 3\n4 5 6\n";
  EXPECT_EQ(parse_pcd(bytes_of(file)).size, 2U);
}

// Two points with padding, an organised cloud and no COUNT line.
TEST(PcdBinary, PaddingOrganisedAndMissingCount) {
  std::string file =
      header("WIDTH 1\nHEIGHT 2\n", "binary", "x _ y z ring", "4 2 8 4 2", "F U F F U");
  for (int i = 0; i < 2; ++i) {
    file += little(1.0F + float(i)) + "??" + little(2.0 + i) + little(3.0F) +
            little(static_cast<std::uint16_t>(60000 + i));
  }
  const PointTable table = parse_pcd(bytes_of(file));
  ASSERT_EQ(table.size, 2U);
  EXPECT_EQ(value(table, "x", 1), 2.0);
  EXPECT_EQ(value(table, "y", 1), 3.0);
  EXPECT_EQ(value(table, "z", 0), 3.0);
  EXPECT_EQ(value(table, "ring", 1), 60001.0);
  EXPECT_EQ(table.layout(), "PCD binary: x f32, y f64, z f32, ring u16");
}

// LZF of literals alone, written out by hand: a byte n-1 (n <= 32), then n bytes as they are.
std::string lzf_literals(const std::string& plain) {
  std::string packed;
  for (std::size_t at = 0; at < plain.size(); at += 32) {
    const std::string run = plain.substr(at, 32);
    packed += static_cast<char>(run.size() - 1) + run;
  }
  return packed;
}

TEST(PcdCompressed, FieldAfterField) {
  std::string plain;
  for (const float v : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) {
    plain += little(v);  // x x y y z z
  }
  plain += "ab" + little(std::uint16_t{7}) + little(std::uint16_t{8});
  const std::string packed = lzf_literals(plain);
  const std::string file =
      header("WIDTH 2\n", "binary_compressed", "x y z _ ring", "4 4 4 1 2", "F F F U U") +
      little(static_cast<std::uint32_t>(packed.size())) +
      little(static_cast<std::uint32_t>(plain.size())) + packed;
  const PointTable table = parse_pcd(bytes_of(file));
  ASSERT_EQ(table.size, 2U);
  EXPECT_EQ(value(table, "x", 1), 2.0);
  EXPECT_EQ(value(table, "y", 0), 3.0);
  EXPECT_EQ(value(table, "z", 1), 6.0);
  EXPECT_EQ(value(table, "ring", 0), 7.0);
  EXPECT_EQ(value(table, "ring", 1), 8.0);
}

// A megabyte that says it becomes a hundred: no sweep compresses so.
TEST(PcdCompressed, SizesBeyondWhatPointsCompressToAreRefused) {
  const auto file = [](std::uint32_t plain, const std::string& types, const std::string& sizes) {
    return header("WIDTH " + std::to_string(plain / 12) + "\n", "binary_compressed", "x y z", sizes,
                  types) +
           little(std::uint32_t{1'000'000}) + little(plain) + std::string(1'000'000, '\0');
  };
  EXPECT_NE(pcd_error_of(file(96'000'000, "F F F", "4 4 4")).find("at most 32 times"),
            std::string::npos);
  // And coordinates of one byte would become twelve times as large.
  EXPECT_NE(pcd_error_of(file(3'000'000, "U U U", "1 1 1")).find("x is u8"), std::string::npos);
}

TEST(Pcd, AHeaderOfMoreFieldsThanAnyDriverWritesIsRefused) {
  std::string names, sizes, types;
  for (int i = 0; i < 1100; ++i) {
    names += "f ";
    sizes += "1 ";
    types += "U ";
  }
  const std::string many = header("WIDTH 1\n", "binary", names, sizes, types);
  EXPECT_NE(pcd_error_of(many).find("1100 FIELDS; expected at most 1000"), std::string::npos)
      << pcd_error_of(many);
  const std::string longer =
      header("WIDTH 1\n", "binary", "x y z " + std::string(200'000, '_'), "4 4 4", "F F F");
  EXPECT_NE(pcd_error_of(longer).find("characters"), std::string::npos);
}

TEST(Pcd, EveryTruncationOfEveryFlavourIsAnError) {
  Scan scan;
  for (int i = 0; i < 20; ++i) {
    scan.points.emplace_back(1.0F * float(i), -0.5F, 2.25F);
    scan.times_ns.push_back(i * 1'000'000);
    scan.rings.push_back(static_cast<std::uint16_t>(i % 16));
  }
  for (const PcdData flavour : {PcdData::ascii, PcdData::binary, PcdData::binary_compressed}) {
    const std::string file = format_pcd(scan, flavour);
    // The last ascii line may lose its newline and, by a digit, stay a number.
    const std::size_t spare = flavour == PcdData::ascii ? 2 : 0;
    for (std::size_t size = 0; size + spare < file.size(); ++size) {
      EXPECT_THROW((void)parse_pcd(bytes_of(std::string_view(file).substr(0, size))), ReadError)
          << size;
    }
    EXPECT_EQ(parse_pcd(bytes_of(file)).size, 20U);
  }
}

TEST(Pcd, NonsenseIsAnErrorThatSaysWhatWasSeen) {
  const std::string huge = "18446744073709551615";
  const std::string point(12, '\0');
  const std::string sizes = little(std::uint32_t{12});
  const std::vector<std::string> files = {
      "",
      "\n",
      "PCD?",
      std::string(1000, '\0'),
      "DATA ascii\n",
      "FIELDS x y z\nSIZE 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3\n",
      header("", "binary") + point,
      header("WIDTH 1\n", "binary_zipped") + point,
      header("WIDTH 1\n", "") + point,
      header("WIDTH -1\n", "binary") + point,
      header("WIDTH 1.5\n", "binary") + point,
      header("WIDTH 1 2\n", "binary") + point,
      header("WIDTH 2\n", "binary") + point,
      header("WIDTH 4294967296\nHEIGHT 1\n", "binary") + point,
      header("WIDTH 4294967296\nHEIGHT 4294967296\n", "binary") + point,
      header("WIDTH " + huge + "\nHEIGHT " + huge + "\n", "binary") + point,
      header("WIDTH " + huge + "\n", "ascii") + "1 2 3\n",
      header("WIDTH " + huge + "0\n", "ascii") + "1 2 3\n",
      header("POINTS 4294967295\n", "binary_compressed") + sizes + sizes + point,
      header("WIDTH 1\nPOINTS 2\n", "binary") + point + point,
      header("WIDTH 1\nCOUNT 1 1 0\n", "binary") + point,
      header("WIDTH 1\nCOUNT 1 1 " + huge + "\n", "binary") + point,
      header("WIDTH 0\nCOUNT " + huge + " " + huge + " " + huge + "\n", "ascii"),
      header("WIDTH 1\nCOUNT 1 1\n", "binary") + point,
      header("WIDTH 1\nCOUNT 1 -1 1\n", "binary") + point,
      header("WIDTH 1\n", "binary", "x y z", "4 4 3") + point,
      header("WIDTH 1\n", "binary", "x y z", "4 4 4294967295") + point,
      header("WIDTH 1\n", "binary", "x y z", "4 4 4", "F F Q") + point,
      header("WIDTH 1\n", "binary", "x y z", "4 4 4", "F F FF") + point,
      header("WIDTH 1\n", "binary", "x y z", "4 4 2", "F F F") + point,
      header("WIDTH 1\n", "ascii") + "1 2\n",
      header("WIDTH 1\n", "ascii") + "1 2 3 4\n",
      header("WIDTH 1\n", "ascii") + "1 2 three\n",
      header("WIDTH 1\n", "ascii") + "1 2 0x10\n",
      header("WIDTH 2\n", "ascii") + "1 2 3\n",
      header("WIDTH 1\n", "ascii", "x y z", "4 4 1", "F F U") + "1 2 256\n",
      header("WIDTH 1\n", "ascii", "x y z", "4 4 1", "F F U") + "1 2 -1\n",
      header("WIDTH 1\n", "binary_compressed"),
      header("WIDTH 1\n", "binary_compressed") + sizes,
      header("WIDTH 1\n", "binary_compressed") + sizes + sizes,
      header("WIDTH 1\n", "binary_compressed") + sizes + sizes + std::string(12, '\xff'),
      header("WIDTH 1\n", "binary_compressed") + sizes + little(0xffffffffU) + point,
      header("WIDTH 1\n", "binary_compressed") + little(0xffffffffU) + sizes + point,
      header("WIDTH 1\n", "binary_compressed") + sizes + little(std::uint32_t{11}) + point,
  };
  for (const std::string& file : files) {
    const std::string message =
        test::message_of<ReadError>([&] { (void)parse_pcd(bytes_of(file)); });
    EXPECT_TRUE(message.starts_with("PCD")) << file << "\n-> " << message;
  }
}

TEST(Pcd, ErrorsNameTheLine) {
  const std::string message = test::message_of<ReadError>(
      [] { (void)parse_pcd(bytes_of(header("WIDTH 2\n", "ascii") + "1 2 3\n1 2 oops\n")); });
  EXPECT_NE(message.find("line 8"), std::string::npos) << message;
  EXPECT_NE(message.find("'oops'"), std::string::npos) << message;
  const std::string few = test::message_of<ReadError>(
      [] { (void)parse_pcd(bytes_of(header("WIDTH 3\n", "ascii") + "1 2 3\n4 5 6\n")); });
  EXPECT_NE(few.find("2 points in the file; the header says 3"), std::string::npos) << few;
}

TEST(PcdWriter, EveryFlavourReadsBackToTheBit) {
  Scan scan;
  for (int i = 0; i < 5000; ++i) {
    const auto t = static_cast<float>(i);
    scan.points.emplace_back(std::sin(t), t / 7.0F, -1e-30F * t);
    scan.intensities.push_back(0.1F * t);
    scan.times_ns.push_back(i - 2500);
    scan.rings.push_back(static_cast<std::uint16_t>(i));
  }
  scan.points[7].x() = std::numeric_limits<float>::quiet_NaN();
  scan.points[8].y() = -std::numeric_limits<float>::infinity();
  for (const PcdData flavour : {PcdData::ascii, PcdData::binary, PcdData::binary_compressed}) {
    const std::string file = format_pcd(scan, flavour);
    const PointTable table = parse_pcd(bytes_of(file));
    ASSERT_EQ(table.size, scan.points.size());
    for_each_value(*table.find("x"), table.size, [&](std::size_t i, auto v) {
      ASSERT_TRUE(i == 7 ? std::isnan(double(v)) : double(v) == double(scan.points[i].x())) << i;
    });
    for_each_value(*table.find("y"), table.size, [&](std::size_t i, auto v) {
      ASSERT_EQ(double(v), double(scan.points[i].y()));
    });
    for_each_value(*table.find("t"), table.size,
                   [&](std::size_t i, auto v) { ASSERT_EQ(double(v), double(scan.times_ns[i])); });
    for_each_value(*table.find("ring"), table.size,
                   [&](std::size_t i, auto v) { ASSERT_EQ(double(v), double(scan.rings[i])); });
    for_each_value(*table.find("intensity"), table.size, [&](std::size_t i, auto v) {
      ASSERT_EQ(double(v), double(scan.intensities[i]));
    });
  }
}

TEST(PcdWriter, EmptyScanAndUnequalArrays) {
  for (const PcdData flavour : {PcdData::ascii, PcdData::binary, PcdData::binary_compressed}) {
    EXPECT_EQ(parse_pcd(bytes_of(format_pcd({}, flavour))).size, 0U);
  }
  Scan scan;
  scan.points.resize(2);
  scan.rings.resize(1);
  EXPECT_THROW((void)format_pcd(scan, PcdData::binary), std::invalid_argument);
  EXPECT_THROW(write_pcd("/nonexistent/folder/scan.pcd", {}), WriteError);
}

}  // namespace
}  // namespace surefoot::io
