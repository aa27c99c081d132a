// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/names.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "ros2/participant.hpp"

namespace surefoot::ros2 {
namespace {

TEST(Names, TopicsAndTypesAreSpelledAsOnTheWire) {
  EXPECT_EQ(wire_type("sensor_msgs/PointCloud2"), "sensor_msgs::msg::dds_::PointCloud2_");
  EXPECT_EQ(wire_topic("/robot/points"), "rt/robot/points");
  EXPECT_EQ(wire_topic("points"), "rt/points");
  EXPECT_EQ(topic_of("rt/robot/points"), "/robot/points");
  EXPECT_EQ(topic_of("rq/robot/resetRequest"), "");
  EXPECT_EQ(topic_of("ros_discovery_info"), "");
  EXPECT_EQ(trigger_request_topic("/surefoot/reset").name, "rq/surefoot/resetRequest");
  EXPECT_EQ(trigger_reply_topic("/surefoot/reset").type, "std_srvs::srv::dds_::Trigger_Response_");
}

TEST(Names, OnlyWhatRos2LetsBeANodeIsOne) {
  for (const char* name : {"surefoot", "robot_1", "_p"}) EXPECT_TRUE(is_node_name(name)) << name;
  for (const char* name : {"", "/", "/surefoot", "a/b", "a b", "1x", "n\n"}) {
    EXPECT_FALSE(is_node_name(name)) << name;
    ParticipantOptions options;
    options.node = name;
    EXPECT_THROW(Participant{options}, std::invalid_argument) << name;
  }
}

// The first of them as ROS 2's own endpoints tell it.
TEST(Names, TypeHashesAreThoseOfTheTypes) {
  EXPECT_EQ(type_hash_data("sensor_msgs/PointCloud2"),
            "typehash=RIHS01_9198cabf7da3796ae6fe19c4cb3bdd3525492988c70522628af5daa124bae2b5;");
  constexpr std::size_t kLength = 16 + 64 + 1;
  for (const char* type : {"nav_msgs/Odometry", "nav_msgs/Path", "tf2_msgs/TFMessage",
                           "diagnostic_msgs/DiagnosticArray", "std_msgs/String",
                           "rmw_dds_common/ParticipantEntitiesInfo"}) {
    EXPECT_EQ(type_hash_data(type).size(), kLength) << type;
  }
  EXPECT_EQ(type_hash_data("somebody_msgs/Own"), "");
}

}  // namespace
}  // namespace surefoot::ros2
