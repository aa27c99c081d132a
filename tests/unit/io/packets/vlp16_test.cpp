// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "io/packets/udp_datagram.hpp"
#include "io/recording.hpp"
#include "io/sensor_clock.hpp"
#include "sensors/sensor_list.hpp"
#include "sensors/sweep_cutter.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::bytes_of;
using test::Measured;

using sensors::Sweep;

// A decoder and a cutter, as a recording puts them together.
class Stream {
 public:
  explicit Stream(const OpenOptions& options)
      : options_({options.dual_return, options.beam_origins, {}, {}}),
        cutter_(sensors::SweepEnd::azimuth, options.cut_azimuth_deg, 360.0) {}

  void add(const std::string& payload, std::int64_t stamp_ns, std::int64_t since_last_ns) {
    std::string reason;
    if (!decoder_) decoder_ = sensors::find_decoder(bytes_of(payload), "", options_, reason);
    ASSERT_NE(decoder_, nullptr);
    EXPECT_EQ(decoder_->sensor(), "VLP-16");
    ASSERT_EQ(decoder_->decode(bytes_of(payload), firings_), sensors::PacketKind::data);
    cutter_.add(firings_, stamp_ns, since_last_ns);
  }
  void finish() { cutter_.finish(); }
  std::optional<Sweep> take() { return cutter_.take(); }

 private:
  sensors::DecoderOptions options_;
  std::unique_ptr<sensors::PacketDecoder> decoder_;
  sensors::Firings firings_;
  sensors::SweepCutter cutter_;
};

Scan decode(const std::string& payload, const OpenOptions& options = {}) {
  Stream stream(options);
  stream.add(payload, 1'000'000'000, 0);
  stream.finish();
  return stream.take().value().scan;
}

Measured only(std::size_t block, std::size_t channel, std::size_t at_block,
              std::size_t at_channel) {
  const bool here = block == at_block && channel == at_channel;
  return {static_cast<std::uint16_t>(here ? 5000 : 0), 50};  // 10 m
}

// Every firing of a single-return packet: its place, time and ring from the manual's formulae.
TEST(Vlp16, EveryFiringOfASingleReturnPacket) {
  const int elevations[] = {-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15};
  OpenOptions options;
  options.beam_origins = false;
  for (std::size_t block = 0; block < 12; ++block) {
    for (std::size_t channel = 0; channel < 32; ++channel) {
      const Scan scan =
          decode(test::vlp16_payload(35000, 40, 0, 0x37,
                                     [&](auto b, auto c) { return only(b, c, block, channel); }),
                 options);
      ASSERT_EQ(scan.points.size(), 1U);
      const std::size_t laser = channel % 16;
      const double in_block_us = 55.296 * double(channel / 16) + 2.304 * double(laser);
      const double azimuth =
          (350.0 + 0.4 * double(block) + 0.4 * in_block_us / 110.592) * M_PI / 180.0;
      const double elevation = elevations[laser] * M_PI / 180.0;
      EXPECT_EQ(scan.times_ns[0], std::lround(1000 * (110.592 * double(block) + in_block_us)));
      EXPECT_NEAR(scan.points[0].x(), 10.0 * std::cos(elevation) * std::cos(azimuth), 2e-6);
      EXPECT_NEAR(scan.points[0].y(), -10.0 * std::cos(elevation) * std::sin(azimuth), 2e-6);
      EXPECT_NEAR(scan.points[0].z(), 10.0 * std::sin(elevation), 2e-6);
      EXPECT_EQ(scan.rings[0], (elevations[laser] + 15) / 2);
      EXPECT_EQ(scan.intensities[0], 50.0F);
    }
  }
}

TEST(Vlp16, VerticalCorrectionIsTheLasersOwnHeight) {
  const auto measure = [](auto block, auto channel) { return only(block, channel, 0, 0); };
  OpenOptions without;
  without.beam_origins = false;
  const std::string payload = test::vlp16_payload(0, 40, 0, 0x37, measure);
  EXPECT_NEAR(decode(payload).points[0].z() - decode(payload, without).points[0].z(),
              -0.04191 * std::tan(-15.0 * M_PI / 180.0), 5e-5);
}

// Two blocks of one azimuth: the last return, then the strongest or the second strongest.
TEST(Vlp16, DualReturnChoicesAndTimes) {
  const auto measure = [](std::size_t block, std::size_t channel) {
    const bool odd = block % 2 == 1;
    switch (channel) {
      case 0:
        return odd ? Measured{1000, 90} : Measured{2000, 10};  // the near one is stronger
      case 1:
        return odd ? Measured{1000, 10} : Measured{2000, 90};  // the last is the strongest
      case 2:
        return Measured{1500, 40};  // one return alone
      case 3:
        return odd ? Measured{0, 0} : Measured{1500, 40};
      default:
        return Measured{0, 0};
    }
  };
  const std::string payload = test::vlp16_payload(100, 40, 0, 0x39, measure);
  const auto ranges = [&](ReturnChoice choice) {
    OpenOptions options;
    options.dual_return = choice;
    options.beam_origins = false;
    const Scan scan = decode(payload, options);
    std::vector<long> millimetres;
    for (std::size_t i = 0; i < scan.points.size() / 6; ++i) {  // of the first of six pairs
      millimetres.push_back(std::lround(1000.0 * scan.points[i].norm()));
    }
    return millimetres;
  };
  EXPECT_EQ(ranges(ReturnChoice::strongest), (std::vector<long>{2000, 4000, 3000, 3000}));
  EXPECT_EQ(ranges(ReturnChoice::last), (std::vector<long>{4000, 4000, 3000, 3000}));
  EXPECT_EQ(ranges(ReturnChoice::both), (std::vector<long>{4000, 2000, 4000, 2000, 3000, 3000}));
  const Scan scan = decode(payload);
  ASSERT_EQ(scan.times_ns.size(), 24U);
  EXPECT_EQ(scan.times_ns[1], 2'304);
  EXPECT_EQ(scan.times_ns[4], 110'592);  // the second pair: two sequences later
}

TEST(Vlp16, AzimuthInterpolatesOverZero) {
  OpenOptions options;
  options.beam_origins = false;
  options.cut_azimuth_deg = 180.0;  // away from here
  const Scan scan = decode(
      test::vlp16_payload(35990, 40, 0, 0x37,
                          [](auto block, auto channel) { return only(block, channel, 0, 17); }),
      options);
  ASSERT_EQ(scan.points.size(), 1U);
  // Half the step of 0.4 deg, and a laser's share: from 359.9 to 0.1 deg.
  const double azimuth = (-0.1 + 0.2 + 0.2 * 2.304 / 55.296) * M_PI / 180.0;
  EXPECT_NEAR(std::atan2(-scan.points[0].y(), scan.points[0].x()), azimuth, 1e-7);
}

TEST(Vlp16, RevolutionsAreCutWhereTheAzimuthWraps) {
  for (const double cut_deg : {0.0, 180.0}) {
    OpenOptions options;
    options.cut_azimuth_deg = cut_deg;
    Stream revolutions(options);
    std::vector<Sweep> ended;
    // 188 packets of 4.8 deg: 2.5 turns from 100 deg on.
    for (unsigned i = 0; i * 480 < 90000; ++i) {
      const std::string payload = test::vlp16_payload(10000 + i * 480, 40, 0, 0x37, [](auto, auto) {
        return Measured{500, 1};
      });
      revolutions.add(payload, i * 1'327'104LL, 1'327'104);
    }
    revolutions.finish();
    while (auto revolution = revolutions.take()) {
      ended.push_back(std::move(*revolution));
    }
    ASSERT_EQ(ended.size(), cut_deg == 0.0 ? 3U : 4U);
    EXPECT_FALSE(ended.front().whole);
    EXPECT_NEAR(ended.front().turned_deg, cut_deg == 0.0 ? 260.0 : 80.0, 0.5);
    EXPECT_TRUE(ended[1].whole);
    EXPECT_NEAR(ended[1].turned_deg, 360.0, 0.5);
    EXPECT_FALSE(ended.back().whole);
    for (const Sweep& one : ended) {
      EXPECT_TRUE(std::is_sorted(one.scan.times_ns.begin(), one.scan.times_ns.end()));
      EXPECT_EQ(one.scan.times_ns.front(), 0);
    }
  }
}

TEST(Vlp16, AStandingHeadDoesNotFillTheMemory) {
  Stream revolutions({});
  const std::string payload = test::vlp16_payload(100, 0, 0, 0x37, [](auto, auto) {
    return Measured{500, 1};
  });
  std::size_t ended = 0;
  for (int i = 0; i < 1000; ++i) {
    revolutions.add(payload, i * 1'327'104LL, 1'327'104);
    ended += revolutions.take() ? 1 : 0;
  }
  EXPECT_GE(ended, 2U);
}

TEST(Vlp16, NotADataPacket) {
  std::string payload = test::vlp16_payload(0, 40, 0, 0x37, [](auto, auto) {
    return Measured{0, 0};
  });
  const auto is_data = [](const std::string& bytes) {
    std::string reason;
    return sensors::find_decoder(bytes_of(bytes), "", {}, reason) != nullptr;
  };
  EXPECT_TRUE(is_data(payload));
  EXPECT_FALSE(is_data(payload.substr(1)));
  EXPECT_FALSE(is_data(payload + "x"));
  std::string far = payload;
  far[103] = '\xff';  // an azimuth of more than 360 deg
  EXPECT_FALSE(is_data(far));
  payload[100] = '\0';  // a block's flag
  EXPECT_FALSE(is_data(payload));
}

constexpr auto kPastHour = sensors::TimeBase::hour;
constexpr std::int64_t kHour = 3'600'000'000'000;
constexpr std::int64_t kCapture = 403'712 * kHour + 1'082'708'714'000;

TEST(SensorClock, JoinsTheHourOfTheCapture) {
  SensorClock clock;
  EXPECT_EQ(clock.read(1'082'340'595'000LL, kPastHour, kCapture)->stamp_ns,
            403'712 * kHour + 1'082'340'595'000);
  EXPECT_EQ(clock.read(1'082'341'923'000LL, kPastHour, kCapture + 5)->since_last_ns, 1'328'000);
  EXPECT_FALSE(clock.read(1'082'341'923'000LL, kPastHour, kCapture + 9));  // repeated
  EXPECT_FALSE(clock.read(1'082'341'000'000LL, kPastHour, kCapture + 9));  // out of order
}

TEST(SensorClock, UnwrapsOverTheHour) {
  SensorClock clock;
  const std::int64_t before =
      clock.read(3'599'999'500'000LL, kPastHour, 10 * kHour + 100)->stamp_ns;
  EXPECT_EQ(before, 10 * kHour - 500'000);  // the capture's clock is already in the next hour
  EXPECT_EQ(clock.read(827'000LL, kPastHour, 10 * kHour + 1'327'000)->stamp_ns - before, 1'327'000);
}

TEST(SensorClock, WithoutGpsTheCaptureGivesTheStart) {
  SensorClock clock;
  EXPECT_EQ(clock.read(17'000LL, kPastHour, kCapture)->stamp_ns, kCapture);
  EXPECT_EQ(clock.read(1344'000LL, kPastHour, kCapture + 999'999)->stamp_ns, kCapture + 1'327'000);
  EXPECT_NE(clock.note().find("differ by"), std::string::npos);
  const auto jump = clock.read(1'082'000'000'000LL, kPastHour, kCapture + 2'000'000);  // GPS found
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->stamp_ns, kCapture + 1'327'000 + 1'000'001);
}

TEST(SensorClock, SinceTheEpochIsTakenAsItIs) {
  SensorClock clock;
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  const std::int64_t ptp = kCapture + 37'000'000'000;  // TAI
  EXPECT_EQ(clock.read(ptp, kAbsolute, kCapture)->stamp_ns, ptp);
  EXPECT_EQ(clock.read(ptp + 100, kAbsolute, kCapture)->stamp_ns, ptp + 100);
  EXPECT_NE(clock.source().find("PTP"), std::string::npos);
  SensorClock since_start;
  EXPECT_EQ(since_start.read(5'000, kAbsolute, kCapture)->stamp_ns, kCapture);
  EXPECT_EQ(since_start.read(5'700, kAbsolute, kCapture + 3)->stamp_ns, kCapture + 700);
  EXPECT_FALSE(since_start.read(-1, kAbsolute, kCapture));
  EXPECT_FALSE(since_start.read(std::numeric_limits<std::int64_t>::max(), kAbsolute, kCapture));
}

// Packets that stay behind the clock's last reading are late; if all do, the clock was set back.
TEST(SensorClock, AClockThatIsSetBackIsBridged) {
  SensorClock clock;
  ASSERT_TRUE(clock.read(1'000'000'000, kPastHour, kCapture));
  EXPECT_FALSE(clock.read(500'000'000, kPastHour, kCapture + 90'000'000));
  const auto jump = clock.read(520'000'000, kPastHour, kCapture + 110'000'000);
  ASSERT_TRUE(jump);
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->since_last_ns, 110'000'000);
  EXPECT_FALSE(clock.read(521'000'000, kPastHour, kCapture + 111'000'000)->jumped);
}

// NTP sets the receiver's clock while the sensor's goes on.
TEST(SensorClock, AReceiversClockThatIsSetMovesNoStamp) {
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  for (const std::int64_t set : {-kHour, -kHour / 1200, kHour / 1200}) {
    for (const auto base : {kPastHour, kAbsolute}) {
      SensorClock clock;
      const std::int64_t begin = base == kAbsolute ? kCapture : kCapture % kHour;
      ASSERT_TRUE(clock.read(begin, base, kCapture));
      std::int64_t arrival = kCapture + set;
      for (int packet = 1; packet <= 3; ++packet) {
        const auto next = clock.read(begin + packet * 1'327'000, base, arrival += 1'327'000);
        ASSERT_TRUE(next) << set;
        EXPECT_FALSE(next->jumped);
        EXPECT_EQ(next->stamp_ns, kCapture + packet * 1'327'000);
      }
    }
  }
}

// A sensor that takes its time from the receiver is set back with it.
TEST(SensorClock, BothClocksSetBackLoseNoPacket) {
  SensorClock clock;
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  ASSERT_TRUE(clock.read(kCapture, kAbsolute, kCapture));
  ASSERT_TRUE(clock.read(kCapture + 1'327'000, kAbsolute, kCapture + 1'327'000));
  const std::int64_t back = kCapture - kHour;
  const auto jump = clock.read(back, kAbsolute, back);
  ASSERT_TRUE(jump);
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->since_last_ns, 1'327'000);
  EXPECT_FALSE(clock.read(back + 1'327'000, kAbsolute, back + 1'327'000)->jumped);
}

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
