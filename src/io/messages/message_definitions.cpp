// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/message_definitions.hpp"

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace surefoot::io {
namespace {

struct Part {
  std::string_view type;
  std::string_view text;
};

// ROS 2, common_interfaces and rcl_interfaces.
constexpr std::array<Part, 22> kParts = {{
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
    {"geometry_msgs/Pose", "Point position\nQuaternion orientation\n"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\nPose pose\n"},
    {"geometry_msgs/PoseWithCovariance", "Pose pose\nfloat64[36] covariance\n"},
    {"geometry_msgs/Twist", "Vector3 linear\nVector3 angular\n"},
    {"geometry_msgs/TwistWithCovariance", "Twist twist\nfloat64[36] covariance\n"},
    {"geometry_msgs/Transform", "Vector3 translation\nQuaternion rotation\n"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\nTransform transform\n"},
    {"sensor_msgs/PointField",
     "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\nuint8 UINT32=6\n"
     "uint8 FLOAT32=7\nuint8 FLOAT64=8\nstring name\nuint32 offset\nuint8 datatype\nuint32 "
     "count\n"},
    {"sensor_msgs/PointCloud2",
     "std_msgs/Header header\nuint32 height\nuint32 width\nPointField[] fields\n"
     "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
     "geometry_msgs/TwistWithCovariance twist\n"},
    {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
    {"sensor_msgs/Imu",
     "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
     "float64[9] orientation_covariance\ngeometry_msgs/Vector3 angular_velocity\n"
     "float64[9] angular_velocity_covariance\ngeometry_msgs/Vector3 linear_acceleration\n"
     "float64[9] linear_acceleration_covariance\n"},
    {"std_msgs/String", "string data\n"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    {"diagnostic_msgs/KeyValue", "string key\nstring value\n"},
    {"diagnostic_msgs/DiagnosticStatus",
     "byte OK=0\nbyte WARN=1\nbyte ERROR=2\nbyte STALE=3\nbyte level\nstring name\nstring message\n"
     "string hardware_id\nKeyValue[] values\n"},
    {"diagnostic_msgs/DiagnosticArray", "std_msgs/Header header\nDiagnosticStatus[] status\n"},
}};

std::string_view text_of(std::string_view type) {
  for (const Part& part : kParts) {
    if (part.type == type) return part.text;
  }
  throw std::invalid_argument(std::string(type));
}

// The type's own text, and those of the types that it refers to, each under a line and its name.
std::string joined(std::string_view type, std::initializer_list<std::string_view> others) {
  std::string text(text_of(type));
  for (const std::string_view other : others) {
    text += std::string(80, '=') + "\nMSG: ";
    text += other;
    text += '\n';
    text += text_of(other);
  }
  return text;
}

constexpr std::string_view kTime = "builtin_interfaces/Time";
constexpr std::string_view kHeader = "std_msgs/Header";
constexpr std::string_view kPoint = "geometry_msgs/Point";
constexpr std::string_view kQuaternion = "geometry_msgs/Quaternion";
constexpr std::string_view kVector = "geometry_msgs/Vector3";
constexpr std::string_view kPose = "geometry_msgs/Pose";

}  // namespace

std::string MessageDefinition::ros2_type() const {
  if (!ros2_name.empty()) return ros2_name;
  std::string name = type;
  return name.insert(name.find('/'), "/msg");
}

MessageDefinition point_cloud2_definition() {
  // ROS 1's header has a sequence number and a time of its own kind.
  const std::string line = std::string(80, '=') + "\nMSG: ";
  std::string text(text_of("sensor_msgs/PointCloud2"));
  text.replace(0, text.find(' '), "Header");
  text += line + "std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";
  text += line + "sensor_msgs/PointField\n";
  text += text_of("sensor_msgs/PointField");
  return {"sensor_msgs/PointCloud2",
          joined("sensor_msgs/PointCloud2", {kHeader, kTime, "sensor_msgs/PointField"}), text,
          "1158d486dd51d683ce2f1be655c3c181"};
}

MessageDefinition odometry_definition() {
  return {"nav_msgs/Odometry",
          joined("nav_msgs/Odometry",
                 {kHeader, kTime, "geometry_msgs/PoseWithCovariance", kPose, kPoint, kQuaternion,
                  "geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist", kVector}),
          "", ""};
}

MessageDefinition path_definition() {
  return {"nav_msgs/Path",
          joined("nav_msgs/Path",
                 {kHeader, kTime, "geometry_msgs/PoseStamped", kPose, kPoint, kQuaternion}),
          "", ""};
}

MessageDefinition transforms_definition() {
  return {"tf2_msgs/TFMessage",
          joined("tf2_msgs/TFMessage", {"geometry_msgs/TransformStamped", kHeader, kTime,
                                        "geometry_msgs/Transform", kVector, kQuaternion}),
          "", ""};
}

MessageDefinition diagnostics_definition() {
  return {"diagnostic_msgs/DiagnosticArray",
          joined("diagnostic_msgs/DiagnosticArray",
                 {kHeader, kTime, "diagnostic_msgs/DiagnosticStatus", "diagnostic_msgs/KeyValue"}),
          "", ""};
}

std::string known_ros2_text(std::string_view type) {
  for (const MessageDefinition& definition :
       {point_cloud2_definition(), odometry_definition(), path_definition(),
        transforms_definition(), diagnostics_definition()}) {
    if (definition.type == type) return definition.ros2_text;
  }
  if (type == "sensor_msgs/Imu") return joined(type, {kHeader, kTime, kQuaternion, kVector});
  return type == "std_msgs/String" ? std::string(text_of(type)) : std::string();
}

}  // namespace surefoot::io
