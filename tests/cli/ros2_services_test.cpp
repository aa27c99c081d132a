// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live's commands as services of ROS 2, called by Fast DDS over the loopback interface.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "fastdds_peer.hpp"
#include "process.hpp"
#include "recordings.hpp"
#include "ros2_live.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// A call as ROS 2's layer for Cyclone DDS makes it.
std::string request_of(std::int64_t number) {
  constexpr std::uint64_t kClient = 0x0123456789abcdef;
  std::string request("\0\1\0\0", 4);
  request.append(reinterpret_cast<const char*>(&kClient), 8);
  request.append(reinterpret_cast<const char*>(&number), 8);
  return request + '\0';  // what a structure without members has
}

/// The answer's text, "!" before it where the command was not done.
std::string answer_to(const std::string& request, FastDdsPeer& peer, const std::string& command) {
  for (int i = 0; i < 1000; ++i) {
    for (const std::string& reply : peer.take("rr/surefoot/" + command + "Reply")) {
      // Encapsulation, client, number, whether it was done, its text's length and text.
      if (reply.size() < 28 || reply.compare(4, 16, request, 4, 16) != 0) continue;
      std::uint32_t length = 0;
      std::memcpy(&length, reply.data() + 24, 4);
      return (reply[20] == 1 ? "" : "!") + reply.substr(28, length - 1);
    }
    std::this_thread::sleep_for(milliseconds(10));
  }
  return "no answer";
}

std::string called(FastDdsPeer& peer, const std::string& command) {
  static std::int64_t number = 0;
  const std::string request = request_of(++number);
  peer.write("rq/surefoot/" + command + "Request", request);
  return answer_to(request, peer, command);
}

TEST_F(Ros2Test, CommandsAreDoneAndRepeated) {
  const std::vector<Scan> scans = stamped_scans(9);
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType);
  peer.add_writer("rt/surefoot/command", "std_msgs::msg::dds_::String_");
  for (const char* command : {"save_map", "pause", "resume", "localize"}) {
    const std::string name = std::string("/surefoot/") + command;
    peer.add_writer("rq" + name + "Request", "std_srvs::srv::dds_::Trigger_Request_");
    peer.add_reader("rr" + name + "Reply", "std_srvs::srv::dds_::Trigger_Response_");
  }
  const Process process(
      live({"--ros2-topic", "/points", "--ros2-qos", "reliable", "--ros2-commands", "--queue",
            "100", "--record", "heard.mcap", "-o", "live"}),
      scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/points"));
  ASSERT_TRUE(peer.wait_for_readers("rt/surefoot/command"));
  ASSERT_TRUE(peer.wait_for_readers("rq/surefoot/save_mapRequest"));
  const auto send = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      peer.write("rt/points", cloud_by_fast_cdr(scans[i], ""));
    }
  };
  EXPECT_EQ(called(peer, "save_map"), "!no scan has come yet");
  send(0, 3);
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 3));
  const std::string map = called(peer, "save_map");
  EXPECT_EQ(map, fs::absolute(scratch_.path() / "live" / "map.ply").string());
  EXPECT_GT(content("live/map.ply").size(), 1000U);
  EXPECT_EQ(called(peer, "localize"), "!there is no map: --localize MAP, or name it: localize MAP");
  EXPECT_EQ(called(peer, "pause"), "scans are left out");
  send(3, 4);
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 4));
  EXPECT_EQ(called(peer, "resume"), "scans are used");
  send(4, 6);
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 6));
  peer.write("rt/surefoot/command", std::string("\0\1\0\0\6\0\0\0reset\0", 14));
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 7));  // of its own line
  send(6, 9);
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + 10));
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("8 scans, 0 dropped, 1 paused"), std::string::npos) << result;
  EXPECT_NE(content("live/trajectory.tum").find("# segment 1"), std::string::npos);
  EXPECT_TRUE(fs::exists(scratch_.path() / "live" / "trajectory_segment_1.tum"));
  expect_repeated("live");
}

// Who answers has found another's reader of replies, and not yet that of who asks.
TEST_F(Ros2Test, EachOfTwoClientsIsAnswered) {
  const std::string name = "/surefoot/save_map";
  const auto add_writer = [&](FastDdsPeer& peer) {
    peer.add_writer("rq" + name + "Request", "std_srvs::srv::dds_::Trigger_Request_");
  };
  const auto add_reader = [&](FastDdsPeer& peer) {
    peer.add_reader("rr" + name + "Reply", "std_srvs::srv::dds_::Trigger_Response_");
  };
  FastDdsPeer first(own_domain()), late(own_domain());
  first.add_writer("rt/points", kCloudType);
  add_writer(first);
  add_reader(first);
  const Process process(live({"--ros2-topic", "/points", "--ros2-commands", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(first.wait_for_readers("rt/points"));  // which it has when it knows this peer
  ASSERT_TRUE(first.wait_for_readers("rq" + name + "Request"));
  EXPECT_EQ(called(first, "save_map"), "!no scan has come yet");
  add_writer(late);
  ASSERT_TRUE(late.wait_for_readers("rq" + name + "Request"));
  std::this_thread::sleep_for(milliseconds(700));  // until its writer is known there
  std::thread finds([&] {
    std::this_thread::sleep_for(milliseconds(500));
    add_reader(late);
  });
  const std::string request = request_of(1'000'000);
  late.write("rq" + name + "Request", request);
  finds.join();
  EXPECT_EQ(answer_to(request, late, "save_map"), "!no scan has come yet");
  process.send(SIGTERM);
  (void)process.wait();
}

TEST_F(Ros2Test, APlaceInAMapIsSearchedForOnDemand) {
  const std::vector<Scan> scans = stamped_scans(9);
  offline(scans);
  const ProcessResult map = run_surefoot(
      {"map", "scans.mcap", "-o", "map", "--no-report", "--no-picture", "-q"}, scratch_.path());
  ASSERT_EQ(map.exit_code, 0) << map;
  FastDdsPeer peer(own_domain());
  peer.add_writer("rt/points", kCloudType);
  peer.add_writer("rt/surefoot/command", "std_msgs::msg::dds_::String_");
  const std::string name = "/surefoot/localize";
  peer.add_writer("rq" + name + "Request", "std_srvs::srv::dds_::Trigger_Request_");
  peer.add_reader("rr" + name + "Reply", "std_srvs::srv::dds_::Trigger_Response_");
  const Process process(live({"--ros2-topic", "/points", "--ros2-qos", "reliable",
                              "--ros2-commands", "--queue", "100", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_readers("rt/points"));
  ASSERT_TRUE(peer.wait_for_readers("rt/surefoot/command"));
  ASSERT_TRUE(peer.wait_for_readers("rq" + name + "Request"));
  const auto send = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      peer.write("rt/points", cloud_by_fast_cdr(scans[i], ""));
    }
    return wait_for_lines("live/live.log", 1 + to);
  };
  ASSERT_TRUE(send(0, 4));
  const std::string command = "localize map";
  const auto size = static_cast<std::uint32_t>(command.size() + 1);
  std::string message("\0\1\0\0", 4);
  message.append(reinterpret_cast<const char*>(&size), 4);
  peer.write("rt/surefoot/command", message + command + '\0');
  std::string again;
  for (int i = 0; i < 100 && !again.starts_with("its place"); ++i) again = called(peer, "localize");
  EXPECT_EQ(again, "its place in the map is searched for");
  ASSERT_TRUE(send(4, 9));
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(lines_of(scratch_.path() / "live" / "localization.csv"), 1U + 5U);
  EXPECT_TRUE(fs::exists(scratch_.path() / "live" / "trajectory_map.tum"));
  expect_same("offline", "live");
}

}  // namespace
}  // namespace surefoot::test
