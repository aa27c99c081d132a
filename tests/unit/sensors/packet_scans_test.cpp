// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// From packets to scans, as a bag's reader feeds them: cut, stamped, lost ones counted.
#include "io/packets/packet_scans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/sensors/encoders.hpp"

namespace surefoot::io {
namespace {

namespace packets = sensors::test;
using test::bytes_of;

std::vector<ScanItem> all_of(PacketScans& scans) {
  std::vector<ScanItem> items;
  scans.finish();
  while (auto item = scans.take()) items.push_back(std::move(*item));
  return items;
}

TEST(PacketScans, AnOustersFramesAreItsOwn) {
  PacketScans scans({}, packets::ouster_json("RNG15_RFL8_NIR8"));
  constexpr std::uint64_t kPtp = 1'700'000'000'000'000'000;
  for (unsigned i = 0; i < 12; ++i) {
    auto packet =
        packets::ouster_packet(4, false, static_cast<std::uint16_t>(65'534 + i / 4),
                               static_cast<std::uint16_t>(i % 4 * 16), kPtp + i * 25'000'000ULL);
    packets::put(packet, packets::ouster_pixel(4, false, 0, 0), std::uint16_t{1000});
    const auto use = i == 6 ? PacketUse::used : scans.add(5, bytes_of(packet));  // one is lost
    EXPECT_EQ(use, PacketUse::used);
  }
  EXPECT_EQ(scans.sensor(), "OS-1-16");
  EXPECT_EQ(scans.lost(), 1U);
  EXPECT_NE(scans.time_source().find("PTP"), std::string::npos);
  const std::vector<ScanItem> items = all_of(scans);
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].remark, "");
  EXPECT_NE(items[1].remark.find("270.0 of 360"), std::string::npos) << items[1].remark;
  EXPECT_EQ(items[2].scan->stamp_ns, static_cast<std::int64_t>(kPtp) + 200'000'000);
  EXPECT_EQ(items[2].scan->times_ns,
            (std::vector<std::int32_t>{0, 25'000'000, 50'000'000, 75'000'000}));
}

TEST(PacketScans, ALivoxIsCutEveryTenthOfASecond) {
  PacketScans scans({});
  for (unsigned i = 0; i < 520; ++i) {
    auto packet = packets::livox_packet(7'000'000'000ULL + i * 480'000ULL, 1, 14);
    packets::put(packet, 36, std::int32_t{1000});
    EXPECT_EQ(scans.add(1'000'000'000'000'000 + i * 480'000LL, bytes_of(packet)), PacketUse::used);
  }
  EXPECT_EQ(scans.lost(), 0U);
  const std::vector<ScanItem> items = all_of(scans);
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].scan->stamp_ns, 1'000'000'000'000'000);  // the sensor counts from its start
  EXPECT_EQ(items[0].scan->points.size(), 209U);
  EXPECT_EQ(items[0].remark, "");
  EXPECT_NE(items[2].remark.find("of 100 ms"), std::string::npos);
}

TEST(PacketScans, LostPacketsByTheirNumbers) {
  const packets::HesaiLayout& layout = packets::hesai_layouts()[1];
  PacketScans scans({});
  for (unsigned i = 0; i < 260; ++i) {
    if (i % 100 == 40) continue;
    auto packet = packets::hesai_packet(layout, i * 144 % 36000, 18, 1, 0x37, i * 400,
                                        0xffffff00U + i);  // over the end
    packets::set_hesai(packet, layout, 0, 0, 100, 1);
    scans.add(1'673'403'349'000'000'000 + i * 400'000LL, bytes_of(packet));
    if (i == 30) {
      EXPECT_EQ(scans.add(0, bytes_of(packet)), PacketUse::late);  // twice
    }
  }
  EXPECT_EQ(scans.lost(), 3U);
  EXPECT_EQ(scans.return_mode(), "single, strongest");
  const std::vector<ScanItem> items = all_of(scans);
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[1].scan->stamp_ns - items[0].scan->stamp_ns, 100'000'000);
}

// Two are swapped on their way: the same scans as in order, and nothing is lost.
TEST(PacketScans, SwappedPacketsArePutWhereTheyBelong) {
  const packets::HesaiLayout& layout = packets::hesai_layouts()[1];
  const auto packet_of = [&](unsigned i) {
    auto packet = packets::hesai_packet(layout, i * 144 % 36000, 18, 1, 0x37, i * 400, 1000 + i);
    packets::set_hesai(packet, layout, 0, 0, static_cast<std::uint16_t>(100 + i), 1);
    return packet;
  };
  std::vector<unsigned> in_order(300);
  std::iota(in_order.begin(), in_order.end(), 0U);
  const auto read = [&](const std::vector<unsigned>& order, PacketScans& scans) {
    for (const unsigned i : order) {
      scans.add(1'673'403'349'000'000'000 + i * 400'000LL, bytes_of(packet_of(i)));
    }
    return all_of(scans);
  };
  PacketScans ordered({}), swapped({});
  std::vector<unsigned> order = in_order;
  std::swap(order[40], order[41]);
  std::rotate(order.begin() + 70, order.begin() + 71, order.begin() + 74);  // by three
  order.insert(order.begin() + 42, 40);                                     // and once more
  const std::vector<ScanItem> expected = read(in_order, ordered);
  const std::vector<ScanItem> items = read(order, swapped);
  EXPECT_EQ(swapped.lost(), 0U);
  EXPECT_EQ(swapped.reordered(), 2U);
  EXPECT_EQ(ordered.reordered(), 0U);
  EXPECT_EQ(swapped.notes().size(), ordered.notes().size() + 1);
  ASSERT_EQ(items.size(), expected.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(items[i].remark, expected[i].remark);
    EXPECT_EQ(items[i].scan->stamp_ns, expected[i].scan->stamp_ns);
    EXPECT_EQ(items[i].scan->times_ns, expected[i].scan->times_ns);
    EXPECT_EQ(items[i].scan->points, expected[i].scan->points);
    EXPECT_EQ(items[i].scan->rings, expected[i].scan->rings);
    EXPECT_EQ(items[i].scan->intensities, expected[i].scan->intensities);
  }
}

// A clock that stands still ends no sweep and must not fill the memory; nor must noise.
TEST(PacketScans, NoiseIsSkipped) {
  PacketScans scans({});
  for (std::size_t size = 0; size < 3000; ++size) {
    EXPECT_NE(scans.add(0, bytes_of(std::string(size, '\xff'))), PacketUse::used);
  }
  EXPECT_FALSE(scans.found());
  EXPECT_TRUE(all_of(scans).empty());
}

}  // namespace
}  // namespace surefoot::io
