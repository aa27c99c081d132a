// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Bags of a sensor's packets, as its driver's messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/recording.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

// A ROS 1 bag of Ouster's packets, whose metadata are a message of another topic.
TEST(BagRecording, OusterPacketsWithTheMetadataOfTheBag) {
  const fs::path file = fs::path(SUREFOOT_SHARED_DATA) / "ouster_os1/512x10_raw.bag";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto recording = open_recording(file);
  EXPECT_NE(recording->description().find("packets of OS-0-128"), std::string::npos)
      << recording->description();
  const auto item = recording->next();
  ASSERT_TRUE(item.has_value() && item->scan.has_value());
  EXPECT_EQ(item->scan->points.size(), 28'751U);
}

// The real bag's messages as a ROS 2 bag: `before` copies of the first packet, then the metadata.
fs::path write_ouster_bag(const fs::path& file, int before, bool with_metadata) {
  const auto source = open_bag(fs::path(SUREFOOT_SHARED_DATA) / "ouster_os1/512x10_raw.bag");
  const auto messages = test::read_all_messages(*source);
  const auto bag = make_mcap_bag(file);
  std::map<std::string, std::size_t> topics;
  const auto write = [&](const test::ReadMessage& message) {
    MessageDefinition definition;
    definition.type = message.type;
    if (topics.count(message.topic) == 0) {
      topics[message.topic] = bag->add_topic(message.topic, definition);
    }
    bag->write(topics[message.topic], message.logged_ns, std::string("\0\1\0\0", 4) + message.data);
  };
  const auto is_metadata = [](const auto& m) { return m.topic.ends_with("metadata"); };
  const auto first = std::find_if(messages.begin(), messages.end(), [](const auto& message) {
    return message.topic.ends_with("lidar_packets");
  });
  for (int i = 0; i < before; ++i) write(*first);  // all at once: repeats are passed over
  for (const auto& message : messages) {
    if (is_metadata(message) && with_metadata) write(message);
  }
  for (const auto& message : messages) {
    if (!is_metadata(message)) write(message);
  }
  bag->finish();
  return file;
}

// A driver publishes metadata once, and rosbag may subscribe to it last.
TEST(BagRecording, OusterPacketsBeforeTheirMetadata) {
  const fs::path file = fs::path(SUREFOOT_SHARED_DATA) / "ouster_os1/512x10_raw.bag";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const test::TemporaryFolder folder;
  const auto recording = open_recording(write_ouster_bag(folder.path() / "a.mcap", 3000, true));
  const auto item = recording->next();
  ASSERT_TRUE(item.has_value() && item->scan.has_value());
  EXPECT_EQ(item->scan->points.size(), 28'751U);

  const fs::path without = write_ouster_bag(folder.path() / "b.mcap", 0, false);
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(without); });
  EXPECT_NE(message.find("whose metadata (JSON) is not here: give it with --calibration"),
            std::string::npos)
      << message;
}

TEST(BagSurvey, MetadataAreThoseOfTheSensorThatThePacketsAreOf) {
  BagSurvey survey;
  EXPECT_EQ(survey.metadata_for("/front/lidar_packets"), "");
  survey.metadata = {{"/front/metadata", "f"}, {"/rear/metadata", "r"}};
  EXPECT_EQ(survey.metadata_for("/front/lidar_packets"), "f");
  EXPECT_EQ(survey.metadata_for("/rear/lidar_packets"), "r");
}

struct RealBag {
  const char* folder;
  const char* sensor;
  std::size_t whole_scans;
  std::size_t least_points;
};

// rosbag2 files of drivers' packet messages: VelodyneScan and PandarScan.
TEST(BagRecording, PacketsOfRealSensors) {
  for (const RealBag& real :
       {RealBag{"vlp16_dual_nebula/1673400471837873222", "VLP-16", 3, 14'000},
        RealBag{"hesai_xt16_nebula/1732848127890747768", "XT-16", 3, 14'000}}) {
    const fs::path folder = fs::path(SUREFOOT_SHARED_DATA) / real.folder;
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const auto recording = open_recording(folder);
    EXPECT_NE(recording->description().find(real.sensor), std::string::npos)
        << recording->description();
    std::size_t whole = 0;
    std::int64_t last_late_ns = 0;
    while (const auto item = recording->next()) {
      ASSERT_TRUE(item->scan.has_value()) << item->error;
      if (!item->remark.empty()) continue;
      ++whole;
      EXPECT_GT(item->scan->points.size(), real.least_points);
      // It came when its last packets did, by a clock of another year.
      const std::int64_t late_ns = item->logged_ns - item->scan->stamp_ns;
      const double later = static_cast<double>(late_ns - last_late_ns);
      EXPECT_LT(whole > 1 ? std::abs(later) : 0.0, 5e7) << item->name;
      last_late_ns = late_ns;
    }
    EXPECT_GE(whole, real.whole_scans) << real.sensor;
    EXPECT_EQ(recording->capture_counts().lost, 0U) << real.sensor;
  }
}

// A VelodyneScan that is cut within its second packet: the message is named, the others are used.
TEST(BagRecording, DamagedPacketMessageIsNamed) {
  const fs::path folder = fs::path(SUREFOOT_SHARED_DATA) / "vlp16_dual_nebula/1673400471837873222";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const test::TemporaryFolder scratch;
  const auto bag = make_mcap_bag(scratch.path() / "a.mcap");
  MessageDefinition definition;
  definition.type = "velodyne_msgs/VelodyneScan";
  const std::size_t topic = bag->add_topic("/velodyne_packets", definition);
  const auto source = open_bag(folder);
  for (int i = 0; const auto message = source->next(); ++i) {
    std::string bytes(reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size());
    if (i == 1) bytes.resize(2000);
    bag->write(topic, message->logged_ns, bytes);
  }
  bag->finish();
  const auto recording = open_recording(scratch.path() / "a.mcap");
  std::size_t errors = 0;
  std::size_t scans = 0;
  while (const auto item = recording->next()) {
    if (item->scan) {
      ++scans;
      continue;
    }
    ++errors;
    EXPECT_NE(item->error.find("message 1"), std::string::npos) << item->error;
  }
  EXPECT_EQ(errors, 1U);
  EXPECT_GE(scans, 3U);
}

}  // namespace
}  // namespace surefoot::io
