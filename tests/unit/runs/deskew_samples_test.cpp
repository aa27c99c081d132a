// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/deskew_samples.hpp"

#include <limits>

#include "io/recording.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

constexpr std::int64_t kSweep = 100'000'000;  // [ns]

/// Points at 0, 50 and 100 ms, and one that is none.
Scan scan_at(std::int64_t stamp_ns) {
  Scan scan;
  scan.stamp_ns = stamp_ns;
  scan.points = {{5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}};
  scan.times_ns = {0, kSweep / 2, kSweep, kSweep};
  return scan;
}

/// A sensor that moves evenly along x, by `way` within the sweep, and stands at x = 10 at its
/// middle.
Estimate moving(std::int64_t stamp_ns, double way) {
  Estimate estimate;
  estimate.status = Status::ok;
  Pose first, middle, last;
  first.translation = {10.0 - way / 2, 0, 0};
  middle.translation = {10.0, 0, 0};
  last.translation = {10.0 + way / 2, 0, 0};
  estimate.trajectory = ScanTrajectory({first, last}, stamp_ns, stamp_ns + kSweep);
  estimate.T_world_lidar = middle;
  return estimate;
}

TEST(DeskewSamples, APointIsWhereTheSensorSawItAtItsOwnInstant) {
  DeskewSamples samples;
  samples.add(3, scan_at(0), moving(0, 1.0));
  ASSERT_EQ(samples.samples().size(), 1U);
  const report::DeskewSample sample = samples.samples().front();
  EXPECT_EQ(sample.scan, 3U);
  ASSERT_EQ(sample.deskewed.size(), 3U);  // the fourth is no point
  EXPECT_TRUE(sample.measured[0].isApprox(Eigen::Vector3f(15, 0, 0)));
  EXPECT_TRUE(sample.deskewed[0].isApprox(Eigen::Vector3f(14.5F, 0, 0)));
  EXPECT_TRUE(sample.deskewed[1].isApprox(sample.measured[1]));
  EXPECT_TRUE(sample.deskewed[2].isApprox(Eigen::Vector3f(10.5F, 0, 5)));
  EXPECT_EQ(sample.times, (std::vector<float>{0.0F, 0.5F, 1.0F}));
}

TEST(DeskewSamples, TheFourLiveliestSweepsThatAreApart) {
  DeskewSamples samples;
  for (std::size_t line = 0; line < 200; ++line) {
    const double way = line % 40 == 7 ? 1.0 + 0.01 * double(line) : 0.1;
    const auto stamp = std::int64_t(line) * kSweep;
    samples.add(line, scan_at(stamp), moving(stamp, way));
  }
  std::vector<std::size_t> lines;
  for (const report::DeskewSample& sample : samples.samples()) lines.push_back(sample.scan);
  EXPECT_EQ(lines, (std::vector<std::size_t>{47, 87, 127, 167}));
}

TEST(DeskewSamples, ScansWithoutTimesAndLostOnesShowNothing) {
  DeskewSamples samples;
  Scan timeless = scan_at(0);
  timeless.times_ns.clear();
  samples.add(0, timeless, moving(0, 1.0));
  Estimate lost = moving(0, 1.0);
  lost.status = Status::diverged;
  samples.add(1, scan_at(0), lost);
  EXPECT_TRUE(samples.samples().empty());
}

using DeskewSamplesFile = test::Scratch;

TEST_F(DeskewSamplesFile, ReadsWhatItWrote) {
  DeskewSamples samples;
  samples.add(2, scan_at(0), moving(0, 1.0));
  samples.add(30, scan_at(kSweep), moving(kSweep, 2.0));
  write_deskew_samples(folder_ / "deskewing.ply", samples.samples());
  const auto read = read_deskew_samples(folder_ / "deskewing.ply");
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].scan, samples.samples()[i].scan);
    EXPECT_EQ(read[i].measured, samples.samples()[i].measured);
    EXPECT_EQ(read[i].deskewed, samples.samples()[i].deskewed);
    EXPECT_EQ(read[i].times, samples.samples()[i].times);
  }
}

TEST_F(DeskewSamplesFile, AnotherPlyIsRefusedByName) {
  write("deskewing.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n1 2 3\n");
  try {
    (void)read_deskew_samples(folder_ / "deskewing.ply");
    ADD_FAILURE() << "taken";
  } catch (const io::ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("deskewing.ply: its points have no measured_x"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace surefoot::runs
