// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A topic's messages as scans, from a source that is no network.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "io/messages/point_cloud2_writer.hpp"
#include "live/live_recording.hpp"
#include "live/scan_stream.hpp"
#include "support/scratch.hpp"

namespace surefoot::live {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 1'700'000'000 * kSecond;

std::string cloud(std::int64_t stamp_ns, bool with_times) {
  Scan scan;
  scan.stamp_ns = stamp_ns;
  for (int i = 0; i < 50; ++i) {
    scan.points.emplace_back(1.0F, static_cast<float>(i), static_cast<float>(stamp_ns % 997));
    if (with_times) scan.times_ns.push_back(i * 2'000'000);
  }
  return io::format_point_cloud2(scan, "lidar", io::MessageWriter::Flavour::cdr);
}

class Messages final : public TopicSource {
 public:
  explicit Messages(std::deque<std::string> messages) : messages_(std::move(messages)) {}
  Received receive(TopicArrival& arrival) override {
    if (messages_.empty()) return Received::end;
    const auto* const bytes = reinterpret_cast<const std::byte*>(messages_.front().data());
    arrival.bytes.assign(bytes, bytes + messages_.front().size());
    arrival.arrival_ns = kStart + kSecond / 10 * ++given_;
    arrival.received = first_received() + std::chrono::milliseconds(given_);
    messages_.pop_front();
    return Received::something;
  }
  std::uint64_t lost() const override { return 5; }
  /// A millisecond before the first message.
  static std::chrono::steady_clock::time_point first_received() {
    return std::chrono::steady_clock::time_point(std::chrono::hours(1));
  }
  const io::Topic& topic() const override { return topic_; }
  std::string name() const override { return "topic /points"; }
  std::string others() const override { return "; nobody else is there"; }

 private:
  std::deque<std::string> messages_;
  io::Topic topic_ = {"/points", "sensor_msgs/PointCloud2", io::MessageEncoding::cdr};
  std::int64_t given_ = 0;
};

struct Streamed {
  std::vector<io::ScanItem> items;
  std::string nothing;
  /// How many messages were asked for when the first scan came.
  std::size_t asked_first = 0;
};

Streamed streamed(std::deque<std::string> messages, const std::filesystem::path& record = {}) {
  const auto stream = topic_stream(std::make_unique<Messages>(std::move(messages)), {}, record);
  Streamed result;
  while (std::optional<LiveScan> scan = stream->next([] { return true; })) {
    if (result.items.empty()) result.asked_first = stream->state().received;
    result.items.push_back(std::move(scan->item));
  }
  result.nothing = stream->nothing_text();
  return result;
}

std::deque<std::string> clouds(int count, bool with_times) {
  std::deque<std::string> messages;
  for (int i = 0; i < count; ++i) messages.push_back(cloud(kStart + i * kSecond / 10, with_times));
  return messages;
}

TEST(TopicStream, GivesAScanAsSoonAsItsMessageCame) {
  for (const bool with_times : {true, false}) {
    const Streamed result = streamed(clouds(30, with_times));
    ASSERT_EQ(result.items.size(), 30U) << with_times;
    EXPECT_EQ(result.asked_first, 1U) << with_times;
    for (std::size_t i = 0; i < result.items.size(); ++i) {
      EXPECT_EQ(result.items[i].scan->stamp_ns,
                kStart + static_cast<std::int64_t>(i) * kSecond / 10);
    }
  }
}

/// Two clouds a second of two points, the first and the last that a sweep takes.
std::deque<std::string> sweeps(int count, double first_s, double last_s, bool is_absolute,
                               int begin = 0) {
  std::deque<std::string> messages;
  for (int i = begin; i < begin + count; ++i) {
    const double start_s = is_absolute ? i / 2.0 : 0.0;
    const std::array<double, 2> times = {start_s + first_s, start_s + last_s};
    const std::array<float, 2> places = {1.0F, 2.0F};
    std::vector<io::Column> columns;
    const auto column = [](const char* name, io::ScalarType type, const auto& values) {
      return io::Column{name, type, reinterpret_cast<const std::byte*>(values.data()),
                        sizeof(values[0])};
    };
    for (const char* name : {"x", "y", "z"}) {
      columns.push_back(column(name, io::ScalarType::f32, places));
    }
    columns.push_back(column("time", io::ScalarType::f64, times));
    messages.push_back(io::format_point_cloud2({kStart + i * kSecond / 2, "lidar"}, columns, 2,
                                               io::MessageWriter::Flavour::cdr));
  }
  return messages;
}

// More would push each other out of a live run's queue.
TEST(TopicStream, TwoMessagesTellWhatOneLeavesOpen) {
  const auto asked_first = [](const std::deque<std::string>& messages) {
    const Streamed result = streamed(messages);
    EXPECT_EQ(result.items.size(), messages.size());
    EXPECT_EQ(result.items.back().error, "");
    return result.asked_first;
  };
  EXPECT_EQ(LiveOptions{}.queue, 2U);
  EXPECT_EQ(asked_first(sweeps(30, 0.0, 0.2, false)), 2U) << "a scan, or a packet in milliseconds";
  EXPECT_EQ(asked_first(sweeps(30, 50.0, 50.1, true)), 2U) << "a clock of its own";
  EXPECT_EQ(asked_first(sweeps(30, 0.0, 0.0, false)), 2U) << "no times";
}

// A sensor whose times are zeros until it knows them.
TEST(TopicStream, TimesThatComeLaterAreRead) {
  std::deque<std::string> messages = sweeps(6, 0.0, 0.0, false);
  const std::deque<std::string> timed = sweeps(6, 0.0, 0.1, false, 6);
  messages.insert(messages.end(), timed.begin(), timed.end());
  const Streamed result = streamed(messages);
  ASSERT_EQ(result.items.size(), 12U);
  EXPECT_EQ(result.items.back().scan->times_ns, (std::vector<std::int32_t>{0, 100'000'000}));
}

// A run's latencies begin with it, and its silence.
TEST(TopicStream, TellsWhenTheMessageCameAndWhatWasLost) {
  const auto stream = topic_stream(std::make_unique<Messages>(clouds(4, true)), {}, {});
  EXPECT_FALSE(stream->last().has_value());
  for (int i = 1; i <= 4; ++i) {
    const std::optional<LiveScan> scan = stream->next([] { return true; });
    ASSERT_TRUE(scan.has_value());
    const auto came = Messages::first_received() + std::chrono::milliseconds(i);
    EXPECT_EQ(scan->received, came);
    EXPECT_EQ(stream->last(), came);
  }
  EXPECT_EQ(stream->state().lost, 5U);
  EXPECT_EQ(stream->state().received, 4U);
  EXPECT_EQ(stream->state().description,
            "live from topic /points, topic /points (sensor_msgs/PointCloud2)");
}

TEST(TopicStream, EndsWhereItIsToldTo) {
  const auto stream = topic_stream(std::make_unique<Messages>(clouds(9, true)), {}, {});
  int asked = 0;
  const auto three_times = [&asked] { return ++asked <= 3; };
  int scans = 0;
  while (stream->next(three_times)) ++scans;
  EXPECT_EQ(scans, 3);
  EXPECT_FALSE(stream->next([] { return true; }).has_value()) << "for good";
  EXPECT_EQ(stream->state().received, 3U);
  const auto never = topic_stream(std::make_unique<Messages>(clouds(9, true)), {}, {});
  EXPECT_FALSE(never->next([] { return false; }).has_value());
  EXPECT_EQ(never->state().received, 0U);
}

class TopicStreamRecord : public test::Scratch {};

TEST_F(TopicStreamRecord, IsOfTheKindThatItsNameSays) {
  for (const auto& [name, begin] :
       {std::pair("heard.bag", "#ROSBAG V2.0"), {"heard.mcap", "MCAP"}}) {
    (void)streamed(clouds(3, true), folder_ / name);
    std::ifstream in(folder_ / name, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_LT(text.substr(0, 20).find(begin), 2U) << name;
  }
}

TEST_F(TopicStreamRecord, GivesTheSame) {
  const std::filesystem::path file = folder_ / "heard.mcap";
  std::deque<std::string> messages = clouds(10, true);
  messages[4].resize(100);
  const Streamed live = streamed(messages, file);
  const auto recording = io::open_recording(file);
  for (const io::ScanItem& item : live.items) {
    const std::optional<io::ScanItem> again = recording->next();
    ASSERT_TRUE(again.has_value());
    ASSERT_EQ(item.scan.has_value(), again->scan.has_value());
    EXPECT_EQ(item.name, again->name);
    if (!item.scan) continue;
    EXPECT_EQ(item.scan->stamp_ns, again->scan->stamp_ns);
    EXPECT_EQ(item.scan->times_ns, again->scan->times_ns);
    EXPECT_EQ(item.scan->points, again->scan->points);
  }
  EXPECT_FALSE(recording->next().has_value());
}

TEST(TopicStream, SaysWhyThereIsNothing) {
  EXPECT_EQ(streamed({}).nothing,
            "topic /points: 0 messages, no scan among them; nobody else is there");
  std::deque<std::string> messages = clouds(3, true);
  messages.back().resize(100);
  const Streamed some = streamed(messages);
  EXPECT_EQ(some.nothing, "");
  EXPECT_NE(some.items.back().error, "");
}

}  // namespace
}  // namespace surefoot::live
