// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live on ROS 2's topics, against Fast DDS over the loopback interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "capture.hpp"
#include "fastdds_peer.hpp"
#include "io/recording.hpp"
#include "io/scan_sink.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "ros2_live.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

TEST_F(Ros2Test, AWalkOnATopicGivesWhatItsRecordingGives) {
  const fs::path walk = fs::path(SUREFOOT_SHARED_DATA) / "gait_ramp";
  if (!fs::exists(walk)) GTEST_SKIP() << walk << " is not there";
  std::vector<Scan> scans;
  const auto recording = io::open_recording(walk);
  while (scans.size() < 12) scans.push_back(*recording->next()->scan);
  offline(scans);

  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/velodyne_points", kCloudType);
  const Process process(
      live({"--ros2-topic", "/velodyne_points", "--ros2-qos", "reliable", "--queue", "100",
            "--silence", "1", "--record", "heard.mcap", "-o", "live", "-q"}),
      scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/velodyne_points"));
  for (const Scan& scan : scans) {
    peer.write("rt/velodyne_points", cloud_by_fast_cdr(scan, "velodyne"));
    std::this_thread::sleep_for(milliseconds(30));
  }
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  expect_same("offline", "live");
  expect_repeated("live");
}

TEST_F(Ros2Test, DamagedMessagesByTheThousandHaveNoEffect) {
  const std::vector<Scan> scans = stamped_scans(6);
  offline(scans);
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType);
  const Process process(live({"--ros2-topic", "points", "--ros2-qos", "reliable", "--queue", "100",
                              "--silence", "1", "--record", "heard.mcap", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/points"));
  std::mt19937 random(7);
  std::string small;
  {
    Scan few = scans[0];
    few.points.resize(30);
    few.intensities.clear();
    few.times_ns.clear();
    few.rings.clear();
    small = cloud_by_fast_cdr(few, "lidar");
  }
  const auto damaged = [&](int kind) {
    std::string bytes = small;
    if (kind == 0) bytes.resize(4 + random() % (bytes.size() - 24));  // cut short
    if (kind == 1) {  // a size, an offset or a letter that lies
      for (int k = 0; k < 4; ++k) bytes[4 + random() % 180] = static_cast<char>(random());
      bytes.resize(bytes.size() - 20);
    }
    if (kind == 2) {  // but that it is CDR: Cyclone itself refuses what says something else
      for (std::size_t k = 4; k < bytes.size(); ++k) bytes[k] = static_cast<char>(random());
    }
    return bytes;
  };
  constexpr int kDamagedEach = 200;
  for (const Scan& scan : scans) {
    for (int i = 0; i < kDamagedEach; ++i) {
      peer.write("rt/points", damaged(i % 3));
      if (i % 4 == 0) std::this_thread::sleep_for(milliseconds(1));
    }
    peer.write("rt/points", cloud_by_fast_cdr(scan, "lidar"));
    std::this_thread::sleep_for(milliseconds(40));
  }
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  expect_same("offline", "live");
  EXPECT_NE(result.output.find("1206 messages, 1200 unreadable; 0 lost"), std::string::npos)
      << result;
  EXPECT_NE(result.errors.find("left out: "), std::string::npos) << result;
  expect_repeated("live");
}

/// A driver's packets, a revolution a message, against a capture of the same packets.
TEST_F(Ros2Test, PacketsInMessagesGiveWhatTheirCaptureGives) {
  const std::vector<std::string> packets = vlp16_packets(8);
  write_content(scratch_.path() / "hall.pcap", pcap_file(packets));
  const ProcessResult capture = run_surefoot(
      {"run", "hall.pcap", "-o", "offline", "--no-report", "--no-picture", "-q"}, scratch_.path());
  ASSERT_EQ(capture.exit_code, 0) << capture;

  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/velodyne_packets", "velodyne_msgs::msg::dds_::VelodyneScan_");
  const Process process(
      live({"--ros2-topic", "/velodyne_packets", "--ros2-qos", "reliable", "--queue", "100",
            "--silence", "1", "--record", "heard.mcap", "-o", "live", "-q"}),
      scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/velodyne_packets"));
  constexpr std::size_t kEach = 76;
  for (std::size_t i = 0; i < packets.size(); i += kEach) {
    const auto some = std::span(packets).subspan(i, std::min(kEach, packets.size() - i));
    const auto stamp_ns =
        1'700'000'000'000'000'000 + static_cast<std::int64_t>(i / kEach) * 100'000'000;
    peer.write("rt/velodyne_packets", velodyne_scan_by_fast_cdr(some, stamp_ns));
    std::this_thread::sleep_for(milliseconds(30));
  }
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  // Stamps are those of the messages: all else is the same.
  for (const char* file : {"trajectory_kitti.txt", "map.ply"}) {
    EXPECT_EQ(content(std::string("offline/") + file), content(std::string("live/") + file));
  }
  expect_repeated("live");
}

/// Cyclone refuses it, and of a reliable publisher it would wait for it for ever.
TEST_F(Ros2Test, ASampleThatDoesNotBeginAsCdrHoldsUpNothing) {
  const std::vector<Scan> scans = stamped_scans(6);
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType);
  const Process process(live({"--ros2-topic", "points", "--ros2-qos", "reliable", "--queue", "100",
                              "--silence", "6", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/points"));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i == 3) {
      peer.write("rt/points", std::string(200, 'x'));
      std::this_thread::sleep_for(milliseconds(4000));
    }
    peer.write("rt/points", cloud_by_fast_cdr(scans[i], "lidar"));
    std::this_thread::sleep_for(milliseconds(100));
  }
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("6 scans, 0 dropped"), std::string::npos) << result;
  EXPECT_NE(result.errors.find("does not begin as CDR"), std::string::npos) << result;
}

TEST_F(Ros2Test, WhatItPublishesIsUnderstoodByOthers) {
  const std::vector<Scan> scans = stamped_scans(6);
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType, false);
  peer.add_reader("rt/surefoot/odometry", "nav_msgs::msg::dds_::Odometry_");
  peer.add_reader("rt/surefoot/scan", kCloudType);
  peer.add_reader("rt/surefoot/path", "nav_msgs::msg::dds_::Path_");
  peer.add_reader("rt/tf", "tf2_msgs::msg::dds_::TFMessage_");
  peer.add_reader("rt/diagnostics", "diagnostic_msgs::msg::dds_::DiagnosticArray_");
  peer.add_reader("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_", true,
                  true);
  const Process process(live({"--ros2-topic", "/points", "--ros2-publish", "--ros2-node", "walker",
                              "--queue", "100", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/points"));
  std::this_thread::sleep_for(milliseconds(700));  // until its writers know these readers
  for (const Scan& scan : scans) {
    peer.write("rt/points", cloud_by_fast_cdr(scan, "lidar"));
    std::this_thread::sleep_for(milliseconds(60));
  }
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + scans.size()));
  // Who comes late gets what does not change.
  FastDdsPeer late(own_domain());
  late.add_reader("rt/tf_static", "tf2_msgs::msg::dds_::TFMessage_", true, true);
  std::vector<std::string> fixed;
  for (int i = 0; i < 500 && fixed.empty(); ++i) {
    fixed = late.take("rt/tf_static");
    std::this_thread::sleep_for(milliseconds(10));
  }
  std::this_thread::sleep_for(milliseconds(2200));  // in which nothing comes
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;

  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_NE(fixed[0].find("map"), std::string::npos);
  const std::vector<std::string> odometry = peer.take("rt/surefoot/odometry");
  ASSERT_EQ(odometry.size(), scans.size());
  std::ifstream trajectory(scratch_.path() / "live" / "trajectory.tum");
  for (std::size_t i = 0; i < odometry.size(); ++i) {
    const OdometryFields fields = odometry_by_fast_cdr(odometry[i]);
    EXPECT_EQ(fields.frame, "odom");
    EXPECT_EQ(fields.child_frame, "lidar");
    std::string line;
    do {
      ASSERT_TRUE(std::getline(trajectory, line));
    } while (line.starts_with('#'));
    std::istringstream values(line);
    double value = 0.0;
    values >> value;
    EXPECT_NEAR(static_cast<double>(fields.stamp_ns) * 1e-9, value, 1e-6);
    for (std::size_t k = 0; k < 7; ++k) {
      values >> value;
      EXPECT_NEAR(fields.numbers[k], value, 1e-6) << line;
    }
    if (i > 0) {
      EXPECT_GT(fields.numbers[7], 0.0);  // covariance of x
    }
  }
  EXPECT_EQ(peer.take("rt/surefoot/scan").size(), scans.size());
  EXPECT_EQ(peer.take("rt/tf").size(), scans.size());
  EXPECT_FALSE(peer.take("rt/surefoot/path").empty());
  const std::vector<std::string> health = peer.take("rt/diagnostics");
  EXPECT_GE(health.size(), scans.size());
  EXPECT_TRUE(std::any_of(health.begin(), health.end(), [](const std::string& message) {
    return message.find("no scan for 2 s; 6 scans, 0 dropped") != std::string::npos;
  }));
  const std::vector<std::string> nodes = peer.take("ros_discovery_info");
  ASSERT_FALSE(nodes.empty());
  EXPECT_NE(nodes.back().find("walker"), std::string::npos);

  const std::vector<std::string> participants = peer.participants();
  EXPECT_EQ(std::count(participants.begin(), participants.end(), "enclave=/;"), 1);
  std::map<std::string, Discovered> writers;
  for (const Discovered& writer : peer.writers()) writers[writer.topic] = writer;
  ASSERT_EQ(writers.count("rt/surefoot/odometry"), 1U);
  EXPECT_EQ(writers["rt/surefoot/odometry"].user_data,
            "typehash=RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0;");
  EXPECT_TRUE(writers["rt/surefoot/odometry"].reliable);
  EXPECT_FALSE(writers["rt/surefoot/odometry"].transient_local);
  EXPECT_TRUE(writers["rt/tf_static"].transient_local);
  EXPECT_TRUE(writers["ros_discovery_info"].transient_local);
}

TEST_F(Ros2Test, AGo2WhoseStampsStandStillIsMended) {
  std::vector<Scan> scans = stamped_scans(6);
  const std::int64_t begin_ns = scans[0].stamp_ns;
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/utlidar/cloud", kCloudType);
  const Process process(live({"--robot", "go2", "--ros2-qos", "reliable", "--queue", "100",
                              "--silence", "1", "--record", "heard.mcap", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/utlidar/cloud"));
  for (Scan& scan : scans) {
    scan.stamp_ns = begin_ns;
    peer.write("rt/utlidar/cloud", cloud_by_fast_cdr(scan, "utlidar_lidar"));
    if (&scan == &scans[2]) {  // once more
      peer.write("rt/utlidar/cloud", cloud_by_fast_cdr(scan, "utlidar_lidar"));
    }
    std::this_thread::sleep_for(milliseconds(130));
  }
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.errors.find("they stand still"), std::string::npos) << result;
  EXPECT_NE(result.errors.find("sent again"), std::string::npos) << result;
  std::ifstream log(scratch_.path() / "live" / "live.log");
  std::string line;
  std::vector<std::int64_t> stamps;
  std::getline(log, line);
  while (std::getline(log, line)) stamps.push_back(std::stoll(line));
  ASSERT_EQ(stamps.size(), scans.size());
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    // As many periods as the receipts say: one, or two where this machine was busy.
    EXPECT_EQ((stamps[i] - stamps[i - 1]) % 130'000'000, 0) << i;
    EXPECT_GT(stamps[i], stamps[i - 1]);
  }
  expect_repeated("live");
}

TEST_F(Ros2Test, WhatIsMissingIsNamed) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& text) {
    const ProcessResult result = run_surefoot(arguments, scratch_.path());
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE((result.output + result.errors).find(text), std::string::npos) << result;
  };
  expect({"live", "--ros2-publish"},
         "expected --udp PORT, --replay FILE, --follow FILE or --ros2-topic TOPIC");
  expect({"live", "--ros2-topic", "/points", "--ros2-interface", "none0"},
         "on none0: none0: does not match an available interface");
  expect({"live", "--ros2-topic", "/points", "--ros2-domain", "300"}, "--ros2-domain");
  expect({"live", "--ros2-topic", "/points", "--ros2-qos", "best"}, "best_effort");
  expect(live({"--ros2-topic", "/my points"}), "got '/my points', expected a name such as");
  expect(live({"--ros2-topic", "/points", "--record", "heard.pcap"}), "expects FILE.mcap");

  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType);
  peer.add_writer("rt/imu", "sensor_msgs::msg::dds_::Imu_");
  peer.add_reader("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_", true,
                  true);
  // Who is told of a node is not yet known to it; on a busy machine that takes its time.
  const auto wait_for_node = [&](milliseconds after) {
    std::vector<std::string> nodes;
    for (int i = 0; i < 500 && nodes.empty(); ++i) {
      nodes = peer.take("ros_discovery_info");
      std::this_thread::sleep_for(milliseconds(10));
    }
    std::this_thread::sleep_for(after);
  };
  ProcessResult result;
  for (const int after : {500, 2000, 8000}) {
    const Process process(live({"--ros2-topic", "/cloud"}), scratch_.path());
    wait_for_node(milliseconds(after));
    process.send(SIGTERM);
    result = process.wait();
    if (result.errors.find("0 others") == std::string::npos) break;
  }
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_NE(result.errors.find("ROS 2 topic /cloud (domain " + std::to_string(own_domain()) +
                               "): 0 messages, no scan among them; topics that scans can be made "
                               "of:\n  /points (sensor_msgs/PointCloud2, reliable)"),
            std::string::npos)
      << result;

  // Before Iron a GID was of 24 bytes, and no type told its hash.
  peer.add_writer("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_");
  const Process among_older(live({"--ros2-topic", "/cloud"}), scratch_.path());
  std::string told;
  const auto is_older = [&] { return told.size() > 32 && told[4 + 16] == 0 && told[4 + 24] == 1; };
  for (int i = 0; i < 500 && !is_older(); ++i) {
    for (const std::string& one : peer.take("ros_discovery_info")) told = one;
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_TRUE(is_older());
  among_older.send(SIGTERM);
  EXPECT_EQ(among_older.wait().exit_code, 2);
  expect(live({"--ros2-topic", "/imu"}), "it is a sensor_msgs/Imu, of which no scans can be made");
}

}  // namespace
}  // namespace surefoot::test
