// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/motion_topics.hpp"

#include <gtest/gtest.h>

#include "io/bags/bag_writer.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kFirstStamp = 1'600'000'000'000'000'000;
constexpr std::int64_t kStep = 5'000'000;  // [ns] 200 Hz

std::string imu(std::int64_t stamp_ns, const Eigen::Vector3d& rate) {
  MessageWriter message;
  message.header(stamp_ns, "imu");
  for (int i = 0; i < 13; ++i) message.number(0.0);
  for (int i = 0; i < 3; ++i) message.number(rate[i]);
  for (int i = 0; i < 21; ++i) message.number(0.0);
  return message.take();
}

std::string pose(std::int64_t stamp_ns, const Eigen::Vector3d& at, bool with_rotation) {
  MessageWriter message;
  message.header(stamp_ns, "world");
  for (int i = 0; i < 3; ++i) message.number(at[i]);
  if (with_rotation) message.number(0.0).number(0.0).number(0.6).number(0.8);
  return message.take();
}

TEST(Gyroscope, ItsTurnsAreThoseOfTheBag) {
  const test::TemporaryFolder folder;
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  const std::size_t topic = bag->add_topic("/imu", {"sensor_msgs/Imu", "", "", ""});
  for (int i = 0; i <= 200; ++i) {
    bag->write(topic, kFirstStamp + i * kStep, imu(kFirstStamp + i * kStep, {0.0, 0.0, 0.5}));
  }
  bag->write(topic, kFirstStamp + 201 * kStep, "damaged");
  bag->finish();
  const Gyroscope all =
      read_gyroscope(folder.path() / "a.mcap", kFirstStamp, kFirstStamp + 1'000'000'000);
  EXPECT_EQ(all.topic, "/imu");
  ASSERT_EQ(all.turning.size(), 201U);
  EXPECT_NEAR(so3_log(all.turning.back().pose.rotation).z(), 0.5, 1e-9);
  const Gyroscope half = read_gyroscope(folder.path() / "a.mcap", kFirstStamp + 500'000'000,
                                        kFirstStamp + 1'000'000'000);
  EXPECT_EQ(half.turning.size(), 101U);
}

TEST(Gyroscope, ThereIsNoneWhereThereIsNone) {
  const test::TemporaryFolder folder;
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  const std::size_t topic = bag->add_topic("/pose", {"geometry_msgs/PoseStamped", "", "", ""});
  bag->write(topic, kFirstStamp, pose(kFirstStamp, {1, 2, 3}, true));
  bag->finish();
  EXPECT_TRUE(read_gyroscope(folder.path() / "a.mcap", 0, kFirstStamp + 1).topic.empty());
}

TEST(PoseTopic, PosesAndPointsAreRead) {
  const test::TemporaryFolder folder;
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  const std::size_t poses = bag->add_topic("/poses", {"geometry_msgs/PoseStamped", "", "", ""});
  const std::size_t prism = bag->add_topic("/prism", {"geometry_msgs/PointStamped", "", "", ""});
  for (int i = 0; i < 3; ++i) {
    const std::int64_t stamp = kFirstStamp + i * kStep;
    bag->write(poses, stamp, pose(stamp, {1.0 * i, 2, 3}, true));
    bag->write(prism, stamp, pose(stamp, {4, 1.0 * i, 6}, false));
  }
  bag->write(poses, kFirstStamp + kStep,
             pose(kFirstStamp + kStep, {9, 9, 9}, true));  // out of order
  bag->finish();
  const auto file = folder.path() / "a.mcap";
  const Trajectory path = read_pose_topic(file, "/poses");
  ASSERT_EQ(path.size(), 3U);
  EXPECT_EQ(path[2].pose.translation, Eigen::Vector3d(2, 2, 3));
  EXPECT_NEAR(path[2].pose.rotation.z(), 0.6, 1e-12);
  EXPECT_EQ(read_pose_topic(file, "/prism")[1].pose.translation, Eigen::Vector3d(4, 1, 6));
  try {
    (void)read_pose_topic(file, "");
    ADD_FAILURE() << "one of two was taken";
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("/prism"), std::string::npos);
  }
  EXPECT_THROW((void)read_pose_topic(file, "/nothing"), ReadError);
}

}  // namespace
}  // namespace surefoot::io
