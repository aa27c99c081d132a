// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Who sees nothing for a while, or is carried, is not taken to be where he is not: in a hall of
// equal bays, and on an open field.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "io/trajectory_files.hpp"
#include "process.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr int kScans = 260;

class InterruptedWalk : public testing::Test {
 protected:
  static void simulate(const std::string& scene, const std::string& seed) {
    scratch_ = std::make_unique<ScratchFolder>();
    truth_.clear();
    simulated_ = run_surefoot({"simulate", scene, "--seed", seed, "--scans", std::to_string(kScans),
                               "--no-footprint", "-q", "-o", "whole"},
                              scratch_->path())
                     .exit_code == 0;
    if (simulated_) truth_ = io::read_tum(path("whole") / "gt.tum");
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  void SetUp() override {
    if (!simulated_) GTEST_SKIP() << "built without the simulation";
  }
  [[nodiscard]] static fs::path path(const std::string& name) { return scratch_->path() / name; }

  /// What is estimated of the scans before one, and then of those from another on, which come so
  /// much later [s] than they were made.
  static Trajectory estimates(int before, int from, double later) {
    std::istringstream lines(file_content(path("whole") / "times.txt"));
    std::vector<double> times(kScans);
    for (double& time : times) lines >> time;
    fs::remove_all(path("cut"));
    fs::create_directory(path("cut"));
    std::string kept;
    int next = 0;
    const auto keep = [&](int scan, double by) {
      const auto name = [](int number) { return fmt::format("{:06d}.pcd", number); };
      fs::copy_file(path("whole") / name(scan), path("cut") / name(next++));
      kept += fmt::format("{:.9f}\n", times[static_cast<std::size_t>(scan)] + by);
    };
    for (int scan = 0; scan < before; ++scan) keep(scan, 0.0);
    for (int scan = from; scan < kScans; ++scan) keep(scan, later);
    write_content(path("cut") / "times.txt", kept);
    const ProcessResult run = run_surefoot(
        {"run", "cut", "-o", "run", "--overwrite", "--no-report", "--no-picture", "--no-map", "-q"},
        scratch_->path());
    EXPECT_EQ(run.exit_code, 0) << run;
    return io::read_tum(path("run") / "trajectory.tum");
  }

  /// How far [m] a pose is from where it truly is, in the frame of the first one.
  static double error(const Trajectory& estimated, const StampedPose& pose, double later) {
    const auto at = [&](std::int64_t stamp_ns) {
      return std::find_if(truth_.begin(), truth_.end() - 1,
                          [&](const StampedPose& known) { return known.stamp_ns >= stamp_ns; })
          ->pose;
    };
    const StampedPose& first = estimated.front();
    const Pose T_truth = at(first.stamp_ns) * first.pose.inverse();
    const auto made_ns = pose.stamp_ns - static_cast<std::int64_t>(1e9 * later);
    return (T_truth * pose.pose.translation - at(made_ns).translation).norm();
  }

  /// Each pose is where it truly is to less than so much [m]; those from the number `before` on
  /// were said to be so much later [s] than they were made.
  static void expect_right(const Trajectory& estimated, std::size_t before, double later,
                           double bound) {
    for (std::size_t i = 0; i < estimated.size(); ++i) {
      ASSERT_LT(error(estimated, estimated[i], i < before ? 0.0 : later), bound) << i;
    }
  }

  static inline std::unique_ptr<ScratchFolder> scratch_;
  static inline Trajectory truth_;
  static inline bool simulated_ = false;
};

class EqualBays : public InterruptedWalk {
 protected:
  static void SetUpTestSuite() { simulate("bays", "310"); }
};

class ShorterBays : public InterruptedWalk {
 protected:
  static void SetUpTestSuite() { simulate("bays", "330"); }
};

class OpenField : public InterruptedWalk {
 protected:
  static void SetUpTestSuite() { simulate("playground", "311"); }
};

// The bay behind fits better, which was seen whole.
TEST_F(EqualBays, WhoWalkedOnUnseenIsNotABayBehind) {
  const Trajectory estimated = estimates(160, 190, 0.0);
  ASSERT_GT(estimated.size(), 220U);
  expect_right(estimated, estimated.size(), 0.0, 0.1);
}

// The bay that is found first is nearer than the one that he was carried to.
TEST_F(EqualBays, WhoWasCarriedIsNotFoundInTheNextBay) {
  constexpr double kLater = 6.0;
  const Trajectory estimated = estimates(200, 140, kLater);
  ASSERT_GT(estimated.size(), 210U) << "it is found";
  expect_right(estimated, 200, kLater, 0.1);
}

// A bay behind he would be about where he was, but would see what he has not seen from there.
TEST_F(ShorterBays, WhoWalkedOnUnseenHasNotStayed) {
  const Trajectory estimated = estimates(130, 160, 0.0);
  ASSERT_GT(estimated.size(), 220U);
  expect_right(estimated, estimated.size(), 0.0, 0.1);
}

// The ground fits everywhere, and fence and goals are far away: where all that stands suddenly is
// new, it has to be asked whether he knows it from elsewhere.
TEST_F(OpenField, WhoWasCarriedIsNotWhereHeWas) {
  constexpr double kLater = 17.0;
  const Trajectory estimated = estimates(200, 30, kLater);
  ASSERT_GT(estimated.size(), 350U) << "it is found";
  expect_right(estimated, 200, kLater, 0.2);
}

}  // namespace
}  // namespace surefoot::test
