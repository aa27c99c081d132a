// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_output.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file_writer.hpp"
#include "runs/localization_run.hpp"
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

/// As if so many files were open that one more can be opened.
class OneMoreFile {
 public:
  OneMoreFile() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const int next = open("/dev/null", O_RDONLY);
    close(next);
    const rlimit one_more{static_cast<rlim_t>(next) + 1, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &one_more);
  }
  ~OneMoreFile() { setrlimit(RLIMIT_NOFILE, &before_); }
  OneMoreFile(const OneMoreFile&) = delete;
  OneMoreFile& operator=(const OneMoreFile&) = delete;

 private:
  rlimit before_{};
};

TEST_F(RunOutputTest, AFileThatCannotBeOpenedIsNamedWithTheSystemsReason) {
  RunOptions options;
  options.input = "memory";
  options.output = folder_ / "out";
  RunOutput output(options);
  std::string told;
  try {
    const OneMoreFile scans_csv_alone;
    output.begin(options);
  } catch (const std::runtime_error& error) {
    told = error.what();
  }
  EXPECT_TRUE(told.ends_with("trajectory.tum: cannot be written: Too many open files")) << told;
}

/// As if the disk had no more room for any file than so many bytes.
class RoomFor {
 public:
  explicit RoomFor(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit room{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &room);
  }
  ~RoomFor() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  RoomFor(const RoomFor&) = delete;
  RoomFor& operator=(const RoomFor&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(RunOutputTest, WhatCannotBeWrittenOnIsToldWithTheSystemsReason) {
  RunOptions options;
  options.input = "memory";
  options.output = folder_ / "out";
  RunOutput output(options);
  output.begin(options);
  std::string told;
  try {
    const RoomFor little(1000);
    for (int i = 0; i < 100; ++i) output.add("", Estimate(), Pose(), {});
  } catch (const std::runtime_error& error) {
    told = error.what();
  }
  EXPECT_EQ(told, (folder_ / "out").string() + ": cannot be written any more: File too large");
}

TEST_F(RunOutputTest, PlacesInAMapThatCannotBeWrittenAreToldWithTheSystemsReason) {
  std::filesystem::create_symlink("/dev/full", folder_ / kLocalizationFile);
  LocalizationRun run({}, Pose());
  std::string told;
  try {
    run.open(folder_);
  } catch (const io::WriteError& error) {
    told = error.what();
  }
  EXPECT_EQ(told, folder_.string() + ": cannot be written any more: No space left on device");
}

}  // namespace
}  // namespace surefoot::runs
