// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "mapping/map_on_disk.hpp"
#include "mapping/submap.hpp"
#include "support/random.hpp"
#include "support/scratch.hpp"

namespace surefoot::mapping {
namespace {

SavedMap small_map() {
  test::Random random(5);
  SavedMap map;
  for (int i = 0; i < 3; ++i) {
    Piece piece;
    piece.begin_ns = 1'700'000'000'000'000'000 + i;
    piece.stamp_ns = piece.begin_ns + 5;
    piece.T_world_piece = {so3_exp(random.vector(1.0)), random.vector(1000.0)};
    piece.way = 5.0 * i;
    piece.length = 5.0;
    piece.restarted = i == 2;
    piece.eyes = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.5F, 0.0F}};
    for (int k = 0; k < 40; ++k) {
      piece.points.push_back(random.vector(50.0).cast<float>());
      piece.seen_from.push_back(static_cast<std::uint16_t>(k % 2));
    }
    map.pieces.push_back(piece);
    map.places.push_back(describe_place(make_submap(piece)));
  }
  PoseEdge edge;
  edge.from = 0;
  edge.to = 2;
  edge.inlier = false;
  edge.T_from_to.translation = {1.0, 2.0, 3.0};
  map.edges = {edge};
  return map;
}

/// Whatever their order is.
void expect_same_points(const PieceCloud& back, const PieceCloud& cloud) {
  ASSERT_EQ(back.points.size(), cloud.points.size());
  ASSERT_EQ(back.eyes.size(), cloud.eyes.size());
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    bool found = false;
    for (std::size_t m = 0; m < back.points.size() && !found; ++m) {
      const Eigen::Vector3f gap = back.points[m] - cloud.points[k];
      found = gap.cwiseAbs().maxCoeff() < 0.0021F && back.seen_from[m] == cloud.seen_from[k];
    }
    EXPECT_TRUE(found) << k;
  }
}

std::string refusal(const std::string& bytes) {
  try {
    (void)parse_map(bytes);
  } catch (const MapFileError& error) {
    return error.what();
  }
  return "";
}

TEST(MapFile, ReadsBackWhatWasWritten) {
  const SavedMap map = small_map();
  const SavedMap back = parse_map(format_map(map));
  ASSERT_EQ(back.pieces.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(back.pieces[i].stamp_ns, map.pieces[i].stamp_ns);
    EXPECT_EQ(back.pieces[i].T_world_piece.translation, map.pieces[i].T_world_piece.translation);
    EXPECT_EQ(back.pieces[i].restarted, map.pieces[i].restarted);
    expect_same_points(*cloud_of(back.pieces[i]), map.pieces[i]);
    EXPECT_EQ(back.places[i].bins, map.places[i].bins);
    EXPECT_LT((back.places[i].key - map.places[i].key).norm(), 1e-6F);
  }
  ASSERT_EQ(back.edges.size(), 1U);
  EXPECT_EQ(back.edges[0].to, 2U);
  EXPECT_FALSE(back.edges[0].inlier);
  EXPECT_EQ(back.edges[0].T_from_to.translation, map.edges[0].T_from_to.translation);
}

class MapOnDisk : public test::Scratch {};

TEST_F(MapOnDisk, LeavesNothingWhereItCannotBeWritten) {
  const auto file = folder_ / "map.surefoot";
  SavedMap map = small_map();
  store_map(file, map);
  const auto size = std::filesystem::file_size(file);
  // The file that a piece's points were put away in is shorter than it was.
  map.pieces[1].stored =
      std::make_shared<const StoredCloud>(StoredBytes(CloudFile::make(folder_), 1'000'000, 100));
  EXPECT_THROW(store_map(file, map), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(file), size) << "the old one stays";
  const std::filesystem::directory_iterator entries(folder_);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST(MapFile, WhatIsCutShortOrChangedIsRefused) {
  const std::string bytes = format_map(small_map());
  EXPECT_EQ(refusal(bytes), "");
  EXPECT_NE(refusal("").find("no map"), std::string::npos);
  for (std::size_t cut = 1; cut < bytes.size(); cut += bytes.size() / 60) {
    EXPECT_NE(refusal(bytes.substr(0, bytes.size() - cut)), "") << cut;
  }
  for (std::size_t at = 0; at < bytes.size(); at += bytes.size() / 60) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_NE(refusal(changed), "") << at;
  }
  SavedMap far = small_map();
  far.pieces[1].T_world_piece.translation.x() = 1e9;
  EXPECT_NE(refusal(format_map(far)).find("100,000 km"), std::string::npos);
  EXPECT_EQ(refusal(sealed(bytes.substr(25))), "");
  std::string newer = bytes;
  newer[13] = 9;
  EXPECT_NE(refusal(newer).find("version 9"), std::string::npos);
}

/// Whole files, with the checksum of what stands in them.
TEST(MapFile, WhatCannotBeAMapIsRefusedThoughItsChecksumFits) {
  const auto expect_refused = [](const std::string& bytes, const std::string& why) {
    EXPECT_NE(refusal(bytes).find(why), std::string::npos) << why << ": " << refusal(bytes);
  };
  const auto with = [](const std::function<void(SavedMap&)>& change) {
    SavedMap map = small_map();
    change(map);
    return format_map(map);
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t kHead = 25;
  const std::string content = format_map(small_map()).substr(kHead);
  expect_refused(sealed(std::string(4, '\x7f') + content.substr(4)), "more than it has bytes for");
  expect_refused(sealed(content.substr(0, 3)), "cut short");
  EXPECT_EQ(refusal(format_map(small_map()).substr(0, kHead - 1)), "cut short");
  expect_refused(sealed(content + "x"), "more bytes than its content");
  expect_refused(with([](SavedMap& map) { map.pieces[1].way = kNaN; }), "not finite");
  expect_refused(with([](SavedMap& map) { map.edges[0].information(5, 5) = kNaN; }), "not finite");
  expect_refused(with([](SavedMap& map) { map.pieces[0].T_world_piece.translation.z() = -1e9; }),
                 "100,000 km");
  expect_refused(with([](SavedMap& map) { map.edges[0].T_from_to.rotation.w() = 1.001; }),
                 "unit length");
  expect_refused(with([](SavedMap& map) { map.edges[0].from = 3; }), "piece that is not there");
  expect_refused(with([](SavedMap& map) { map.edges[0].to = 3; }), "piece that is not there");
  expect_refused(with([](SavedMap& map) {
                   map.pieces[2].stored = std::make_shared<const StoredCloud>(std::string(8, '~'));
                 }),
                 "holds more points than");
}

/// One point and one place that it can have been seen from.
TEST(MapFile, APointOfVersion1ThatWasSeenFromNowhereIsRefused) {
  SavedMap map;
  map.pieces.resize(1);
  map.places.resize(1);
  constexpr std::size_t kHead = 25, kUpToItsCloud = 4 + 433;
  const auto with_point_seen_from = [&](char eye) {
    std::string content = format_map(map).substr(kHead, kUpToItsCloud);
    content += std::string("\1\0\0\0", 4) + std::string(6, '\0');
    content += std::string("\1\0\0\0", 4) + std::string(6, '\0') + eye + '\0';
    return refusal(sealed(content, 1));
  };
  EXPECT_NE(with_point_seen_from('\1').find("seen from nowhere"), std::string::npos);
  EXPECT_EQ(with_point_seen_from('\0'), "cut short") << "its place follows";
}

/// Made by the program at commit b4f0ad4: ground that falls to the side, and a wall.
TEST(MapFile, AMapOfVersion1IsReadAndItsPlacesAreDescribedAsTodays) {
  std::ifstream file(SUREFOOT_SOURCE_DIR "/tests/unit/mapping/map_of_version_1.surefoot",
                     std::ios::binary);
  ASSERT_TRUE(file);
  const SavedMap map = read_map(file, nullptr);
  ASSERT_EQ(map.pieces.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Piece& piece = map.pieces[i];
    EXPECT_EQ(piece.begin_ns, 1'700'000'000'000'000'000 + static_cast<std::int64_t>(i));
    EXPECT_EQ(piece.T_world_piece.translation,
              Eigen::Vector3d(5.0 * static_cast<double>(i), 1.0, -0.5));
    EXPECT_EQ(piece.length, 4.5);
    EXPECT_EQ(piece.restarted, i == 1);
    PieceCloud cloud;
    cloud.eyes = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.5F, 0.0F}};
    for (int k = 0; k < 64; ++k) {
      const float x = static_cast<float>(k % 8) - 3.5F, y = static_cast<float>(k / 8) - 3.5F;
      cloud.points.emplace_back(x, y, -0.5F - 0.25F * y);
      cloud.seen_from.push_back(static_cast<std::uint16_t>(k % 2));
    }
    for (int k = 0; k < 16; ++k) {
      const float height = 0.125F * static_cast<float>(k + static_cast<int>(i));
      cloud.points.emplace_back(0.5F * static_cast<float>(k), 8.0F, height);
      cloud.seen_from.push_back(1);
    }
    expect_same_points(*cloud_of(piece), cloud);
    const PlaceDescriptor today = describe_place(make_submap(map.pieces, i));
    EXPECT_GT(today.bins.sum(), 0.0F);
    EXPECT_EQ(map.places[i].bins, today.bins);
  }
  ASSERT_EQ(map.edges.size(), 1U);
  EXPECT_FALSE(map.edges[0].inlier);
  EXPECT_EQ(map.edges[0].T_from_to.translation, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(parse_map(format_map(map)).pieces.size(), 2U);
}

}  // namespace
}  // namespace surefoot::mapping
