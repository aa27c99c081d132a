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
    const std::string part = part_of(ip, offset, 80, last);  // the fragment refers to it
    (void)find_udp(LinkLayer::raw_ip, bytes_of(part), &fragment);
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

FrameContent kind_in(LinkLayer link, const std::string& frame) {
  return find_udp(link, bytes_of(frame)).content;
}

TEST(Udp, ProvidersTagsArePassedOver) {
  const std::string ip = test::ip_packet("payload", 2368);
  const std::string addresses(12, '\x02'), type("\x08\x00", 2);
  for (const char* tag : {"\x88\xa8\x01\x05", "\x91\x00\x01\x05", "\x81\x00\x01\x05"}) {
    const std::string tagged = addresses + std::string(tag, 4) + type + ip;
    EXPECT_EQ(kind_in(LinkLayer::ethernet, tagged), FrameContent::udp);
  }
  EXPECT_EQ(kind_in(LinkLayer::ethernet, addresses + std::string("\x86\xdd", 2) + ip),
            FrameContent::other);
}

TEST(Udp, WhatIsNoIpv4IsOther) {
  const std::string ip = test::ip_packet("payload", 2368);
  const std::string ipv6("\x86\xdd", 2);
  EXPECT_EQ(kind_in(LinkLayer::linux_cooked, std::string(14, '\0') + ipv6 + ip),
            FrameContent::other);
  EXPECT_EQ(kind_in(LinkLayer::linux_cooked2, ipv6 + std::string(18, '\0') + ip),
            FrameContent::other);
  EXPECT_EQ(kind_in(LinkLayer::loopback, std::string("\x18\0\0\0", 4) + ip), FrameContent::other);
  EXPECT_EQ(kind_in(LinkLayer::raw_ip, "\x65" + ip.substr(1)), FrameContent::other);
  EXPECT_EQ(kind_in(LinkLayer::raw_ip, "\x44" + ip.substr(1)), FrameContent::other)
      << "a header that is too short to be one";
}

TEST(Udp, LengthsThatAreLessThanTheirHeadersAreTruncated) {
  const std::string ip = test::ip_packet("payload", 2368);
  std::string udp = ip;
  udp.replace(24, 2, test::big(std::uint16_t{7}));
  EXPECT_EQ(kind_in(LinkLayer::raw_ip, udp), FrameContent::truncated);
  for (const std::uint16_t length :
       {std::uint16_t{19}, static_cast<std::uint16_t>(ip.size() + 1)}) {
    std::string fragment = ip;
    fragment[6] = '\x20';
    fragment.replace(2, 2, test::big(length));
    EXPECT_EQ(kind_in(LinkLayer::raw_ip, fragment), FrameContent::truncated) << length;
  }
}

/// A datagram of 157 bytes with its header, in two parts.
IpFragment half_of(std::size_t offset, std::size_t size) {
  static const std::string ip = test::ip_packet(std::string(149, 'x'), 7502);
  static std::string part;
  part = part_of(ip, offset, size, offset > 0);
  IpFragment fragment;
  (void)find_udp(LinkLayer::raw_ip, bytes_of(part), &fragment);
  return fragment;
}

TEST(Udp, PartsOfOneNumberAreJoinedOnlyBetweenTheSameTwo) {
  FragmentBuffer buffer;
  EXPECT_EQ(buffer.add(half_of(0, 80)).content, FrameContent::fragment);
  IpFragment last = half_of(80, 77);
  ++last.source_address;
  EXPECT_EQ(buffer.add(last).content, FrameContent::fragment) << "from another";
  --last.source_address;
  ++last.destination_address;
  EXPECT_EQ(buffer.add(last).content, FrameContent::fragment) << "to another";
  --last.destination_address;
  EXPECT_EQ(buffer.add(last).content, FrameContent::udp);
  EXPECT_EQ(buffer.add(half_of(0, 80)).content, FrameContent::fragment) << "of the next one";
}

TEST(Udp, APartThatEndsWithinAUnitIsNoneAndSpoilsNothing) {
  FragmentBuffer buffer;
  EXPECT_EQ(buffer.add(half_of(0, 77)).content, FrameContent::fragment);
  EXPECT_EQ(buffer.add(half_of(0, 80)).content, FrameContent::fragment);
  EXPECT_EQ(buffer.add(half_of(80, 77)).content, FrameContent::udp);
}

}  // namespace
}  // namespace surefoot::io
