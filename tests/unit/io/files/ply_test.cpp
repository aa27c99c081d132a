// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <vector>

#include "io/files/ply_reader.hpp"
#include "io/files/ply_writer.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::bytes_of;

std::vector<double> column(const PointTable& table, const char* name) {
  std::vector<double> values;
  const Column* found = table.find(name);
  EXPECT_NE(found, nullptr) << name;
  if (found != nullptr) {
    for_each_value(*found, table.size,
                   [&](std::size_t, auto v) { values.push_back(static_cast<double>(v)); });
  }
  return values;
}

// Elements and lists before the vertices, properties in any order, lists within a vertex.
const std::string kElements =
    "comment made by hand\nobj_info x\nelement camera 2\nproperty int id\nproperty list uchar "
    "short tags\nelement empty 3\nelement vertex 2\nproperty double z\nproperty uchar "
    "red\nproperty "
    "list ushort float extras\nproperty float y\nproperty int16 x\nproperty uint t\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

template <typename Number>
std::string binary_ply(const char* format, Number&& number) {
  std::string file = std::string("ply\nformat ") + format + " 1.0\n" + kElements;
  file += number(std::int32_t{5}) + number(std::uint8_t{2}) + number(std::int16_t{1}) +
          number(std::int16_t{2});
  file += number(std::int32_t{6}) + number(std::uint8_t{0});
  file += number(3.5) + number(std::uint8_t{200}) + number(std::uint16_t{1}) + number(9.0F) +
          number(-2.5F) + number(std::int16_t{-300}) + number(std::uint32_t{4000000000U});
  file += number(-1e100) + number(std::uint8_t{0}) + number(std::uint16_t{0}) + number(0.25F) +
          number(std::int16_t{7}) + number(std::uint32_t{1});
  return file + number(std::uint8_t{1}) + number(std::int32_t{0});
}

void check_elements(const PointTable& table) {
  ASSERT_EQ(table.size, 2U);
  EXPECT_EQ(column(table, "x"), (std::vector<double>{-300, 7}));
  EXPECT_EQ(column(table, "y"), (std::vector<double>{-2.5, 0.25}));
  EXPECT_EQ(column(table, "z"), (std::vector<double>{3.5, -1e100}));
  EXPECT_EQ(column(table, "t"), (std::vector<double>{4000000000.0, 1}));
  EXPECT_EQ(table.find("extras"), nullptr);
}

TEST(Ply, AsciiAndBothBinariesAgree) {
  const std::string ascii = "ply\r\nformat ascii 1.0\r\n" + kElements +
                            "5 2 1 2\n6 0\n3.5 200 1 9 -2.5 -300 4000000000\n\n"
                            "-1e100 0 0 0.25 7 1\n1 0\n";
  check_elements(parse_ply(bytes_of(ascii)));
  check_elements(parse_ply(
      bytes_of(binary_ply("binary_little_endian", [](auto v) { return test::little(v); }))));
  check_elements(
      parse_ply(bytes_of(binary_ply("binary_big_endian", [](auto v) { return test::big(v); }))));
}

TEST(Ply, FixedSizeVerticesOfBothEndians) {
  const std::string head =
      " 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  const PointTable little =
      parse_ply(bytes_of("ply\nformat binary_little_endian" + head + test::little(1.5F) +
                         test::little(2.5F) + test::little(3.5F)));
  // The table looks into the bytes, so that they must live on.
  const std::string file =
      "ply\nformat binary_big_endian" + head + test::big(1.5F) + test::big(2.5F) + test::big(3.5F);
  const PointTable big = parse_ply(bytes_of(file));
  EXPECT_EQ(column(big, "y"), std::vector<double>{2.5});
  EXPECT_EQ(big.layout(), "PLY binary_big_endian: x f32, y f32, z f32");
  EXPECT_EQ(little.size, 1U);
}

TEST(Ply, EveryTruncationIsAnError) {
  const std::string file =
      binary_ply("binary_little_endian", [](auto v) { return test::little(v); });
  constexpr std::size_t kFaces = 5;  // behind the vertices, not read
  for (std::size_t size = 0; size + kFaces < file.size(); ++size) {
    EXPECT_THROW((void)parse_ply(bytes_of(std::string_view(file).substr(0, size))), ReadError)
        << size;
  }
}

TEST(Ply, NonsenseIsAnError) {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string little = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
  const std::vector<std::string> files = {
      "",
      "plx\n",
      "ply\n",
      "ply\nend_header\n",
      std::string(500, '\xff'),
      "ply\nformat ascii 2.0\nend_header\n",
      "ply\nformat binary_middle_endian 1.0\nend_header\n",
      head + "end_header\n",
      head + "element face 0\nproperty float x\nend_header\n",
      head + "property float x\n",
      head + "element vertex\n" + xyz,
      head + "element vertex -1\n" + xyz,
      head + "element vertex 1e3\n" + xyz,
      head + "element vertex 99999999999999999999\n" + xyz,
      head + "element vertex 18446744073709551615\n" + xyz + "1 2 3\n",
      head + "element vertex 1\nend_header\n",
      head + "element vertex 1\nproperty list uchar float x\nend_header\n1 2\n",
      head + "element vertex 1\nproperty quad x\nend_header\n1\n",
      head + "element vertex 1\nproperty float\nend_header\n1\n",
      head + "element vertex 1\nproperty list float int x\nproperty float y\nend_header\n1\n",
      head + "element vertex 1\n" + xyz + "1 2\n",
      head + "element vertex 1\n" + xyz + "1 2 x\n",
      head + "element vertex 2\n" + xyz + "1 2 3\n",
      head + "nonsense\n",
      little + "element vertex 18446744073709551615\n" + xyz + std::string(12, 'a'),
      little + "element vertex 2\n" + xyz + std::string(12, 'a'),
      // Lists that claim more than there is, or less than nothing.
      little + "element a 1\nproperty list uint double b\nelement vertex 0\n" + xyz +
          test::little(0xffffffffU),
      little + "element a 1\nproperty list int double b\nelement vertex 0\n" + xyz +
          test::little(-1),
      little + "element a 1\nproperty list ulong double b\nelement vertex 0\n" + xyz +
          test::little(~std::uint64_t{0}),
      little + "element a 18446744073709551615\nproperty list uchar double b\nelement vertex 0\n" +
          xyz + std::string(100, '\0'),
      head +
          "element a 1\nproperty list int int b\nelement vertex 1\nproperty list uint int "
          "l\nproperty float x\nend_header\n0\n4294967295 1\n",
  };
  for (const std::string& file : files) {
    const std::string message =
        test::message_of<ReadError>([&] { (void)parse_ply(bytes_of(file)); });
    EXPECT_TRUE(message.starts_with("PLY")) << file << "\n-> " << message;
  }
}

// An element without properties takes no bytes, however many there are said to be.
TEST(Ply, EmptyElementsCostNothing) {
  for (const char* format : {"ascii", "binary_big_endian"}) {
    const std::string file = std::string("ply\nformat ") + format +
                             " 1.0\nelement a 18446744073709551615\nelement vertex 0\n"
                             "property float x\nend_header\n";
    EXPECT_EQ(parse_ply(bytes_of(file)).size, 0U);
  }
}

TEST(PlyWriter, ReadsBackToTheBit) {
  const std::vector<Eigen::Vector3f> points = {{1.1F, -2.2F, 3e-20F}, {0, 1e20F, -0.0F}};
  const std::vector<float> intensities = {0.3F, 255.0F};
  for (const PlyFlavour flavour : {PlyFlavour::ascii, PlyFlavour::binary}) {
    const std::string file = format_ply(points, intensities, flavour);
    const PointTable table = parse_ply(bytes_of(file));
    EXPECT_EQ(column(table, "x"), (std::vector<double>{1.1F, 0}));
    EXPECT_EQ(column(table, "y"), (std::vector<double>{-2.2F, 1e20F}));
    EXPECT_EQ(column(table, "z"), (std::vector<double>{3e-20F, 0}));
    EXPECT_EQ(column(table, "intensity"), (std::vector<double>{0.3F, 255}));
    const std::string bare = format_ply(points, std::span<const float>(), flavour);
    EXPECT_EQ(parse_ply(bytes_of(bare)).columns.size(), 3U);
  }
  EXPECT_THROW((void)format_ply(points, std::span(intensities).first(1), PlyFlavour::ascii),
               std::invalid_argument);
}

TEST(PlyWriter, WritesAnyColumns) {
  const std::vector<Eigen::Vector3f> points = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<float> seen = {0.5F, 7.0F};
  const std::vector<PlyColumn> columns = {{"first_seen", seen}};
  const std::string file = format_ply(points, columns, PlyFlavour::binary);
  const PointTable table = parse_ply(bytes_of(file));  // which looks into the file
  EXPECT_EQ(column(table, "first_seen"), (std::vector<double>{0.5, 7.0}));
  EXPECT_EQ(column(table, "y"), (std::vector<double>{2, 5}));
}

TEST(PlyWriter, NoPointsHaveTheSameColumns) {
  const std::vector<PlyColumn> columns = {{"intensity", {}}, {"first_seen", {}}};
  const std::string file = format_ply({}, columns, PlyFlavour::binary);
  EXPECT_NE(file.find("property float intensity\nproperty float first_seen\n"), std::string::npos)
      << file;
  const std::string bare = format_ply({}, std::span<const float>(), PlyFlavour::binary);
  EXPECT_EQ(bare.find("intensity"), std::string::npos) << bare;
}

TEST(PlyWriter, LeavesNoPartialFileBehind) {
  const test::TemporaryFolder folder;
  const std::vector<Eigen::Vector3f> points(10);
  write_ply(folder.path() / "map.ply", points);
  write_ply(folder.path() / "map.ply", points);  // over the old one
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().filename(), "map.ply");
    ++files;
  }
  EXPECT_EQ(files, 1U);
}

// All its columns begin at the same address.
TEST(Ply, ABinaryFileOfNoPointsIsAnEmptyScan) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.ply";
  write_ply(file, {}, std::vector<PlyColumn>{});
  const auto item = open_recording(file)->next();
  ASSERT_TRUE(item);
  ASSERT_TRUE(item->scan) << item->error;
  EXPECT_TRUE(item->scan->points.empty());
}

}  // namespace
}  // namespace surefoot::io
