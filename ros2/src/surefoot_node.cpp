// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// PointCloud2 in, odometry and transform out. All that is odometry is in the library.
#include <surefoot/odometry.hpp>

#include <tf2_ros/transform_broadcaster.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <memory>
#include <nav_msgs/msg/odometry.hpp>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <string>

namespace {

using Cloud = sensor_msgs::msg::PointCloud2;
using Field = sensor_msgs::msg::PointField;
constexpr double kNanoseconds = 1e9;

const Field* find(const Cloud& cloud, const char* name, std::uint8_t type, std::size_t bytes) {
  for (const Field& field : cloud.fields) {
    if (field.name == name && field.datatype == type && field.offset + bytes <= cloud.point_step) {
      return &field;
    }
  }
  return nullptr;
}

template <typename T>
T load(const std::uint8_t* point, const Field& field) {
  T value;
  std::memcpy(&value, point + field.offset, sizeof(T));
  return value;
}

std::int64_t stamp_of(const builtin_interfaces::msg::Time& time) {
  return std::int64_t{time.sec} * 1'000'000'000 + time.nanosec;
}

// No clock gives so many seconds, and every one that counts nanoseconds gives more [s, ns].
constexpr double kNoSeconds = 1e12;

/// Of a time within a sweep [s]; what cannot be one is at an end, far from any other.
std::int32_t nanoseconds(double seconds) {
  constexpr double kLongest = 2.0;
  if (!std::isfinite(seconds)) return 0;
  return static_cast<std::int32_t>(
      std::lround(std::clamp(seconds, -kLongest, kLongest) * kNanoseconds));
}

/// Nanoseconds after the stamp of a point, by whichever field there is.
std::function<std::int32_t(const std::uint8_t*)> times_of(const Cloud& cloud) {
  if (const Field* t = find(cloud, "t", Field::UINT32, 4)) {
    return [t](const std::uint8_t* p) {
      return static_cast<std::int32_t>(load<std::uint32_t>(p, *t));
    };
  }
  if (const Field* time = find(cloud, "time", Field::FLOAT32, 4)) {
    return [time](const std::uint8_t* p) { return nanoseconds(load<float>(p, *time)); };
  }
  if (const Field* stamp = find(cloud, "timestamp", Field::FLOAT64, 8)) {
    const double begin = static_cast<double>(stamp_of(cloud.header.stamp)) / kNanoseconds;
    return [stamp, begin](const std::uint8_t* p) {
      const double value = load<double>(p, *stamp);
      return nanoseconds((value > kNoSeconds ? value / kNanoseconds : value) - begin);
    };
  }
  return {};
}

/// Nothing where the cloud is not what it says, or has no x, y, z.
std::optional<surefoot::Scan> scan_of(const Cloud& cloud) {
  const Field* const x = find(cloud, "x", Field::FLOAT32, 4);
  const Field* const y = find(cloud, "y", Field::FLOAT32, 4);
  const Field* const z = find(cloud, "z", Field::FLOAT32, 4);
  const std::size_t row = std::size_t{cloud.width} * cloud.point_step;
  const std::size_t stride = cloud.height > 1 ? cloud.row_step : row;
  const bool whole = cloud.height == 0 || stride < row ||
                     cloud.data.size() >= stride * (cloud.height - std::size_t{1}) + row;
  if (x == nullptr || y == nullptr || z == nullptr || cloud.is_bigendian || !whole ||
      stride < row) {
    return std::nullopt;
  }
  const auto time = times_of(cloud);
  surefoot::Scan scan;
  scan.stamp_ns = stamp_of(cloud.header.stamp);
  for (std::size_t v = 0; v < cloud.height; ++v) {
    for (std::size_t u = 0; u < cloud.width; ++u) {
      const std::uint8_t* const p = cloud.data.data() + v * stride + u * cloud.point_step;
      scan.points.emplace_back(load<float>(p, *x), load<float>(p, *y), load<float>(p, *z));
      if (time) scan.times_ns.push_back(time(p));
    }
  }
  return scan;
}

class SurefootNode : public rclcpp::Node {
 public:
  SurefootNode()
      : rclcpp::Node("surefoot"),
        odometry_(surefoot::method_config(declare_parameter<std::string>("method", "surefoot"))),
        odom_frame_(declare_parameter<std::string>("odom_frame", "odom")),
        publishes_tf_(declare_parameter<bool>("publish_tf", true)),
        broadcaster_(*this) {
    publisher_ = create_publisher<nav_msgs::msg::Odometry>("odometry", 10);
    subscription_ = create_subscription<Cloud>(
        "points", rclcpp::SensorDataQoS(), [this](Cloud::ConstSharedPtr cloud) { use(*cloud); });
  }

 private:
  void use(const Cloud& cloud) {
    const std::optional<surefoot::Scan> scan = scan_of(cloud);
    if (!scan) {
      RCLCPP_WARN_ONCE(get_logger(), "clouds are not used: expected little-endian x, y, z (f32)");
      return;
    }
    if (scan->times_ns.empty()) {
      RCLCPP_WARN_ONCE(get_logger(), "no point times (t, time, timestamp): nothing is deskewed");
    }
    const surefoot::Estimate estimate = odometry_.add_scan(*scan);
    if (!estimate.trusted()) {
      RCLCPP_WARN(get_logger(), "%s: %s", std::string(to_string(estimate.status)).c_str(),
                  estimate.message.c_str());
      return;
    }
    publish(estimate, cloud.header.frame_id);
  }

  void publish(const surefoot::Estimate& estimate, const std::string& frame) {
    const Eigen::Vector3d& t = estimate.T_world_lidar.translation;
    const Eigen::Quaterniond& q = estimate.T_world_lidar.rotation;
    nav_msgs::msg::Odometry message;
    message.header.stamp = rclcpp::Time(estimate.stamp_ns);
    message.header.frame_id = odom_frame_;
    message.child_frame_id = frame;
    auto& pose = message.pose.pose;
    pose.position.x = t.x(), pose.position.y = t.y(), pose.position.z = t.z();
    pose.orientation.x = q.x(), pose.orientation.y = q.y();
    pose.orientation.z = q.z(), pose.orientation.w = q.w();
    for (int i = 0; i < 36; ++i) message.pose.covariance[i] = estimate.covariance(i / 6, i % 6);
    auto& twist = message.twist.twist;
    twist.linear.x = estimate.twist[0], twist.linear.y = estimate.twist[1];
    twist.linear.z = estimate.twist[2], twist.angular.x = estimate.twist[3];
    twist.angular.y = estimate.twist[4], twist.angular.z = estimate.twist[5];
    publisher_->publish(message);
    if (!publishes_tf_) return;
    geometry_msgs::msg::TransformStamped transform;
    transform.header = message.header;
    transform.child_frame_id = frame;
    transform.transform.translation.x = t.x(), transform.transform.translation.y = t.y();
    transform.transform.translation.z = t.z();
    transform.transform.rotation = pose.orientation;
    broadcaster_.sendTransform(transform);
  }

  surefoot::Odometry odometry_;
  std::string odom_frame_;
  bool publishes_tf_;
  tf2_ros::TransformBroadcaster broadcaster_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr publisher_;
  rclcpp::Subscription<Cloud>::SharedPtr subscription_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SurefootNode>());
  rclcpp::shutdown();
  return 0;
}
