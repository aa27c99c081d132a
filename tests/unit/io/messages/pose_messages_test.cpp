// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages of motion, number by number as their definitions have them.
#include "io/messages/pose_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/messages/message_reader.hpp"
#include "io/messages/motion_message.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using Flavour = MessageWriter::Flavour;
constexpr std::int64_t kStamp = 1'700'000'000'123'456'789;

Pose some_pose() { return {from_roll_pitch_yaw({0.1, -0.2, 0.3}), {1.0, 2.0, 3.0}}; }

std::vector<double> numbers(MessageReader& reader, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(reader.number<double>("number"));
  return result;
}

std::vector<double> numbers_of(const Pose& pose) {
  const Eigen::Vector3d& t = pose.translation;
  const Eigen::Quaterniond& q = pose.rotation;
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

MessageReader reader_of(const std::string& bytes, Flavour flavour) {
  return {flavour == Flavour::cdr ? MessageEncoding::cdr : MessageEncoding::ros1,
          test::bytes_of(bytes)};
}

TEST(PoseMessages, AnOdometrysCovarianceIsWrittenRowByRowAndItsTwistLinearFirst) {
  OdometryMessage odometry{kStamp, "odom", "lidar", some_pose(), {}, {}};
  std::vector<double> covariance, twist;
  for (int i = 0; i < 36; ++i) {
    odometry.covariance(i / 6, i % 6) = 100.0 + i;
    covariance.push_back(100.0 + i);
  }
  for (int i = 0; i < 6; ++i) {
    odometry.twist[i] = 1.0 + i;
    twist.push_back(1.0 + i);
  }
  for (const Flavour flavour : {Flavour::cdr, Flavour::ros1}) {
    const std::string bytes = format_odometry(odometry, flavour);
    MessageReader reader = reader_of(bytes, flavour);
    const MessageHeader header = read_header(reader);
    EXPECT_EQ(header.stamp_ns, kStamp);
    EXPECT_EQ(header.frame, "odom");
    EXPECT_EQ(reader.string("child"), "lidar");
    EXPECT_EQ(numbers(reader, 7), numbers_of(odometry.T_frame_child));
    EXPECT_EQ(numbers(reader, 36), covariance);
    EXPECT_EQ(numbers(reader, 6), twist);
    EXPECT_EQ(numbers(reader, 36), std::vector<double>(36, 0.0)) << "of the twist: not known";
    EXPECT_THROW((void)reader.number<std::uint8_t>("more"), ReadError);
  }
}

TEST(PoseMessages, APathIsStampedAsItsLastPose) {
  const Trajectory poses = {{kStamp - 1'000'000'000, Pose{}}, {kStamp, some_pose()}};
  const std::string bytes = format_path(poses, "odom", Flavour::cdr);
  MessageReader reader = reader_of(bytes, Flavour::cdr);
  EXPECT_EQ(read_header(reader).stamp_ns, kStamp);
  EXPECT_EQ(reader.number<std::uint32_t>("poses"), 2U);
  for (const StampedPose& stamped : poses) {
    EXPECT_EQ(read_header(reader).stamp_ns, stamped.stamp_ns);
    EXPECT_EQ(numbers(reader, 7), numbers_of(stamped.pose));
  }
  const std::string nothing = format_path({}, "odom", Flavour::cdr);
  MessageReader empty = reader_of(nothing, Flavour::cdr);
  EXPECT_EQ(read_header(empty).stamp_ns, 0);
}

TEST(PoseMessages, ATransformIsThatOfTheChildInItsParent) {
  const std::string bytes =
      format_transforms({{kStamp, "odom", "lidar", some_pose()}}, Flavour::ros1);
  MessageReader reader = reader_of(bytes, Flavour::ros1);
  EXPECT_EQ(reader.number<std::uint32_t>("transforms"), 1U);
  const MessageHeader header = read_header(reader);
  EXPECT_EQ(header.stamp_ns, kStamp);
  EXPECT_EQ(header.frame, "odom");
  EXPECT_EQ(reader.string("child"), "lidar");
  EXPECT_EQ(numbers(reader, 7), numbers_of(some_pose()));
}

/// geometry_msgs/PoseStamped.
PoseMessage read_back(const Eigen::Vector3d& position, const Eigen::Quaterniond& q) {
  MessageWriter message(Flavour::ros1);
  message.header(kStamp, "odom");
  for (int axis = 0; axis < 3; ++axis) message.number(position[axis]);
  message.number(q.x()).number(q.y()).number(q.z()).number(q.w());
  const std::string bytes = message.take();
  const Topic topic{"/pose", "geometry_msgs/PoseStamped", MessageEncoding::ros1};
  return read_pose({&topic, 0, test::bytes_of(bytes)});
}

TEST(MotionMessage, ARotationIsMadeAUnitOneAndWhatIsNoneIsTold) {
  const Eigen::Vector3d at(1.0, 2.0, 3.0);
  const Eigen::Quaterniond q = some_pose().rotation;
  const auto times = [&](double factor) { return Eigen::Quaterniond(factor * q.coeffs()); };
  const PoseMessage nearly = read_back(at, times(1.001));
  EXPECT_EQ(nearly.pose.stamp_ns, kStamp);
  EXPECT_EQ(nearly.pose.pose.translation, at);
  EXPECT_TRUE(nearly.has_rotation);
  EXPECT_LT(nearly.pose.pose.rotation.angularDistance(q), 1e-9);
  EXPECT_NEAR(nearly.pose.pose.rotation.norm(), 1.0, 1e-12);
  const PoseMessage none = read_back(at, times(0.0));  // of who knows positions alone
  EXPECT_FALSE(none.has_rotation);
  EXPECT_EQ(none.pose.pose.translation, at);
  EXPECT_THROW((void)read_back(at, times(0.4)), ReadError);
  EXPECT_THROW((void)read_back(at, times(2.5)), ReadError);
}

TEST(MotionMessage, APositionThatIsNoneIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)read_back({1.0, nan, 3.0}, Eigen::Quaterniond::Identity()), ReadError);
}

}  // namespace
}  // namespace surefoot::io
