// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/file_writer.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "io/recording.hpp"
#include "io/scan_sink.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kStart = 1'700'000'000'000'000'000;

Scan scan_at(int i) {
  Scan scan;
  scan.stamp_ns = kStart + i * 100'000'000LL;
  for (int k = 0; k < 50; ++k) {
    scan.points.emplace_back(1.0F + static_cast<float>(i), static_cast<float>(k), 0.5F);
    scan.intensities.push_back(static_cast<float>(k));
    scan.times_ns.push_back(k * 2'000'000);
    scan.rings.push_back(static_cast<std::uint16_t>(k % 16));
  }
  return scan;
}

void expect_scans(Recording& recording, int count) {
  for (int i = 0; i < count; ++i) {
    const std::optional<ScanItem> item = recording.next();
    ASSERT_TRUE(item.has_value() && item->scan.has_value()) << i;
    const Scan expected = scan_at(i);
    EXPECT_EQ(item->scan->stamp_ns, expected.stamp_ns);
    EXPECT_EQ(item->scan->points, expected.points);
    EXPECT_EQ(item->scan->intensities, expected.intensities);
    EXPECT_EQ(item->scan->times_ns, expected.times_ns);
    EXPECT_EQ(item->scan->rings, expected.rings);
  }
  EXPECT_FALSE(recording.next().has_value());
}

fs::path write_scans(const fs::path& path, ScanFormat format, int count) {
  const auto sink = make_scan_sink(path, format);
  for (int i = 0; i < count; ++i) sink->add(scan_at(i));
  sink->finish();
  EXPECT_EQ(sink->lost(), "");
  return path;
}

TEST(BagRecording, EveryContainerGivesTheScansBack) {
  const test::TemporaryFolder folder;
  constexpr int kScans = 4;
  const std::pair<const char*, ScanFormat> kinds[] = {{"a.mcap", ScanFormat::mcap},
                                                      {"bag2", ScanFormat::rosbag2},
                                                      {"a.bag", ScanFormat::ros1_bag},
                                                      {"pcd", ScanFormat::pcd}};
  for (const auto& [name, format] : kinds) {
    SCOPED_TRACE(name);
    expect_scans(*open_recording(write_scans(folder.path() / name, format, kScans)), kScans);
  }
  const std::string mcap = test::content_of(folder.path() / "a.mcap");
  expect_scans(*open_recording(folder.write("z/a.mcap.zstd", compress(Compression::zstd, mcap))),
               kScans);
  expect_scans(*open_recording(folder.path() / "z"), kScans);
}

TEST(BagRecording, ExtensionsInAnyCase) {
  const test::TemporaryFolder folder;
  const fs::path mcap = write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 2);
  fs::rename(mcap, folder.path() / "A.MCAP");
  expect_scans(*open_recording(folder.path() / "A.MCAP"), 2);
}

// What a killed rosbag leaves, what zstd names its files, and files that are called otherwise.
TEST(BagRecording, NamesThatUsersHave) {
  const test::TemporaryFolder folder;
  const fs::path& in = folder.path();
  fs::create_directory(in / "w");
  const std::string ros1 = test::content_of(write_scans(in / "w/a.bag", ScanFormat::ros1_bag, 2));
  const std::string mcap = test::content_of(write_scans(in / "w/a.mcap", ScanFormat::mcap, 2));
  const std::string db3 =
      test::content_of(write_scans(in / "w/b", ScanFormat::rosbag2, 2) / "b_0.db3");
  const auto zstd = [](const std::string& bytes) { return compress(Compression::zstd, bytes); };
  const std::pair<const char*, std::string> files[] = {
      {"a.bag.active", ros1},   {"a.mcap.zst", zstd(mcap)}, {"a.mcap.zstd", zstd(mcap)},
      {"a.db3.zst", zstd(db3)}, {"A.DB3.ZST", zstd(db3)},   {"a.bag.zst", zstd(ros1)},
      {"recording", mcap},      {"a.log", zstd(ros1)},      {"called.bag", mcap},
      {"called.mcap", db3},     {"called.pcd", ros1}};
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    expect_scans(*open_recording(folder.write(name, content)), 2);
  }
  for (const char* name : {"a.bag.active", "a.db3.zst", "a.mcap.zst"}) {
    SCOPED_TRACE(name);
    const std::string below = std::string("only_") + name + "/" + name;
    const fs::path file = folder.write(below, test::content_of(in / name));
    expect_scans(*open_recording(file.parent_path()), 2);
  }
}

TEST(BagRecording, SaysWhatItTook) {
  const test::TemporaryFolder folder;
  const auto recording = open_recording(write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 3));
  EXPECT_EQ(recording->description(),
            "MCAP, profile ros2, topic /points (sensor_msgs/PointCloud2)");
  const std::string notes = test::joined(recording->notes());
  EXPECT_NE(notes.find("nanoseconds relative"), std::string::npos) << notes;
}

TEST(BagRecording, AnotherTopicThanThePresetsIsNotTakenUnsaid) {
  const test::TemporaryFolder folder;
  const fs::path bag = write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 2);
  const auto said = [&](const OpenOptions& options) {
    const auto recording = open_recording(bag, options);
    for (const std::string& note : recording->notes()) {
      if (note.starts_with("topic: ")) return note;
    }
    return std::string();
  };
  OpenOptions options;
  options.dataset = "leg-kilo";
  EXPECT_EQ(
      said(options),
      "topic: leg-kilo has /points_raw, this bag has no scans there; /points is taken instead");
  options.topic = "/points";
  EXPECT_EQ(said(options), "");
  EXPECT_EQ(said({}), "");
}

TEST(BagRecording, ARobotsOwnTopicIsNotReplacedByAnother) {
  const test::TemporaryFolder folder;
  const fs::path bag = write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 2);
  OpenOptions options;
  options.robot = "go2";
  const std::string error =
      test::message_of<ReadError>([&] { (void)open_recording(bag, options); });
  EXPECT_NE(error.find("no topic '/utlidar/cloud'"), std::string::npos) << error;
  options.topic = "/points";
  EXPECT_TRUE(open_recording(bag, options)->next().has_value());
}

TEST(BagRecording, OfTwoSensorsOnATopicTheFirstIsRead) {
  const test::TemporaryFolder folder;
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  for (int i = 0; i < 6; ++i) {
    const char* frame = i % 2 == 0 ? "front" : "rear";
    bag->write(topic, i, format_point_cloud2(scan_at(i), frame, MessageWriter::Flavour::cdr));
  }
  bag->finish();
  const auto recording = open_recording(folder.path() / "a.mcap");
  recording->skip(1);
  for (const int i : {2, 4}) {
    const auto item = recording->next();
    ASSERT_TRUE(item.has_value() && item->scan.has_value());
    EXPECT_EQ(item->scan->stamp_ns, scan_at(i).stamp_ns);
  }
  EXPECT_FALSE(recording->next().has_value());
  const std::string notes = test::joined(recording->notes());
  EXPECT_NE(notes.find("frame 'front' is read; left out: frame 'rear'"), std::string::npos)
      << notes;
  ASSERT_EQ(recording->losses().size(), 1U);
  EXPECT_EQ(recording->losses().front(), "3 messages of other sensors on the topic left out");
}

TEST(BagRecording, PointsOfAWorldsFrameAreNoScans) {
  const test::TemporaryFolder folder;
  const auto noted = [&](const char* topic, const char* frame) {
    const auto bag = make_mcap_bag(folder.path() / "a.mcap");
    bag->write(bag->add_topic(topic, point_cloud2_definition()), 0,
               format_point_cloud2(scan_at(0), frame, MessageWriter::Flavour::cdr));
    bag->finish();
    const auto recording = open_recording(folder.path() / "a.mcap");
    return test::joined(recording->notes()).find("no scans as measured") != std::string::npos;
  };
  EXPECT_TRUE(noted("/points", "odom"));
  EXPECT_TRUE(noted("/points", "robot/camera_init"));
  EXPECT_TRUE(noted("/utlidar/cloud_deskewed", "lidar"));
  EXPECT_TRUE(noted("/cloud_registered", "lidar"));
  EXPECT_FALSE(noted("/points", "mapping_lidar"));
  EXPECT_FALSE(noted("/camera/depth_registered/points", "camera"));
  EXPECT_FALSE(noted("/unregistered_scan", "lidar"));
}

TEST(BagRecording, SkipAndMessagesThatAreBad) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  for (int i = 0; i < 4; ++i) {
    std::string message = format_point_cloud2(scan_at(i), "lidar", MessageWriter::Flavour::cdr);
    if (i == 0 || i == 2) message.resize(400);
    bag->write(topic, i, message);
  }
  bag->finish();
  const auto recording = open_recording(file);
  const auto bad = recording->next();
  ASSERT_TRUE(bad.has_value());
  EXPECT_FALSE(bad->scan.has_value());
  EXPECT_NE(bad->error.find("a.mcap: /points, message 0: 1100 bytes of points announced"),
            std::string::npos)
      << bad->error;
  recording->skip(2);
  const auto good = recording->next();
  ASSERT_TRUE(good.has_value() && good->scan.has_value());
  EXPECT_EQ(good->scan->stamp_ns, scan_at(3).stamp_ns);
  EXPECT_EQ(good->name, "message 3");
}

// Half a millisecond of nanoseconds, or half a second of microseconds: the next messages tell.
TEST(BagRecording, TheFirstMessageMayBeOnePacket) {
  const test::TemporaryFolder folder;
  const auto sink = make_scan_sink(folder.path() / "a.mcap", ScanFormat::mcap);
  Scan first = scan_at(0);
  for (std::int32_t& time : first.times_ns) time /= 200;
  sink->add(first);
  sink->add(scan_at(1));
  sink->finish();
  const auto recording = open_recording(folder.path() / "a.mcap", {});
  EXPECT_EQ(recording->next()->scan->times_ns, first.times_ns);
  EXPECT_EQ(recording->next()->scan->times_ns, scan_at(1).times_ns);
}

// The only one: Livox's offsets are nanoseconds by definition.
TEST(BagRecording, LivoxOffsetsAreNanosecondsHoweverShortAScanIs) {
  const test::TemporaryFolder folder;
  MessageWriter message;
  message.header(kStart, "livox");
  message.number(static_cast<std::uint64_t>(kStart)).number(std::uint32_t{2});
  message.number(std::uint32_t{0}).number(std::uint32_t{2});
  for (const std::uint32_t offset : {0U, 475'000U}) {
    message.number(offset).number(1.0F).number(2.0F).number(3.0F);
    for (int i = 0; i < 3; ++i) message.number(std::uint8_t{1});
  }
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  bag->write(bag->add_topic("/livox", {"livox_ros_driver2/CustomMsg", "", "", ""}), kStart,
             message.take());
  bag->finish();
  const auto recording = open_recording(folder.path() / "a.mcap", {});
  EXPECT_EQ(recording->next()->scan->times_ns, (std::vector<std::int32_t>{0, 475'000}));
}

TEST(BagRecording, StampsOfZeroAreReplacedByTheBags) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  Scan scan = scan_at(0);
  scan.stamp_ns = 0;
  bag->write(topic, kStart, format_point_cloud2(scan, "lidar", MessageWriter::Flavour::cdr));
  bag->finish();
  EXPECT_EQ(open_recording(file)->next()->scan->stamp_ns, kStart);
}

TEST(BagRecording, TimesThatAreLeftOutNeedFitNoRule) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  Scan scan = scan_at(0);
  for (std::size_t i = 0; i < scan.times_ns.size(); ++i) {
    scan.times_ns[i] = 100 * static_cast<int>(i);
  }
  bag->write(topic, kStart, format_point_cloud2(scan, "lidar", MessageWriter::Flavour::cdr));
  bag->finish();
  EXPECT_THROW((void)open_recording(file), ReadError);
  OpenOptions options;
  options.time_direction = TimeDirection::none;
  const auto item = open_recording(file, options)->next();
  ASSERT_TRUE(item && item->scan);
  EXPECT_EQ(item->scan->points.size(), scan.points.size());
  EXPECT_TRUE(item->scan->times_ns.empty());
}

fs::path two_topics(const test::TemporaryFolder& folder) {
  const fs::path file = folder.path() / "two.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t front = bag->add_topic("/front", point_cloud2_definition());
  const std::size_t rear = bag->add_topic("/rear\nlidar", point_cloud2_definition());
  bag->add_topic("/path", path_definition());
  for (int i = 0; i < 5; ++i) {
    const std::int64_t stamp = scan_at(i).stamp_ns;
    bag->write(front, stamp, format_point_cloud2(scan_at(i), "f", MessageWriter::Flavour::cdr));
    bag->write(rear, stamp, format_point_cloud2(scan_at(i), "r", MessageWriter::Flavour::cdr));
  }
  bag->finish();
  return file;
}

TEST(BagRecording, SeveralTopicsAreListedWithTheWayToTakeEach) {
  const test::TemporaryFolder folder;
  const fs::path file = two_topics(folder);
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(file); });
  for (const char* part :
       {"2 topics", "/front  sensor_msgs/PointCloud2  10.0 Hz  frame f  50 points",
        "--topic /front\n", "--topic '/rear?lidar'"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }
  OpenOptions options;
  options.topic = "/front";
  expect_scans(*open_recording(file, options), 5);
  options.topic = "/none";
  EXPECT_NE(
      test::message_of<ReadError>([&] { (void)open_recording(file, options); }).find("no topic"),
      std::string::npos);
}

// As /tf_static of a node whose clock stood at zero.
TEST(BagRecording, AMessageOfLongBeforeDoesNotHideASecondLidar) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  bag->write(bag->add_topic("/tf_static", {"tf2_msgs/TFMessage", "", "", ""}), 0, "once");
  for (const char* name : {"/front", "/rear"}) {
    bag->write(bag->add_topic(name, point_cloud2_definition()), kStart,
               format_point_cloud2(scan_at(0), "lidar", MessageWriter::Flavour::cdr));
  }
  bag->finish();
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(file); });
  EXPECT_NE(message.find("2 topics"), std::string::npos) << message;
}

// It begins when the bag's first seconds, in which another topic could be taken, are over.
TEST(BagRecording, TopicThatIsAskedForMayBeginLate) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t early = bag->add_topic("/early", point_cloud2_definition());
  const std::size_t late = bag->add_topic("/late", point_cloud2_definition());
  for (int i = 0; i < 60; ++i) {
    const std::string message =
        format_point_cloud2(scan_at(i), "lidar", MessageWriter::Flavour::cdr);
    bag->write(i < 50 ? early : late, scan_at(i).stamp_ns, message);
  }
  bag->finish();
  OpenOptions options;
  options.topic = "/late";
  const auto item = open_recording(file, options)->next();
  ASSERT_TRUE(item.has_value() && item->scan.has_value());
  EXPECT_EQ(item->scan->stamp_ns, scan_at(50).stamp_ns);
}

TEST(BagRecording, TopicThatBeginsTooLateToBeListedIsNotedAtTheEnd) {
  const test::TemporaryFolder folder;
  const auto write = [](BagWriter& bag) {
    const std::size_t early = bag.add_topic("/early", point_cloud2_definition());
    for (int i = 0; i < 60; ++i) {
      const std::size_t topic = i < 50 ? early : bag.add_topic("/late", point_cloud2_definition());
      bag.write(topic, scan_at(i).stamp_ns,
                format_point_cloud2(scan_at(i), "lidar", MessageWriter::Flavour::cdr));
    }
    bag.finish();
  };
  write(*make_mcap_bag(folder.path() / "a.mcap"));
  const auto recording = open_recording(folder.path() / "a.mcap");
  while (recording->next()) {
  }
  EXPECT_NE(test::joined(recording->notes()).find("first seconds: /late (--topic takes one)"),
            std::string::npos)
      << test::joined(recording->notes());
}

TEST(BagRecording, WhatReadingLostIsToldApart) {
  const test::TemporaryFolder folder;
  const fs::path file = write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 3);
  const auto losses_of = [](const fs::path& path) {
    const auto recording = open_recording(path);
    while (recording->next()) {
    }
    return recording->losses();
  };
  EXPECT_TRUE(losses_of(file).empty());
  const std::string bytes = test::content_of(file);
  const auto losses = losses_of(folder.write("b.mcap", bytes + bytes));
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_NE(losses[0].find("goes on after its end"), std::string::npos) << losses[0];
}

TEST(ScanSink, StampsThatTheFormatCannotHoldAreRefused) {
  const test::TemporaryFolder folder;
  Scan scan = scan_at(0);
  scan.stamp_ns = -5'000'000'000;
  const auto ros1 = make_scan_sink(folder.path() / "a.bag", ScanFormat::ros1_bag);
  const std::string refusal = ros1->refusal(scan);
  EXPECT_NE(refusal.find("stamped -5.000000000 s; ROS 1"), std::string::npos) << refusal;
  const auto ros2 = make_scan_sink(folder.path() / "a.mcap", ScanFormat::mcap);
  EXPECT_EQ(ros2->refusal(scan), "");
  scan.stamp_ns = 2'200'000'000'000'000'000;  // 2039
  EXPECT_NE(ros2->refusal(scan), "");
  EXPECT_EQ(ros1->refusal(scan), "");
}

TEST(BagRecording, AStampOfZeroAmongOthersIsSaid) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const auto bag = make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  for (int i = 0; i < 20; ++i) {
    Scan scan = scan_at(i);
    if (i == 1) scan.stamp_ns = 0;
    scan.times_ns.assign(scan.times_ns.size(), 0);
    bag->write(topic, scan_at(i).stamp_ns,
               format_point_cloud2(scan, "lidar", MessageWriter::Flavour::cdr));
  }
  bag->finish();
  const std::string notes = test::joined(open_recording(file)->notes());
  EXPECT_NE(notes.find("as in 1 of the first 2,"), std::string::npos) << notes;
}

TEST(BagRecording, RefusalTellsWhatReadingMet) {
  const test::TemporaryFolder folder;
  const fs::path file = write_scans(folder.path() / "a.mcap", ScanFormat::mcap, 1);
  const std::string cut = test::content_of(file).substr(0, 300);
  const fs::path half = folder.write("half.mcap", cut);
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(half); });
  EXPECT_NE(message.find("holds no message\nnote: the file is cut short"), std::string::npos)
      << message;
}

TEST(BagRecording, BagsWithoutScansAreRefused) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  make_mcap_bag(file)->finish();
  EXPECT_NE(
      test::message_of<ReadError>([&] { (void)open_recording(file); }).find("holds no message"),
      std::string::npos);
}

}  // namespace
}  // namespace surefoot::io
