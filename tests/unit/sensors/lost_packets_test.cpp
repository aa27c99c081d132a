// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Packets of one azimuth each, some of them lost or swapped: how far the head turns within the next
// one does not depend on what came before it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "sensors/sensor_list.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;

constexpr unsigned kLast = 40;

/// Packet `index` of a head that turns evenly, with a return of its last channel.
using Encoder = std::function<std::string(unsigned index)>;

std::string vls128_packet(unsigned index) {
  std::vector<unsigned> azimuths(12, 35'500 + 19 * index);
  auto packet = test::velodyne_packet({0xeeff, 0xeeff, 0xddff, 0xddff, 0xccff, 0xccff, 0xbbff,
                                       0xbbff, 0xeeff, 0xeeff, 0xeeff, 0xeeff},
                                      azimuths, 100 + 533 * index / 10, 0x39, 0xa1);
  test::set_velodyne(packet, 6, 31, 2500, 9);
  return packet;
}

std::string qt128_packet(unsigned index) {
  const test::HesaiLayout& layout = test::hesai_layouts()[4];
  auto packet = test::hesai_packet(layout, (35'500 + 44 * index) % 36'000, 44, 2, 0x39,
                                   100 + 1111 * index / 10, index);
  test::set_hesai(packet, layout, 0, 127, 2500, 33);
  return packet;
}

/// The last of the packets, read after the others.
Firings last_after(const Encoder& encode, const std::vector<unsigned>& before) {
  std::string reason;
  const auto decoder = find_decoder(bytes_of(encode(0)), "", {}, reason);
  Firings firings;
  if (decoder == nullptr) {
    ADD_FAILURE() << reason;
    return firings;
  }
  for (const unsigned index : before) {
    EXPECT_EQ(decoder->decode(bytes_of(encode(index)), firings), PacketKind::data);
  }
  EXPECT_EQ(decoder->decode(bytes_of(encode(kLast)), firings), PacketKind::data);
  return firings;
}

std::vector<unsigned> packets(unsigned end) {
  std::vector<unsigned> indices;
  for (unsigned index = 0; index < end; ++index) indices.push_back(index);
  return indices;
}

void expect_unmoved_by_what_is_lost(const Encoder& encode) {
  const Firings whole = last_after(encode, packets(kLast));
  std::vector<unsigned> swapped = packets(kLast - 2);
  swapped.insert(swapped.end(), {kLast - 1, kLast - 2});
  const std::vector<unsigned> ways[] = {packets(kLast - 1), packets(kLast - 8), swapped};
  for (const std::vector<unsigned>& before : ways) {
    const Firings one = last_after(encode, before);
    ASSERT_EQ(one.points.size(), 1U);
    EXPECT_EQ(one.points[0].position, whole.points.at(0).position);
    EXPECT_EQ(one.firings.at(0).turned_deg, whole.firings.at(0).turned_deg);
  }
}

TEST(LostPackets, OfAVls128WithTwoReturns) { expect_unmoved_by_what_is_lost(vls128_packet); }

TEST(LostPackets, OfAPandarQt128WithTwoReturns) { expect_unmoved_by_what_is_lost(qt128_packet); }

// From packet to packet the step is the head's own, not that of 600 rpm.
TEST(LostPackets, NoneLost) {
  EXPECT_NEAR(last_after(vls128_packet, packets(kLast)).firings.at(0).turned_deg, 0.19, 1e-9);
  EXPECT_NEAR(last_after(qt128_packet, packets(kLast)).firings.at(0).turned_deg, 0.44, 1e-9);
}

}  // namespace
}  // namespace surefoot::sensors
