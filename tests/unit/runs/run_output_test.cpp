// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_output.hpp"

#include <vector>

#include "runs/run_files.hpp"
#include "runs/trajectory_inputs.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

using RunOutputTest = test::Scratch;

TEST_F(RunOutputTest, EveryTrajectoryTellsWhereAnotherSegmentBegins) {
  RunOptions options;
  options.input = "memory";
  options.output = folder_ / "out";
  options.pose_rate = 100.0;
  RunOutput output(options);
  output.begin(options);
  for (int i = 0; i < 4; ++i) {
    Estimate estimate;
    estimate.stamp_ns = 100'000'000LL * i;
    estimate.status = i % 2 == 0 ? Status::first_scan : Status::ok;
    estimate.segment = i / 2;
    output.add("", estimate, Pose(), {});
  }
  for (const char* file : {kTrajectoryFile, kDenseTrajectoryFile}) {
    EXPECT_EQ(segments_of(folder_ / "out" / file), 2U) << file;
  }
}

}  // namespace
}  // namespace surefoot::runs
