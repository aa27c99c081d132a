// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/names.hpp"

#include <array>
#include <utility>

#include "io/bags/topic_name.hpp"

namespace surefoot::ros2 {
namespace {

constexpr std::string_view kTopicPrefix = "rt/";

// SHA-256 of the types' descriptions.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kHashes = {{
    {"std_msgs/String", "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
    {"sensor_msgs/PointCloud2", "9198cabf7da3796ae6fe19c4cb3bdd3525492988c70522628af5daa124bae2b5"},
    {"nav_msgs/Odometry", "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
    {"nav_msgs/Path", "1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b"},
    {"tf2_msgs/TFMessage", "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
    {"diagnostic_msgs/DiagnosticArray",
     "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
    {"rmw_dds_common/ParticipantEntitiesInfo",
     "91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e"},
}};

}  // namespace

std::string wire_type(std::string_view type) {
  const auto slash = type.find('/');
  return std::string(type.substr(0, slash)) + "::msg::dds_::" +
         std::string(type.substr(slash == std::string_view::npos ? type.size() : slash + 1)) + "_";
}

std::string wire_topic(std::string_view topic) {
  while (topic.starts_with('/')) topic.remove_prefix(1);
  return std::string(kTopicPrefix) + std::string(topic);
}

bool is_node_name(std::string_view node) {
  return io::is_topic_name(node) && node.find('/') == std::string_view::npos;
}

std::string topic_of(std::string_view wire_name) {
  if (!wire_name.starts_with(kTopicPrefix)) return {};
  return std::string(wire_name.substr(kTopicPrefix.size() - 1));
}

WireTopic message_topic(std::string_view topic, std::string_view type) {
  return {wire_topic(topic), wire_type(type), type_hash_data(type)};
}
WireTopic trigger_request_topic(std::string_view service) {
  return {"rq" + std::string(service) + "Request", "std_srvs::srv::dds_::Trigger_Request_", ""};
}
WireTopic trigger_reply_topic(std::string_view service) {
  return {"rr" + std::string(service) + "Reply", "std_srvs::srv::dds_::Trigger_Response_", ""};
}

std::string type_hash_data(std::string_view type) {
  for (const auto& [name, hash] : kHashes) {
    if (name == type) return "typehash=RIHS01_" + std::string(hash) + ";";
  }
  return {};
}

}  // namespace surefoot::ros2
