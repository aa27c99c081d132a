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

TEST(TrajectoryInputs, NamesOfEstimatesAreOneLineEach) {
  EXPECT_EQ(estimate_names({"/r/a\nb.tum", "/r/c.tum", "/s\n/c.tum"}),
            (std::vector<std::string>{"a?b", "/r/c.tum", "/s?/c.tum"}));
}

// With blanks as with commas; the names' order of the rotation counts.
TEST(TrajectoryInputs, ALineOfNamesNeedsNoMark) {
  const auto file = std::filesystem::path(testing::TempDir()) / "names.txt";
  std::ofstream(file) << "stamp x y z qw qx qy qz\n1.5 1 2 3 1 0 0 0\n2.5 1 2 4 0 1 0 0\n";
  ReferenceRequest request;
  request.path = file;
  const Trajectory poses = read_reference(request).truth.poses;
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].stamp_ns, 1'500'000'000);
  EXPECT_EQ(poses[1].pose.rotation.x(), 1.0);
  std::ofstream(file) << "# stamp x y z qw qx qy qz\n1.5 1 2 3 1 0 0 0\n";
  EXPECT_EQ(read_reference(request).truth.poses[0].pose.rotation.w(), 1.0);
}

TEST(TrajectoryInputs, WholeTimesThatAreNoSecondsAreRead) {
  const auto file = std::filesystem::path(testing::TempDir()) / "whole.tum";
  constexpr std::int64_t kStep = 100'000'000;  // [ns]
  const auto write = [&](std::int64_t first, std::int64_t step) {
    std::ofstream stream(file);
    for (int i = 0; i < 3; ++i) stream << first + i * step << " 0 0 0 0 0 0 1\n";
  };
  const auto read = [&] {
    ReferenceRequest request;
    request.path = file;
    return read_reference(request).truth.poses;
  };
  const auto is = [&](std::int64_t first_ns) {
    const Trajectory poses = read();
    ASSERT_EQ(poses.size(), 3U);
    EXPECT_EQ(poses.front().stamp_ns, first_ns);
    EXPECT_EQ(poses.back().stamp_ns, first_ns + 2 * kStep);
  };
  write(1'630'577'758'569, kStep / 1'000'000);
  is(1'630'577'758'569'000'000);
  write(1'630'577'758'569'489, kStep / 1'000);
  is(1'630'577'758'569'489'000);
  write(200'000'000'000, kStep);  // since a start
  is(200'000'000'000);
  write(0, kStep);
  is(0);
  std::ofstream(file) << "1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n";
  EXPECT_EQ(read().back().stamp_ns, 2'000'000'000);
}

TEST(TrajectoryInputs, AMarkOfUtf8BeforeTheFirstLineIsNoPartOfIt) {
  const auto file = std::filesystem::path(testing::TempDir()) / "marked.tum";
  for (const char* begin : {"\xEF\xBB\xBF", "\xEF\xBB\xBF# t x y z qx qy qz qw\n"}) {
    std::ofstream(file) << begin << "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n";
    ReferenceRequest request;
    request.path = file;
    EXPECT_EQ(read_reference(request).truth.poses.size(), 2U);
  }
}

TEST(TrajectoryInputs, StampsAgainstAReferenceWithoutAreToldAsThat) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "stamped_run";
  std::filesystem::create_directories(folder);
  const auto truth = std::filesystem::path(testing::TempDir()) / "00.txt";
  std::ofstream(truth) << "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n";
  std::ofstream(folder / "trajectory.tum") << "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n";
  std::ofstream(folder / "trajectory_kitti.txt") << "1 0 0 0 0 1 0 0 0 0 1 0\n";
  ReferenceRequest request;
  request.path = truth;
  try {
    (void)read_estimate(folder, read_reference(request));
    FAIL() << "is read";
  } catch (const io::ReadError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("--dataset kitti"), std::string::npos) << text;
    EXPECT_NE(text.find("trajectory_kitti.txt"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace surefoot::runs
