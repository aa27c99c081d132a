// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/packed_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "mapping/cloud_file.hpp"
#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

/// Walls and floor of a room, seen from `eyes` places.
PieceCloud room(std::size_t eyes) {
  test::Random random(3);
  PieceCloud cloud;
  for (std::size_t i = 0; i < eyes; ++i) cloud.eyes.push_back(random.vector(2.0).cast<float>());
  for (float x = -12.0F; x < 12.0F; x += 0.2F) {
    for (float y = 0.0F; y < 8.0F; y += 0.2F) {
      cloud.points.emplace_back(x, y, 0.01F * std::sin(9.0F * x));
      cloud.points.emplace_back(x, 8.0F, y);
    }
  }
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    cloud.seen_from.push_back(static_cast<std::uint16_t>((7 * i) % eyes));
  }
  return cloud;
}

bool before(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

TEST(PackedCloud, ComesBackToTwoMillimetres) {
  for (const std::size_t eyes : {1U, 2U, 25U, 300U}) {
    const PieceCloud cloud = room(eyes);
    const PieceCloud back = unpack(pack(cloud));
    ASSERT_EQ(back.points.size(), cloud.points.size());
    ASSERT_EQ(back.eyes.size(), eyes);
    for (std::size_t i = 0; i < eyes; ++i) {
      EXPECT_LT((back.eyes[i] - cloud.eyes[i]).cwiseAbs().maxCoeff(), 0.0021F);
    }
    // By what they were seen from and in order, both are the same.
    for (std::uint16_t eye = 0; eye < std::min<std::size_t>(eyes, 3); ++eye) {
      std::vector<Eigen::Vector3f> one, other;
      for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (cloud.seen_from[i] == eye) one.push_back((256.0F * cloud.points[i]).array().round());
        if (back.seen_from[i] == eye) other.push_back((256.0F * back.points[i]).array().round());
      }
      std::sort(one.begin(), one.end(), before);
      std::sort(other.begin(), other.end(), before);
      EXPECT_EQ(one, other) << eyes << " eyes, from " << eye;
    }
  }
}

TEST(PackedCloud, TakesFewBytes) {
  const PieceCloud cloud = room(25);
  EXPECT_LT(pack(cloud).size(), 4.5 * static_cast<double>(cloud.points.size()));
}

TEST(PackedCloud, WhatIsFarOrNoNumberIsPutWithinReach) {
  PieceCloud cloud;
  cloud.eyes = {Eigen::Vector3f::Zero()};
  cloud.points = {{1e9F, -1e9F, std::nanf("")}};
  cloud.seen_from = {0};
  const PieceCloud back = unpack(pack(cloud));
  ASSERT_EQ(back.points.size(), 1U);
  EXPECT_TRUE(back.points[0].allFinite());
  EXPECT_LE(back.points[0].cwiseAbs().maxCoeff(), 64.0F);
  EXPECT_TRUE(unpack(pack({})).points.empty());
}

TEST(PackedCloud, BrokenBytesAreRefused) {
  const std::string bytes = pack(room(25));
  for (const std::size_t kept :
       {std::size_t{0}, std::size_t{7}, std::size_t{40}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_THROW((void)unpack(bytes.substr(0, kept)), std::invalid_argument) << kept;
  }
  std::string many = bytes;
  many[7] = '\x7F';  // two thousand million points
  EXPECT_THROW((void)unpack(many), std::invalid_argument);
  std::string blind = bytes;
  blind[0] = blind[1] = 0;  // seen from nowhere
  EXPECT_THROW((void)unpack(blind), std::invalid_argument);
}

TEST(CloudFile, IsMemoryThatCanBeChanged) {
  const std::shared_ptr<CloudFile> file = CloudFile::make({});
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->mapped().empty());
  std::uint64_t at = 0;
  ASSERT_TRUE(file->append("first", at));
  ASSERT_EQ(file->mapped().size(), 5U);
  file->mapped()[0] = std::byte{'F'};
  ASSERT_TRUE(file->append("more", at));
  ASSERT_EQ(file->mapped().size(), 9U);
  EXPECT_EQ(file->read(0, 9), "Firstmore");
}

TEST(CloudFile, KeepsWhatIsAppended) {
  const std::shared_ptr<CloudFile> file = CloudFile::make({});
  ASSERT_TRUE(file);
  std::uint64_t one = 0, other = 0;
  ASSERT_TRUE(file->append("first", one));
  ASSERT_TRUE(file->append("second", other));
  EXPECT_EQ(file->read(one, 5), "first");
  EXPECT_EQ(file->read(other, 6), "second");
  EXPECT_THROW((void)file->read(other, 7), std::runtime_error);
  EXPECT_FALSE(CloudFile::make("/nowhere/at/all"));
  EXPECT_FALSE(CloudFile::open("/nowhere/at/all"));
}

}  // namespace
}  // namespace surefoot::mapping
