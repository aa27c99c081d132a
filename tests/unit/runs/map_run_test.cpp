// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_run.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "runs/trajectory_inputs.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

using MapRunTest = test::Scratch;

Estimate estimate_at(int scan, int segment, Status status) {
  Estimate estimate;
  estimate.stamp_ns = 100'000'000LL * scan;
  estimate.T_world_lidar.translation.x() = scan;
  estimate.covariance = 1e-6 * Matrix6::Identity();
  estimate.segment = segment;
  estimate.status = status;
  return estimate;
}

TEST_F(MapRunTest, WhatNothingJoinsIsMarkedInTheOptimizedTrajectory) {
  mapping::MapperOptions options;
  options.close_loops = false;
  MapRun run(options, {});
  DeskewedScan wall;
  for (int i = 0; i < 100; ++i) {
    wall.points.emplace_back(5.0F, 0.1F * static_cast<float>(i % 10), 0.2F * static_cast<float>(i));
  }
  for (int i = 0; i < 30; ++i) {
    const int segment = i < 10 || i >= 20 ? 0 : 1;  // home at the end
    const Status status = i % 10 == 0 && i < 20 ? Status::first_scan : Status::ok;
    run.add(estimate_at(i, segment, status), Pose(), wall);
  }
  (void)run.finish(folder_, mapping::MapBuilder(0.1), false);
  const auto file = folder_ / kOptimizedTrajectoryFile;
  EXPECT_EQ(io::read_tum(file).size(), 30U);
  EXPECT_EQ(segments_of(file), 2U);
  EXPECT_EQ(segment_begins(file), (std::vector<std::size_t>{10, 20}));
}

// As a float 32.100042 s is less.
TEST_F(MapRunTest, TheFirstScanBehindARestartIsNotTakenForTheFrameBefore) {
  mapping::MapperOptions options;
  options.close_loops = false;
  MapRun run(options, {});
  mapping::MapBuilder map(0.1);
  DeskewedScan wall;
  for (int i = 0; i < 100; ++i) wall.points.emplace_back(5.0F, 0.1F * static_cast<float>(i), 0.0F);
  for (int i = 0; i < 20; ++i) {
    const int segment = i / 10;
    Estimate estimate = estimate_at(i % 10, segment, i % 10 == 0 ? Status::first_scan : Status::ok);
    if (segment > 0) estimate.stamp_ns += 32'100'042'000LL;
    run.add(estimate, Pose(), wall);
    map.add(wall, estimate.T_world_lidar, {estimate.stamp_ns, static_cast<std::size_t>(segment)});
  }
  (void)run.finish(folder_, map, false);
  std::vector<std::byte> bytes;
  io::read_whole_file(folder_ / kOptimizedMapFile, bytes);
  EXPECT_EQ(io::parse_ply(bytes).size, map.points().size());
}

}  // namespace
}  // namespace surefoot::runs
