// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A capture into a capture: which frames go, and that they are the same.
#include "io/packet_conversion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "io/bags/compression.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kStart = 1'453'363'200'000'000'000;  // a whole hour
constexpr std::int64_t kPeriodNs = 1'327'104;
constexpr unsigned kTurn = 75;  // packets, which end where a turn does
constexpr unsigned kTurns = 5;

/// A frame of the capture, and which data packet it is, or a part of; -1: something else.
struct Frame {
  std::int64_t stamp_ns = 0;
  std::string bytes;
  int packet = -1;
};

// An Ouster's datagrams come so: in parts.
std::vector<std::string> in_two(const std::string& ip) {
  constexpr std::size_t kHeader = 20, kFirst = 600;
  std::string first = ip.substr(0, kHeader + kFirst), last = ip.substr(0, kHeader);
  last += ip.substr(kHeader + kFirst);
  first[6] = '\x20';  // more to come
  last[6] = '\0';
  last[7] = static_cast<char>(kFirst / 8);
  for (std::string* part : {&first, &last}) {
    part->replace(2, 2, test::big(static_cast<std::uint16_t>(part->size())));
  }
  return {first, last};
}

std::string data_packet(unsigned i) {
  return test::vlp16_payload(i * 480 % 36000, 40, static_cast<std::uint32_t>(i * kPeriodNs / 1000),
                             0x37, [](auto, auto) {
                               return test::Measured{500, 1};
                             });
}

std::vector<Frame> frames(bool in_parts = false) {
  std::vector<Frame> all;
  const auto add = [&](unsigned i, int packet, const std::string& ip) {
    all.push_back({kStart + i * kPeriodNs + std::ssize(all) % 7, test::ethernet_frame(ip), packet});
  };
  for (unsigned i = 0; i < kTurns * kTurn; ++i) {
    const std::string ip = test::ip_packet(data_packet(i), 2368);
    const auto parts = in_parts ? in_two(ip) : std::vector<std::string>{ip};
    for (const std::string& part : parts) add(i, static_cast<int>(i), part);
    if (i % 10 == 4) add(i, -1, test::ip_packet(std::string(512, 'p'), 8308));
    if (i % 20 == 9) add(i, -1, test::ip_packet(data_packet(i), 2369));  // a second LiDAR
  }
  return all;
}

std::string capture_of(const std::vector<Frame>& all) {
  test::PcapFile file(1, true);
  for (const Frame& frame : all) file.add(frame.stamp_ns, frame.bytes);
  return file.content();
}

class PacketConversion : public testing::Test {
 protected:
  ConversionOutcome convert(ConversionRequest request) {
    const ConversionListener listener = {[](std::size_t, double share) { EXPECT_LE(share, 1.0); },
                                         [](const std::string&) {},
                                         [this] { return interrupted_ || asked_++ >= patience_; }};
    if (request.input.empty()) request.input = folder_.path() / "walk.pcap";
    request.output = folder_.path() / "out.pcap";
    std::error_code ignored;
    fs::remove(request.output, ignored);
    return convert_recording(request, listener);
  }
  std::string written() const {
    std::ifstream file(folder_.path() / "out.pcap", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// What goes by the data packets that do, and by which frames are between.
  template <typename IsIn>
  void expect(const std::vector<Frame>& all, IsIn&& is_in) const {
    std::vector<Frame> expected;
    for (const Frame& frame : all) {
      if (is_in(frame)) expected.push_back(frame);
    }
    // Behind the header, in which how long frames may be is the reader's.
    constexpr std::size_t kHeader = 24;
    EXPECT_EQ(written().substr(kHeader), capture_of(expected).substr(kHeader));
    EXPECT_EQ(written().substr(0, 8), capture_of({}).substr(0, 8));
  }
  /// All from one data packet to another.
  void expect_from_to(const std::vector<Frame>& all, int first, int end) const {
    const auto where = [&](int packet) {
      return std::find_if(all.begin(), all.end(),
                          [=](const Frame& frame) { return frame.packet == packet; }) -
             all.begin();
    };
    const auto begin = where(first), behind = where(end);
    expect(all, [&](const Frame& frame) {
      return &frame - all.data() >= begin && &frame - all.data() < behind;
    });
  }
  const test::TemporaryFolder folder_;
  bool interrupted_ = false;
  int asked_ = 0, patience_ = 1'000'000;  ///< how often it is asked for before it is interrupted
};

TEST_F(PacketConversion, AllIsTheSame) {
  const auto all = frames();
  folder_.write("walk.pcap", capture_of(all));
  const ConversionOutcome outcome = convert({});
  EXPECT_EQ(outcome.scans, kTurns);
  EXPECT_EQ(outcome.packets, all.size());
  EXPECT_EQ(outcome.points, std::size_t{kTurns} * kTurn * 384);
  EXPECT_TRUE(outcome.losses.empty());
  expect(all, [](const Frame&) { return true; });
}

// Microseconds, other byte orders and compression change nothing about a stamp.
TEST_F(PacketConversion, OfEveryKindOfCapture) {
  auto all = frames();
  for (Frame& frame : all) frame.stamp_ns -= frame.stamp_ns % 1000;
  test::PcapFile micro(1, false, true);
  test::PcapngFile next;
  for (const Frame& frame : all) {
    micro.add(frame.stamp_ns, frame.bytes);
    next.add(frame.stamp_ns, frame.bytes);
  }
  for (const std::string& content :
       {micro.content(), next.content(), compress(Compression::zstd, micro.content())}) {
    folder_.write("walk.pcap", content);
    const ConversionOutcome outcome = convert({});
    expect(all, [](const Frame&) { return true; });
    EXPECT_EQ(outcome.losses.size(), content == next.content() ? 1U : 0U);
  }
}

TEST_F(PacketConversion, AScanHasItsPacketsAndWhatCameBetween) {
  for (const bool in_parts : {false, true}) {
    const auto all = frames(in_parts);
    folder_.write("walk.pcap", capture_of(all));
    ConversionRequest request;
    request.start = 1;
    request.count = 2;
    EXPECT_EQ(convert(request).scans, 2U);
    expect_from_to(all, kTurn, 3 * kTurn);
  }
}

TEST_F(PacketConversion, EveryOtherScan) {
  for (const bool in_parts : {false, true}) {
    const auto all = frames(in_parts);
    folder_.write("walk.pcap", capture_of(all));
    ConversionRequest request;
    request.stride = 2;
    EXPECT_EQ(convert(request).scans, 3U);
    expect(all, [](const Frame& frame) { return frame.packet < 0 || frame.packet / 75 % 2 == 0; });
  }
}

TEST_F(PacketConversion, ARangeOfTime) {
  const auto all = frames();
  folder_.write("walk.pcap", capture_of(all));
  ConversionRequest request;
  request.begin = 0.15;
  request.end = 0.35;
  EXPECT_EQ(convert(request).scans, 2U);  // those at 0.199 and 0.299 s
  expect_from_to(all, 2 * kTurn, 4 * kTurn);
}

// A packet with the end of one and the beginning of the next goes with both.
TEST_F(PacketConversion, WhatScansShareGoesWithBoth) {
  const auto all = frames();
  folder_.write("walk.pcap", capture_of(all));
  ConversionRequest request;
  request.reader.cut_azimuth_deg = 2.0;
  request.start = request.count = 1;
  (void)convert(request);
  OpenOptions options;
  options.cut_azimuth_deg = 2.0;
  const auto recording = open_recording(folder_.path() / "out.pcap", options);
  std::vector<std::size_t> points;
  while (const auto item = recording->next()) points.push_back(item->scan->points.size());
  ASSERT_EQ(points.size(), 3U);
  EXPECT_LT(points[0], 384U);
  EXPECT_EQ(points[1], 75U * 384U);
  EXPECT_LT(points[2], 384U);
}

TEST_F(PacketConversion, AnOustersMetadataGoWithIt) {
  folder_.write("walk.pcap", capture_of(frames()));
  folder_.write("walk.json", "{\"beam_altitude_angles\": []}");
  EXPECT_NE(convert({}).notes.front().find("out.json"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_.path() / "out.json"));
  EXPECT_NE(convert({}).notes.front().find("is there already and stays"), std::string::npos);
}

TEST_F(PacketConversion, StampsThatPcapCannotSayAreLostWithAWord) {
  const auto all = frames();
  test::PcapngFile file(1, 9);
  for (const Frame& frame : all) file.add(frame.stamp_ns, frame.bytes);
  constexpr std::int64_t kIn2107 = 4'350'000'000'000'000'000;  // [ns]
  file.add(kIn2107, test::ethernet_frame(test::ip_packet("late", 9)));
  folder_.write("walk.pcap", file.content());
  const ConversionOutcome outcome = convert({});
  EXPECT_EQ(outcome.packets, all.size());
  EXPECT_NE(outcome.losses.front().find("1 packets stamped before 1970"), std::string::npos)
      << outcome.losses.front();
}

TEST_F(PacketConversion, WhatIsNoCaptureIsRefused) {
  ConversionRequest request;
  request.input = folder_.write("scan.bin", std::string(160, 'a'));
  const std::string of_points = test::message_of<ReadError>([&] { (void)convert(request); });
  EXPECT_NE(of_points.find("points cannot be turned back into them"), std::string::npos);
  request.input = folder_.path() / "none.pcap";
  const std::string of_none = test::message_of<ReadError>([&] { (void)convert(request); });
  EXPECT_NE(of_none.find("none.pcap: no such file"), std::string::npos) << of_none;
  folder_.write("walk.pcap", capture_of(frames()));
  ConversionRequest late;
  late.begin = 100;
  EXPECT_NE(test::message_of<ReadError>([&] { (void)convert(late); }).find("no scan in what"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder_.path() / "out.pcap"));
}

TEST_F(PacketConversion, InterruptedItWritesNothing) {
  folder_.write("walk.pcap", capture_of(frames()));
  interrupted_ = true;
  const ConversionOutcome outcome = convert({});
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.scans, 0U);
  EXPECT_FALSE(fs::exists(folder_.path() / "out.pcap"));
}

TEST_F(PacketConversion, InterruptedWhileItWritesItKeepsNothing) {
  folder_.write("walk.pcap", capture_of(frames()));
  patience_ = kTurns + 20;  // asked once a scan, then once a frame
  const ConversionOutcome outcome = convert({});
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.scans, kTurns);
  EXPECT_GT(outcome.packets, 0U);
  const fs::directory_iterator left(folder_.path());
  EXPECT_EQ(std::distance(begin(left), end(left)), 1);  // the input
}

}  // namespace
}  // namespace surefoot::io
