// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/trajectory_inputs.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace surefoot::runs {
namespace {

/// Two poses of the first segment, two of the next, and one at home again.
TEST(TrajectoryInputs, TellWithWhichPosesAnotherSegmentBegins) {
  const auto file = std::filesystem::path(testing::TempDir()) / "segments.tum";
  std::ofstream(file) << "# stamp x y z qx qy qz qw\n"
                         "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n"
                         "# segment 1: in a frame of its own\n"
                         "3 0 0 0 0 0 0 1\n\n4 1 0 0 0 0 0 1\n"
                         "# segment 0: in a frame of its own\n"
                         "5 2 0 0 0 0 0 1\n";
  EXPECT_EQ(segment_begins(file), (std::vector<std::size_t>{2, 4}));
  EXPECT_EQ(segments_of(file), 2U);
  std::ofstream(file) << "# segment 1: in a frame of its own\n1 0 0 0 0 0 0 1\n";
  EXPECT_TRUE(segment_begins(file).empty()) << "there is no pose before";
  std::ofstream(file) << "1 0 0 0 0 0 0 1\n# segment 1: in a frame of its own\n";
  EXPECT_TRUE(segment_begins(file).empty()) << "there is no pose after: the run was cut short";
}

}  // namespace
}  // namespace surefoot::runs
