// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/udp_datagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::bytes_of;

TEST(Udp, LinkLayersTagsAndOptions) {
  const std::string ip = test::ip_packet("payload", 2368);
  const auto payload_in = [](LinkLayer link, const std::string& frame) {
    const UdpDatagram found = find_udp(link, bytes_of(frame));
    EXPECT_EQ(found.content, FrameContent::udp);
    EXPECT_EQ(found.destination_port, 2368);
    return std::string(reinterpret_cast<const char*>(found.payload.data()), found.payload.size());
  };
  for (const unsigned tags : {0U, 1U, 2U}) {
    EXPECT_EQ(payload_in(LinkLayer::ethernet, test::ethernet_frame(ip, tags)), "payload");
  }
  EXPECT_EQ(payload_in(LinkLayer::raw_ip, test::ip_packet("payload", 2368, 3)), "payload");
  EXPECT_EQ(payload_in(LinkLayer::loopback, std::string("\2\0\0\0", 4) + ip), "payload");
  EXPECT_EQ(payload_in(LinkLayer::loopback, std::string("\0\0\0\2", 4) + ip), "payload");
  const std::string type("\x08\x00", 2);
  EXPECT_EQ(payload_in(LinkLayer::linux_cooked, std::string(14, '\0') + type + ip), "payload");
  EXPECT_EQ(payload_in(LinkLayer::linux_cooked2, type + std::string(18, '\0') + ip), "payload");
  // Ethernet pads short frames.
  EXPECT_EQ(payload_in(LinkLayer::ethernet, test::ethernet_frame(ip) + "\0\0\0"), "payload");
}

TEST(Udp, OtherAndTruncated) {
  const std::string ip = test::ip_packet("payload", 2368);
  for (std::size_t size = 1; size < ip.size(); ++size) {
    EXPECT_EQ(find_udp(LinkLayer::raw_ip, bytes_of(ip.substr(0, size))).content,
              FrameContent::truncated);
  }
  EXPECT_EQ(find_udp(LinkLayer::raw_ip, {}).content, FrameContent::other);
  EXPECT_EQ(find_udp(LinkLayer::raw_ip, bytes_of(test::ip_packet("payload", 2368, 0, 6))).content,
            FrameContent::other);
  std::string fragment = ip;
  fragment[6] = '\x20';
  EXPECT_EQ(find_udp(LinkLayer::raw_ip, bytes_of(fragment)).content, FrameContent::fragment);
}

// An IPv4 packet that holds a part of a datagram, from `offset` on.
std::string part_of(const std::string& ip, std::size_t offset, std::size_t size, bool last) {
  constexpr std::size_t kHeader = 20;
  const auto flags = static_cast<std::uint16_t>((last ? 0U : 0x2000U) | offset / 8);
  return ip.substr(0, 2) + test::big(static_cast<std::uint16_t>(kHeader + size)) + ip.substr(4, 2) +
         test::big(flags) + ip.substr(8, kHeader - 8) + ip.substr(kHeader + offset, size);
}

TEST(Udp, FragmentsAreJoinedInAnyOrder) {
  std::string content(5000, '\0');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * 7);
  const std::string ip = test::ip_packet(content, 7502);
  const std::string parts[] = {part_of(ip, 0, 1480, false), part_of(ip, 1480, 1480, false),
                               part_of(ip, 2960, 1480, false), part_of(ip, 4440, 568, true)};
  std::vector<std::size_t> order = {0, 1, 2, 3};
  do {
    FragmentBuffer buffer;
    for (std::size_t i = 0; i < order.size(); ++i) {
      IpFragment fragment;
      const auto found = find_udp(LinkLayer::raw_ip, bytes_of(parts[order[i]]), &fragment);
      ASSERT_EQ(found.content, FrameContent::fragment);
      EXPECT_EQ(buffer.add(fragment).content == FrameContent::udp, i == 3);
      if (i == 1) {  // sent twice
        EXPECT_EQ(buffer.add(fragment).content, FrameContent::fragment);
      }
    }
    IpFragment fragment;
    for (const std::string& part : parts) {  // the next datagram of the same number
      (void)find_udp(LinkLayer::raw_ip, bytes_of(part), &fragment);
      const UdpDatagram whole = buffer.add(fragment);
      if (whole.content == FrameContent::udp) {
        EXPECT_EQ(whole.destination_port, 7502);
        EXPECT_EQ(
            std::string(reinterpret_cast<const char*>(whole.payload.data()), whole.payload.size()),
            content);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

// Numbers come again after 65,536 datagrams.
TEST(Udp, WhatStaysIncompleteIsNotJoinedToALaterDatagram) {
  const std::string ip = test::ip_packet(std::string(152, 'x'), 7502);  // 160 bytes with its header
  FragmentBuffer buffer;
  const auto add = [&](std::uint16_t id, std::size_t offset, bool last) {
    IpFragment fragment;
    (void)find_udp(LinkLayer::raw_ip, bytes_of(part_of(ip, offset, 80, last)), &fragment);
    fragment.id = id;
    return buffer.add(fragment).content == FrameContent::udp;
  };
  EXPECT_FALSE(add(7, 0, false));  // its other half is lost
  for (std::uint16_t i = 0; i < 200; ++i) {
    const auto id = static_cast<std::uint16_t>(100 + i);
    EXPECT_FALSE(add(id, 0, false));
    EXPECT_TRUE(add(id, 80, true));
  }
  EXPECT_FALSE(add(7, 80, true));
}

TEST(Udp, FragmentsBeyondADatagramAreRefused) {
  FragmentBuffer buffer;
  const std::string bytes(80, 'x');
  for (unsigned i = 0; i < 1000; ++i) {  // none is ever completed
    IpFragment fragment{i, 2, static_cast<std::uint16_t>(i), 65'528, i % 2 == 0, bytes_of(bytes)};
    EXPECT_EQ(buffer.add(fragment).content, FrameContent::fragment);
    fragment.offset = 8;
    EXPECT_EQ(buffer.add(fragment).content, FrameContent::fragment);
  }
}

}  // namespace
}  // namespace surefoot::io
