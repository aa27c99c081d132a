// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When and where the head stood at each firing of a packet: over all of them, over the turn's end,
// and where a part of the turn is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "unit/sensors/decoded.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;
using test::decode;
using test::turning;

TEST(FiringTimes, AHesaisBlocksFollowEachOtherAndSoDoItsPackets) {
  for (const test::HesaiLayout& layout : test::hesai_layouts()) {
    SCOPED_TRACE(layout.name);
    for (const std::size_t returns : {1U, 2U}) {
      const Firings firings =
          decode(test::hesai_packet(layout, 4500, 40, returns, returns == 1 ? 0x37 : 0x39, 0, 0),
                 layout.name);
      ASSERT_EQ(firings.firings.size(), layout.blocks / returns);
      const std::int64_t block_ns = firings.firings[0].duration_ns;
      for (std::size_t i = 1; i < firings.firings.size(); ++i) {
        const Firing &before = firings.firings[i - 1], &now = firings.firings[i];
        EXPECT_NEAR(static_cast<double>(now.offset_ns - before.offset_ns),
                    static_cast<double>(block_ns), 1.0);
      }
      EXPECT_NEAR(static_cast<double>(firings.period_ns),
                  static_cast<double>(block_ns) * static_cast<double>(firings.firings.size()),
                  static_cast<double>(layout.blocks));
    }
  }
}

// The flag says it where both blocks are returns of one firing; else the blocks take turns.
TEST(FiringTimes, APandarQt128FiresInOneOfTwoOrders) {
  const test::HesaiLayout& layout = test::hesai_layouts()[4];
  constexpr std::size_t kFlag = 1066, kChannel = 3;
  const auto offset = [&](std::size_t returns, std::size_t block, char flag) {
    auto packet = test::hesai_packet(layout, 4500, 40, returns, returns == 1 ? 0x37 : 0x39, 0, 0);
    packet[kFlag] = flag;
    test::set_hesai(packet, layout, block, kChannel, 2500, 33);
    return decode(packet, layout.name).points.at(0).offset_ns;
  };
  const auto even = offset(1, 0, 0), odd = offset(1, 1, 0);
  ASSERT_NE(even, odd);
  EXPECT_EQ(offset(2, 0, 1), even);
  EXPECT_EQ(offset(2, 0, 0), odd);
}

TEST(FiringTimes, AzimuthsEndWithTheTurn) {
  const auto expect_within_a_turn = [](const Firings& firings) {
    ASSERT_FALSE(firings.firings.empty());
    for (const Firing& firing : firings.firings) {
      EXPECT_GE(firing.azimuth_deg, 0.0);
      EXPECT_LT(firing.azimuth_deg, 360.0);
    }
  };
  expect_within_a_turn(
      decode(test::velodyne_packet({0xeeff}, turning(35'790, 40, 1), 0, 0x37, 0x22), "VLP-16"));
  expect_within_a_turn(decode(test::rs16_packet(35'790, 40, 0), "RS-LiDAR-16"));
}

/// Of a packet's only point: with all azimuths after that of `block` moved on by 20 degrees.
void expect_no_gap_in(std::string packet, const std::string& sensor, std::size_t block,
                      const std::function<std::size_t(std::size_t)>& azimuth_at,
                      bool is_big_endian) {
  SCOPED_TRACE(sensor);
  const Firings before = decode(packet, sensor);
  for (std::size_t next = block + 1; next < 12; ++next) {
    const std::size_t at = azimuth_at(next);
    if (at + 2 > packet.size()) break;
    if (is_big_endian) std::swap(packet[at], packet[at + 1]);
    std::uint16_t azimuth = 0;
    std::memcpy(&azimuth, packet.data() + at, sizeof(azimuth));
    test::put(packet, at, static_cast<std::uint16_t>(azimuth + 2000));
    if (is_big_endian) std::swap(packet[at], packet[at + 1]);
  }
  const Firings gap = decode(packet, sensor);
  ASSERT_EQ(before.points.size(), 1U);
  ASSERT_EQ(gap.points.size(), 1U);
  EXPECT_EQ(gap.points[0].position, before.points[0].position);
}

// A sensor that is set to a part of the turn jumps over the rest: that is not how fast it turns.
TEST(FiringTimes, WhatIsLeftOutOfATurnIsNoSpeed) {
  auto vlp16 = test::velodyne_packet({0xeeff}, turning(9000, 40, 1), 0, 0x37, 0x22);
  test::set_velodyne(vlp16, 2, 16 + 9, 2500, 1);  // of the second sequence
  expect_no_gap_in(
      vlp16, "VLP-16", 2, [](std::size_t block) { return 100 * block + 2; }, false);
  auto rs16 = test::rs16_packet(9000, 40, 0);
  test::set_rs16(rs16, 2, 16 + 9, 2500, 1);
  expect_no_gap_in(
      rs16, "RS-LiDAR-16", 2, [](std::size_t block) { return 44 + 100 * block; }, true);
  const test::HesaiLayout& layout = test::hesai_layouts()[1];
  auto hesai = test::hesai_packet(layout, 4500, 40, 1, 0x37, 0, 0);
  test::set_hesai(hesai, layout, 2, 31, 2500, 1);
  const auto hesai_azimuth = [&](std::size_t block) {
    return block < layout.blocks ? layout.header + block * (2 + 4 * layout.channels) : hesai.size();
  };
  expect_no_gap_in(hesai, layout.name, 2, hesai_azimuth, false);
}

TEST(FiringTimes, ATimeThatIsNoneIsMalformed) {
  std::string reason;
  auto rs16 = test::rs16_packet(0, 40, 0);
  for (const std::size_t at : {26U, 28U}) {
    auto bad = rs16;
    test::put_bytes(bad, at, test::big(std::uint16_t{1000}));
    EXPECT_EQ(find_decoder(bytes_of(bad), "", {}, reason), nullptr) << at;
  }
  const test::HesaiLayout& layout = test::hesai_layouts()[0];
  const auto hesai = [&](std::uint32_t micros) {
    return test::hesai_packet(layout, 0, 18, 1, 0x37, micros, 0);
  };
  EXPECT_NE(find_decoder(bytes_of(hesai(1'999'999)), "", {}, reason), nullptr) << "a leap second";
  EXPECT_EQ(find_decoder(bytes_of(hesai(2'000'001)), "", {}, reason), nullptr);
  EXPECT_EQ(find_decoder(bytes_of(test::livox_packet(1ULL << 63U, 1, 14)), "", {}, reason),
            nullptr);
}

}  // namespace
}  // namespace surefoot::sensors
