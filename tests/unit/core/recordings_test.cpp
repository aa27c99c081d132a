// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Every method on recordings that the project did not make, kept beside it. The bounds
// are 1.5 to 2 times what was measured (beside each, over several sets of defaults) and hold the
// odometry to what it could.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/recording.hpp"
#include "support/every_method.hpp"
#include "support/synthetic_run.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {
namespace {

std::filesystem::path shared(const char* name) {
  return std::filesystem::path(SUREFOOT_SHARED_DATA) / name;
}

#define SKIP_WITHOUT(name)                                                     \
  if (!std::filesystem::exists(shared(name))) {                                \
    GTEST_SKIP() << "recording " << shared(name) << " is not on this machine"; \
  }

class Recordings : public test::EveryMethod {
 protected:
  static std::vector<Estimate> run(const char* name);
  /// The bound for the method under test.
  static double either(double surefoot, double paper) {
    return config().method == "surefoot" ? surefoot : paper;
  }
  static void expect_absolute_error(const char* name, std::size_t scans, double bound);
};
INSTANTIATE_TEST_SUITE_P(Methods, Recordings, test::each_method(), test::method_name);

std::vector<Estimate> Recordings::run(const char* name) {
  Odometry odometry(config());
  std::vector<Estimate> estimates;
  const auto recording = io::open_recording(shared(name));
  while (const auto item = recording->next()) {
    if (item->scan) estimates.push_back(odometry.add_scan(*item->scan));
  }
  return estimates;
}

Trajectory read_tum(const std::filesystem::path& file) {
  std::ifstream in(file);
  Trajectory trajectory;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double stamp;
    StampedPose p;
    Eigen::Vector4d& q = p.pose.rotation.coeffs();
    Eigen::Vector3d& t = p.pose.translation;
    if (!(words >> stamp >> t[0] >> t[1] >> t[2] >> q[0] >> q[1] >> q[2] >> q[3])) continue;
    p.stamp_ns = static_cast<std::int64_t>(std::llround(stamp * 1e9));
    p.pose.rotation.normalize();
    trajectory.push_back(p);
  }
  return trajectory;
}

/// The truth at an instant, between its dense poses.
Eigen::Vector3d position_at(const Trajectory& truth, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(
      truth.begin(), truth.end(), stamp_ns,
      [](const StampedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == truth.begin()) return truth.front().pose.translation;
  if (after == truth.end()) return truth.back().pose.translation;
  const StampedPose& a = *(after - 1);
  const double u = static_cast<double>(stamp_ns - a.stamp_ns) /
                   static_cast<double>(after->stamp_ns - a.stamp_ns);
  return (1.0 - u) * a.pose.translation + u * after->pose.translation;
}

/// RMSE of the positions [m] after the best rigid motion of the whole run onto the truth.
double absolute_error(const std::vector<Estimate>& estimates, const Trajectory& truth) {
  const auto count = static_cast<Eigen::Index>(estimates.size());
  Eigen::Matrix3Xd ours(3, count), theirs(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Estimate& estimate = estimates[static_cast<std::size_t>(i)];
    ours.col(i) = estimate.T_world_lidar.translation;
    theirs.col(i) = position_at(truth, estimate.stamp_ns);
  }
  const Eigen::Matrix4d T = Eigen::umeyama(ours, theirs, false);
  const Eigen::Matrix3Xd aligned =
      (T.topLeftCorner<3, 3>() * ours).colwise() + Eigen::Vector3d(T.topRightCorner<3, 1>());
  return std::sqrt((aligned - theirs).squaredNorm() / static_cast<double>(count));
}

void Recordings::expect_absolute_error(const char* name, std::size_t scans, double bound) {
  const auto estimates = run(name);
  ASSERT_EQ(estimates.size(), scans);
  for (const Estimate& estimate : estimates) EXPECT_TRUE(estimate.trusted()) << estimate.message;
  const double error = absolute_error(estimates, read_tum(shared(name) / "gt.tum"));
  std::printf("%s: APE RMSE %.4f m\n", name, error);
  EXPECT_LT(error, bound);
}

TEST_P(Recordings, TrottingUpARamp) {
  SKIP_WITHOUT("gait_ramp");
  expect_absolute_error("gait_ramp", 90, either(0.02, 0.11));  // measured: 0.012; 0.070 .. 0.073
}

TEST_P(Recordings, TrottingUpStairs) {
  SKIP_WITHOUT("gait_stairs");
  expect_absolute_error("gait_stairs", 90, either(0.02, 0.09));  // measured: 0.013; 0.051 .. 0.055
}

// A tenth of what is seen lies on a plane or a pole, and no scan is lost. Begun at each of the
// first scans the error is 0.009 to 0.016 m, by chance of what the cubes keep: the bound is above.
TEST_P(Recordings, TrottingOffAmongUndergrowth) {
  SKIP_WITHOUT("forest_start");
  expect_absolute_error("forest_start", 40, either(0.025, 0.13));  // measured: 0.016; 0.081
}

TEST_P(Recordings, ACarsStepsAreAsLongAsItsInertialSystemSays) {
  SKIP_WITHOUT("kitti_raw_0926_0048");
  const auto estimates = run("kitti_raw_0926_0048");
  ASSERT_EQ(estimates.size(), 16U);
  for (const Estimate& estimate : estimates) EXPECT_TRUE(estimate.trusted()) << estimate.message;
  const auto step = [&](std::size_t i) {
    return (estimates[i + 1].T_world_lidar.translation - estimates[i].T_world_lidar.translation)
        .norm();
  };
  std::printf("kitti_raw_0926_0048: first step %.4f m, last %.4f m\n", step(0), step(14));
  // Measured: 0.769 .. 0.803, although both scans came with the skew of a motion not known yet.
  EXPECT_NEAR(step(0), 0.761, 0.065);
}

TEST_P(Recordings, AStandingCarStands) {
  SKIP_WITHOUT("kitti_0057_static");
  const auto estimates = run("kitti_0057_static");
  ASSERT_EQ(estimates.size(), 5U);
  double farthest = 0.0, turned = 0.0;
  for (const Estimate& estimate : estimates) {
    EXPECT_TRUE(estimate.trusted()) << estimate.message;
    const Pose from_first = estimates.front().T_world_lidar.inverse() * estimate.T_world_lidar;
    farthest = std::max(farthest, from_first.translation.norm());
    turned = std::max(turned, so3_log(from_first.rotation).norm());
  }
  std::printf("kitti_0057_static: %.4f m, %.5f rad\n", farthest, turned);
  EXPECT_LT(farthest, 0.018);  // measured: 0.0081 .. 0.0111
  EXPECT_LT(turned, 0.0008);   // measured: 0.00034 .. 0.00043
}

#ifdef SUREFOOT_HAS_PCAP
TEST_P(Recordings, AStandingVlp16Stands) {
  SKIP_WITHOUT("vlp16_pcap");
  // A small room: where the scan is thinned as in a hall, too few points are left to register.
  Odometry odometry(config());
  int whole = 0;
  const auto recording =
      io::open_recording(shared("vlp16_pcap") / "sample_velodyne_vlp16_gps.pcap");
  while (const auto item = recording->next()) {
    if (!item->scan || !item->remark.empty()) continue;  // partial revolutions at the ends
    const Estimate estimate = odometry.add_scan(*item->scan);
    EXPECT_TRUE(estimate.trusted()) << estimate.message;
    const double moved = estimate.T_world_lidar.translation.norm();
    std::printf("vlp16_pcap: %.4f m, %s\n", moved, std::string(to_string(estimate.status)).c_str());
    EXPECT_LT(moved, 0.05);  // measured: 0.028 and 0.033
    ++whole;
  }
  EXPECT_EQ(whole, 3);
}
#endif

}  // namespace
}  // namespace surefoot
