// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot_ros1 among ROS 1's own programs: its master, rosbag play and record, rosservice.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "io/bags/byte_stream.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/messages/message_reader.hpp"
#include "io/scan_sink.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "same_files.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr const char* kPlay = "/usr/lib/rosbag/play";
constexpr const char* kRecord = "/usr/lib/rosbag/record";

/// A program of ROS that runs as long as the object is there, in a folder of its own.
class RosProgram {
 public:
  RosProgram(const fs::path& scratch, const std::string& program,
             const std::vector<std::string>& arguments)
      : folder_(scratch / ("of_" + fs::path(program).filename().string())) {
    fs::create_directories(folder_);
    Surroundings surroundings;
    surroundings.program = program;
    process_ = std::make_unique<Process>(arguments, folder_, surroundings);
  }
  ~RosProgram() {
    if (process_) (void)end();
  }
  RosProgram(const RosProgram&) = delete;
  RosProgram& operator=(const RosProgram&) = delete;

  /// rosbag closes its file, the master leaves.
  ProcessResult end() {
    process_->send(SIGINT);
    return wait();
  }
  ProcessResult wait() { return std::exchange(process_, nullptr)->wait(); }

 private:
  fs::path folder_;
  std::unique_ptr<Process> process_;
};

/// What an odometry says, whatever it is written in.
std::vector<std::vector<double>> odometry_of(io::MessageSource& bag) {
  std::vector<std::vector<double>> all;
  while (const auto message = bag.next()) {
    if (message->topic->name != "/surefoot/odometry") continue;
    io::MessageReader reader(message->topic->encoding, message->bytes);
    const io::MessageHeader header = io::read_header(reader);
    EXPECT_EQ(header.frame, "odom");
    EXPECT_EQ(reader.string("child"), "lidar");
    std::vector<double> values = {static_cast<double>(header.stamp_ns)};
    for (int i = 0; i < 7 + 36 + 6 + 36; ++i) values.push_back(reader.number<double>("value"));
    all.push_back(values);
  }
  return all;
}

class Ros1Test : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kPlay) || !fs::exists("/usr/bin/rosmaster") ||
        !fs::exists("/usr/bin/rosservice")) {
      GTEST_SKIP()
          << "no ROS 1 to play a bag: python3-rosmaster, python3-rosbag, python3-rosservice";
    }
    const std::string port = std::to_string(20'000 + ::getpid() % 10'000);
    ::setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
    ::setenv("ROS_IP", "127.0.0.1", 1);
    ::setenv("ROS_HOME", (scratch_.path() / "ros").c_str(), 1);
    master_ = std::make_unique<RosProgram>(scratch_.path(), "/usr/bin/rosmaster",
                                           std::vector<std::string>{"--core", "-p", port});
    for (int i = 0; i < 40; ++i) {  // until it answers
      const ProcessResult asked = node({"--ros1-publish", "--replay", "none.bag"});
      if (asked.errors.find("no master") == std::string::npos) return;
      std::this_thread::sleep_for(milliseconds(100));
    }
    FAIL() << "the master does not answer";
  }

  [[nodiscard]] static Surroundings as_node() {
    Surroundings surroundings;
    surroundings.program = SUREFOOT_ROS1_PROGRAM;
    return surroundings;
  }
  [[nodiscard]] static std::vector<std::string> live(std::vector<std::string> more) {
    std::vector<std::string> arguments = {"live", "--no-report", "--no-picture"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  [[nodiscard]] ProcessResult node(const std::vector<std::string>& more) const {
    return run_surefoot(live(more), scratch_.path(), as_node());
  }
  void write_bag(int scans) const {
    const auto sink = io::make_scan_sink(scratch_.path() / "scans.bag", io::ScanFormat::ros1_bag);
    for (const Scan& scan : hall_scans(scans)) {
      Scan stamped = scan;
      stamped.stamp_ns += 1'700'000'000'000'000'000;
      sink->add(stamped);
    }
    sink->finish();
  }
  [[nodiscard]] std::vector<std::string> play_arguments() const {
    return {"--quiet", "--wait-for-subscribers", "--delay=1.5",
            (scratch_.path() / "scans.bag").string()};
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    return file_content(scratch_.path() / file);
  }
  void expect_same(const std::string& a, const std::string& b) const {
    expect_same_files(scratch_.path() / a, scratch_.path() / b,
                      {"trajectory.tum", "trajectory_kitti.txt", "map.ply"});
  }
  [[nodiscard]] bool wait_for_lines(const std::string& file, std::size_t lines) const {
    for (int i = 0; i < 1500; ++i) {
      if (lines_of(scratch_.path() / file) >= lines) return true;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
  }
  [[nodiscard]] std::string called(const std::string& service) const {
    Surroundings surroundings;
    surroundings.program = "/usr/bin/rosservice";
    surroundings.output = "answer.txt";
    return run_surefoot({"call", service}, scratch_.path(), surroundings).output;
  }

  ScratchFolder scratch_;
  std::unique_ptr<RosProgram> master_;
};

TEST_F(Ros1Test, APlayedBagGivesWhatItGivesOffline) {
  write_bag(15);
  const ProcessResult offline = run_surefoot({"run", "scans.bag", "-o", "offline", "--mcap",
                                              "offline.mcap", "--no-report", "--no-picture", "-q"},
                                             scratch_.path());
  ASSERT_EQ(offline.exit_code, 0) << offline;

  const Process process(live({"--ros1-topic", "points", "--ros1-publish", "--queue", "100",
                              "--silence", "1.5", "--record", "heard.bag", "-o", "live", "-q"}),
                        scratch_.path(), as_node());
  RosProgram record(scratch_.path(), kRecord,
                    {"-q", "-O", (scratch_.path() / "said.bag").string(), "-a"});
  RosProgram play(scratch_.path(), kPlay, play_arguments());
  EXPECT_EQ(play.wait().exit_code, 0);
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  (void)record.end();
  expect_same("offline", "live");

  const auto said =
      io::read_ros1_bag(std::make_unique<io::FileStream>(scratch_.path() / "said.bag"));
  const auto wanted =
      io::read_mcap(std::make_unique<io::FileStream>(scratch_.path() / "offline.mcap"));
  const std::vector<std::vector<double>> poses = odometry_of(*said);
  EXPECT_EQ(poses.size(), 15U);
  EXPECT_EQ(poses, odometry_of(*wanted));
  const std::string bag = content("said.bag");
  for (const char* topic : {"/tf_static", "/tf", "/surefoot/scan", "/surefoot/local_map",
                            "/surefoot/path", "/diagnostics"}) {
    EXPECT_NE(bag.find(std::string("topic=") + topic), std::string::npos) << topic;
  }

  const ProcessResult again =
      run_surefoot({"run", "--config", "live/run.yaml", "-o", "again", "-q"}, scratch_.path());
  EXPECT_EQ(again.exit_code, 0) << again;
  expect_same("live", "again");
}

TEST_F(Ros1Test, ServicesAreDone) {
  write_bag(4);
  const Process process(live({"--ros1-topic", "/points", "--ros1-commands", "-o", "live"}),
                        scratch_.path(), as_node());
  RosProgram(scratch_.path(), kPlay, play_arguments()).wait();
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 4));
  const std::string saved = called("/surefoot/save_map");
  EXPECT_NE(saved.find("success: True"), std::string::npos) << saved;
  EXPECT_NE(saved.find("live/map.ply"), std::string::npos) << saved;
  EXPECT_GT(content("live/map.ply").size(), 1000U);
  EXPECT_NE(called("/surefoot/reset").find("begins anew"), std::string::npos);
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("4 scans, 0 dropped"), std::string::npos) << result;
}

TEST_F(Ros1Test, WhatIsMissingIsNamed) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& text) {
    const ProcessResult result = node(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE((result.output + result.errors).find(text), std::string::npos) << result;
  };
  expect({"--ros1-publish"},
         "expected --udp PORT, --replay FILE, --follow FILE or --ros1-topic TOPIC");
  expect({"--ros1-topic", "/points", "--ros1-master", "http://127.0.0.1:9"},
         "no master answers at http://127.0.0.1:9; start roscore");
  expect({"--ros1-topic", "/points", "--record", "heard.mcap"}, "FILE.bag");
  expect({"--ros1-topic", "/rosout_agg", "--ros1-node", "a b"}, "ROS 1: ");
}

}  // namespace
}  // namespace surefoot::test
