// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A sensor's packets as scans, from a source that is no socket.
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <utility>

#include "live/scan_stream.hpp"
#include "support/scratch.hpp"
#include "unit/io/support.hpp"

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kWholeHour = 1'453'363'200'000'000'000;
constexpr std::int64_t kPacketPeriod = 1'327'104;

class Datagrams final : public DatagramSource {
 public:
  explicit Datagrams(std::deque<std::string> payloads) : payloads_(std::move(payloads)) {}

  Received receive(Arrival& arrival) override {
    pauses_ = !pauses_;
    if (pauses_) return Received::nothing;
    if (payloads_.empty()) return Received::end;
    payload_ = std::move(payloads_.front());
    payloads_.pop_front();
    arrival.datagram = {io::FrameContent::udp, 0xc0a80101, 2368, io::test::bytes_of(payload_)};
    arrival.arrival_ns = kWholeHour + kPacketPeriod * ++given_;
    arrival.received = received(given_);
    return Received::something;
  }
  /// When the `number`th datagram came, from 1.
  static Clock::time_point received(std::int64_t number) {
    return Clock::time_point(std::chrono::hours(1) + std::chrono::milliseconds(number));
  }
  std::uint64_t overflowed() const override { return 3; }
  bool patient() const override { return true; }
  std::string name() const override { return "UDP port 2368"; }
  std::string ended_early() const override { return "the file is cut short"; }

 private:
  std::deque<std::string> payloads_;
  std::string payload_;
  std::int64_t given_ = 0;
  bool pauses_ = false;
};

/// A VLP-16's, of which 75 are a turn.
std::deque<std::string> packets(std::initializer_list<std::pair<unsigned, unsigned>> ranges) {
  std::deque<std::string> payloads;
  for (const auto& [begin, end] : ranges) {
    for (unsigned i = begin; i < end; ++i) {
      payloads.push_back(io::test::vlp16_payload(
          i * 480 % 36000, 40, static_cast<std::uint32_t>(i * kPacketPeriod / 1000), 0x37,
          [](auto, auto) {
            return io::test::Measured{500, 1};
          }));
    }
  }
  return payloads;
}

std::unique_ptr<ScanStream> stream_of(std::deque<std::string> payloads,
                                      const std::filesystem::path& record = {}) {
  return packet_stream(std::make_unique<Datagrams>(std::move(payloads)), {}, "", record);
}

bool always() { return true; }

TEST(PacketStream, AScanCameWhenThePacketThatEndsItCame) {
  const auto stream = stream_of(packets({{0, 80}}));
  EXPECT_FALSE(stream->last().has_value());
  EXPECT_TRUE(stream->patient());
  const std::optional<LiveScan> scan = stream->next(always);
  ASSERT_TRUE(scan.has_value());
  EXPECT_EQ(scan->item.scan->points.size(), 75U * 384U);
  EXPECT_EQ(scan->received, Datagrams::received(76));
  EXPECT_EQ(stream->last(), Datagrams::received(76));
  EXPECT_EQ(stream->state().received, 76U);
  const Clock::time_point before = Clock::now();
  const std::optional<LiveScan> rest = stream->next(always);
  ASSERT_TRUE(rest.has_value());
  EXPECT_GE(rest->received, before) << "only the end tells that nothing more of it comes";
  EXPECT_FALSE(stream->next(always).has_value());
  EXPECT_EQ(stream->nothing_text(), "");
  EXPECT_EQ(stream->state().notes.size(), 4U) << "no packet is missing";
}

TEST(PacketStream, TellsWhatCameAndWhatWasLost) {
  const auto stream = stream_of(packets({{0, 30}, {32, 150}}));
  std::size_t scans = 0;
  while (stream->next(always)) ++scans;
  EXPECT_EQ(scans, 2U);
  const StreamState state = stream->state();
  EXPECT_EQ(state.received, 148U);
  EXPECT_EQ(state.lost, 3U);
  EXPECT_EQ(state.packets.packets, 148U);
  EXPECT_EQ(state.packets.data_packets, 148U);
  EXPECT_EQ(state.packets.lost, 2U);
  EXPECT_EQ(state.description, "VLP-16 live from UDP port 2368, return mode single, strongest");
  ASSERT_EQ(state.notes.size(), 5U);
  EXPECT_EQ(state.notes[0], "return mode: single, strongest");
  EXPECT_EQ(state.notes[2], "by the sensor's clock 2 data packets are missing");
  EXPECT_EQ(state.notes[3], "it ends early: the file is cut short");
  EXPECT_EQ(state.notes[4], "3 datagrams were lost because the socket was full");
}

TEST(PacketStream, WhoEndsItGetsTheScanThatIsBegun) {
  const auto stream = stream_of(packets({{0, 150}}));
  int asked = 0;
  const auto ten_times = [&asked] { return ++asked <= 10; };
  const std::optional<LiveScan> scan = stream->next(ten_times);
  ASSERT_TRUE(scan.has_value());
  EXPECT_EQ(scan->item.scan->points.size(), 5U * 384U) << "every other time there was none";
  EXPECT_FALSE(stream->next(always).has_value());
  EXPECT_EQ(stream->state().received, 5U);
}

TEST(PacketStream, SaysWhyThereIsNothing) {
  const auto nothing = [](std::deque<std::string> payloads) {
    const auto stream = stream_of(std::move(payloads));
    EXPECT_FALSE(stream->next(always).has_value());
    return stream->nothing_text();
  };
  EXPECT_EQ(nothing({}), "UDP port 2368: 0 datagrams, no LiDAR's data packet among them");
  EXPECT_EQ(nothing({"what", "this"}),
            "UDP port 2368: 2 datagrams, no LiDAR's data packet among them; most are of 4 bytes to "
            "port 2368");
}

class PacketStreamRecord : public test::Scratch {};

TEST_F(PacketStreamRecord, LiesInTheFileWhenItsScanIsGiven) {
  const std::filesystem::path file = folder_ / "heard.pcap";
  const auto stream = stream_of(packets({{0, 80}}), file);
  constexpr std::uintmax_t kHeader = 24, kOfEach = 16 + 20 + 8 + 1206;
  EXPECT_EQ(std::filesystem::file_size(file), kHeader);
  ASSERT_TRUE(stream->next(always).has_value());
  EXPECT_EQ(std::filesystem::file_size(file), kHeader + 76 * kOfEach);
  ASSERT_TRUE(stream->next(always).has_value());
  EXPECT_EQ(std::filesystem::file_size(file), kHeader + 80 * kOfEach);
}

}  // namespace
}  // namespace surefoot::live
