// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <vector>

#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "runs/run_output.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

class DenseTrajectory : public test::Scratch {
 protected:
  DenseTrajectory() {
    options_.output = folder_ / "out";
    options_.pose_rate = 100.0;
  }

  /// A scan of one that walks 1 m/s along x.
  static Estimate walked(std::int64_t start_ns, std::int64_t end_ns) {
    const auto pose_at = [](std::int64_t stamp_ns) {
      return Pose{Eigen::Quaterniond::Identity(), {1e-9 * static_cast<double>(stamp_ns), 0.0, 0.0}};
    };
    Estimate estimate;
    estimate.status = Status::ok;
    estimate.trajectory = ScanTrajectory({pose_at(start_ns), pose_at(end_ns)}, start_ns, end_ns);
    estimate.stamp_ns = estimate.trajectory.mid_ns();
    estimate.T_world_lidar = pose_at(estimate.stamp_ns);
    return estimate;
  }

  [[nodiscard]] Trajectory dense_of(const std::vector<Estimate>& estimates) const {
    RunOutput output(options_);
    output.begin(options_);
    for (const Estimate& estimate : estimates) output.add("scan", estimate, Pose{}, {});
    return io::read_tum(options_.output / kDenseTrajectoryFile);
  }

  RunOptions options_;
};

TEST_F(DenseTrajectory, HasNoHoleBetweenScansThatFollowEachOther) {
  std::vector<Estimate> scans;
  for (int i = 0; i < 5; ++i) {  // the last point of each is a moment before the next one's first
    scans.push_back(walked(i * 100 * kMillisecond, (i * 100 + 97) * kMillisecond));
  }
  scans[2] = walked(200 * kMillisecond + 1, 297 * kMillisecond);  // an instant lies in the seam
  const Trajectory dense = dense_of(scans);
  ASSERT_EQ(dense.size(), 50);
  for (std::size_t i = 0; i < dense.size(); ++i) {
    EXPECT_EQ(dense[i].stamp_ns, static_cast<std::int64_t>(i) * 10 * kMillisecond);
    EXPECT_NEAR(dense[i].pose.translation.x(), 0.01 * static_cast<double>(i), 1e-6);
  }
}

TEST_F(DenseTrajectory, OfScansThatOverlapEachInstantIsThereOnce) {
  const Trajectory dense =
      dense_of({walked(0, 100 * kMillisecond), walked(100 * kMillisecond, 200 * kMillisecond),
                walked(195 * kMillisecond, 300 * kMillisecond)});
  ASSERT_EQ(dense.size(), 31);
  for (std::size_t i = 0; i < dense.size(); ++i) {
    EXPECT_EQ(dense[i].stamp_ns, static_cast<std::int64_t>(i) * 10 * kMillisecond);
  }
}

TEST_F(DenseTrajectory, AMissingScanIsLeftOut) {
  const Trajectory dense =
      dense_of({walked(0, 99 * kMillisecond), walked(200 * kMillisecond, 299 * kMillisecond)});
  ASSERT_EQ(dense.size(), 20);
  EXPECT_EQ(dense[9].stamp_ns, 90 * kMillisecond);
  EXPECT_EQ(dense[10].stamp_ns, 200 * kMillisecond);
}

}  // namespace
}  // namespace surefoot::runs
