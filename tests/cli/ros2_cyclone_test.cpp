// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot live on ROS 2's topics, against Cyclone DDS with types made of their IDL: both ways.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "cyclone_peer.hpp"
#include "ros2_live.hpp"

namespace surefoot::test {
namespace {

using std::chrono::milliseconds;

TEST_F(Ros2Test, ACyclonePeerWithTheTypesIdlIsHeardAndHears) {
  std::vector<Scan> scans = stamped_scans(6);
  for (Scan& scan : scans) {  // all that the peer sends
    scan.intensities.clear();
    scan.rings.clear();
  }
  offline(scans);
  CyclonePeer peer(own_domain(), "rt/points");
  const Process process(live({"--ros2-topic", "/points", "--ros2-qos", "reliable", "--ros2-publish",
                              "--queue", "100", "-o", "live"}),
                        scratch_.path());
  ASSERT_TRUE(peer.wait_for_peer());
  std::this_thread::sleep_for(milliseconds(700));  // until its writers know these readers
  for (const Scan& scan : scans) {
    peer.write(scan);
    std::this_thread::sleep_for(milliseconds(60));
  }
  ASSERT_TRUE(wait_for_lines("live/live.log", 1 + scans.size()));
  std::this_thread::sleep_for(milliseconds(300));
  process.send(SIGTERM);
  const ProcessResult result = process.wait();
  ASSERT_EQ(result.exit_code, 0) << result;
  expect_same("offline", "live");

  const std::vector<HeardOdometry> odometry = peer.odometry();
  ASSERT_EQ(odometry.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(odometry[i].frame, "odom");
    EXPECT_EQ(odometry[i].child_frame, "lidar");
    EXPECT_GT(odometry[i].stamp_ns, scans[i].stamp_ns);
    EXPECT_LT(odometry[i].stamp_ns, scans[i].stamp_ns + 100'000'000);
    ASSERT_EQ(odometry[i].numbers.size(), 7U + 36 + 6 + 36);
  }
  EXPECT_GT(odometry.back().numbers[7], 0.0);       // covariance of x
  EXPECT_NE(odometry.back().numbers[7 + 36], 0.0);  // twist
  EXPECT_EQ(peer.transforms(), std::vector(scans.size(), HeardTransforms{"odom > lidar"}));
  EXPECT_EQ(peer.cloud_sizes().size(), scans.size());
}

}  // namespace
}  // namespace surefoot::test
