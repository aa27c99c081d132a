// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/motion_topics.hpp"

#include <gtest/gtest.h>

#include "io/bags/bag_writer.hpp"
#include "io/messages/motion_message.hpp"
#include "io/recording.hpp"
#include "io/truth_files.hpp"
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

/// A bag of a topic that has a message a second, logged at epoch times, its headers from `first`
/// on.
void write_topic(const std::filesystem::path& file, const char* type, std::int64_t first) {
  const auto bag = make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/one", {type, "", "", ""});
  for (int i = 0; i < 20; ++i) {
    const std::int64_t since = i * 1'000'000'000LL;
    bag->write(topic, kFirstStamp + since, imu(first + since, {0.0, 0.0, 0.5}));
  }
  bag->finish();
}

TEST(Gyroscope, EveryFileOfABagMayHoldIt) {
  const test::TemporaryFolder folder;
  write_topic(folder.path() / "camera.mcap", "sensor_msgs/Image", kFirstStamp);
  write_topic(folder.path() / "imu.mcap", "sensor_msgs/Imu", kFirstStamp);
  const Gyroscope begin = read_gyroscope(folder.path(), kFirstStamp, kFirstStamp + 4'000'000'000);
  EXPECT_EQ(begin.turning.size(), 5U);
}

TEST(Gyroscope, ItMayLieBehindAllOfAnotherTopic) {
  const test::TemporaryFolder folder;
  const auto bag = make_mcap_bag(folder.path() / "a.mcap");
  for (const char* type : {"sensor_msgs/Image", "sensor_msgs/Imu"}) {
    const std::size_t topic = bag->add_topic(type, {type, "", "", ""});
    for (int i = 0; i < 20; ++i) {
      const std::int64_t stamp = kFirstStamp + i * 1'000'000'000LL;
      bag->write(topic, stamp, imu(stamp, {0.0, 0.0, 0.5}));
    }
  }
  bag->finish();
  const Gyroscope begin =
      read_gyroscope(folder.path() / "a.mcap", kFirstStamp, kFirstStamp + 4'000'000'000);
  EXPECT_EQ(begin.turning.size(), 5U);
}

// A LiDAR and its IMU that know no time of day.
TEST(Gyroscope, HeadersMayHaveAClockOfTheirOwn) {
  const test::TemporaryFolder folder;
  const std::int64_t uptime = 50'000'000'000;
  write_topic(folder.path() / "imu.mcap", "sensor_msgs/Imu", uptime);
  const Gyroscope begin = read_gyroscope(folder.path(), uptime, uptime + 4'000'000'000);
  EXPECT_EQ(begin.turning.size(), 5U);
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
  const auto [path, has_rotations] = read_pose_topic(file, "/poses");
  ASSERT_EQ(path.size(), 3U);
  EXPECT_TRUE(has_rotations);
  EXPECT_EQ(path[2].pose.translation, Eigen::Vector3d(2, 2, 3));
  EXPECT_NEAR(path[2].pose.rotation.z(), 0.6, 1e-12);
  const PoseTopic points = read_pose_topic(file, "/prism");
  EXPECT_EQ(points.poses[1].pose.translation, Eigen::Vector3d(4, 1, 6));
  EXPECT_FALSE(points.has_rotations);
  EXPECT_FALSE(read_truth(file, nullptr, "/prism").has_rotations);
  EXPECT_TRUE(read_truth(file, nullptr, "/poses").has_rotations);
  try {
    (void)read_pose_topic(file, "");
    ADD_FAILURE() << "one of two was taken";
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("/prism"), std::string::npos);
  }
  EXPECT_THROW((void)read_pose_topic(file, "/nothing"), ReadError);
}

// "Delimited" CDR 2 has a size before every structure, and aligns to 4 bytes at most.
TEST(PoseTopic, StructuresMayHaveTheirSizesBeforeThem) {
  using test::little;
  const std::string size = little(std::uint32_t{0});
  const auto numbers = [](std::initializer_list<double> values) {
    std::string bytes;
    for (const double value : values) bytes += little(value);
    return bytes;
  };
  const std::string header = std::string("\0\x09\0\0", 4) + size + size + size +
                             little(std::int32_t{100}) + little(std::uint32_t{5}) +
                             little(std::uint32_t{4}) + std::string("map\0", 4);
  const std::string child = little(std::uint32_t{4}) + std::string("odo\0", 4);
  const std::string pose = size + numbers({1, 2, 3}) + size + numbers({0, 0, 0.6, 0.8});
  const std::pair<const char*, std::string> messages[] = {
      {"nav_msgs/Odometry", header + child + size + size + pose},
      {"geometry_msgs/PoseWithCovarianceStamped", header + size + size + pose},
      {"geometry_msgs/PoseStamped", header + size + pose},
      {"geometry_msgs/TransformStamped", header + child + size + pose},
      {"geometry_msgs/PointStamped", header + size + numbers({1, 2, 3})}};
  for (const auto& [type, bytes] : messages) {
    const Topic topic{"/t", type, MessageEncoding::cdr};
    const PoseMessage read = read_pose({&topic, 0, test::bytes_of(bytes)});
    EXPECT_EQ(read.pose.stamp_ns, 100'000'000'005) << type;
    EXPECT_EQ(read.pose.pose.translation, Eigen::Vector3d(1, 2, 3)) << type;
    EXPECT_EQ(read.has_rotation, std::string_view(type) != "geometry_msgs/PointStamped");
    EXPECT_NEAR(read.pose.pose.rotation.z(), read.has_rotation ? 0.6 : 0.0, 1e-12) << type;
  }
  const Topic topic{"/imu", "sensor_msgs/Imu", MessageEncoding::cdr};
  const std::string imu = header + size + numbers({0, 0, 0, 1}) +
                          numbers({0, 0, 0, 0, 0, 0, 0, 0, 0}) + size + numbers({4, 5, 6});
  EXPECT_EQ(read_imu({&topic, 0, test::bytes_of(imu)}).rate, Eigen::Vector3d(4, 5, 6));
}

}  // namespace
}  // namespace surefoot::io
