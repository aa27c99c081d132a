// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans without usable point times: noticed, said, and mended by azimuth.
#include "io/point_time_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "support/memory_recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::int64_t kPeriod = 100'000'000;

/// Sixteen lasers that turn once from `cut_deg` on, `sign` -1 clockwise; times as they were.
Scan spinning(double cut_deg, double sign) {
  Scan scan;
  for (int step = 0; step < 900; ++step) {
    const double azimuth = (cut_deg + sign * 0.4 * step) * kDegree;
    for (int ring = 0; ring < 16; ++ring) {
      const double elevation = (-15.0 + 2.0 * ring) * kDegree, range = 5.0 + ring;
      scan.points.emplace_back(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)),
                               static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)),
                               static_cast<float>(range * std::sin(elevation)));
      scan.times_ns.push_back(static_cast<std::int32_t>(kPeriod * step / 900));
    }
  }
  return scan;
}

/// 10 a second.
std::unique_ptr<Recording> recording_of(std::vector<Scan> scans) {
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns = kPeriod * static_cast<std::int64_t>(i);
  }
  return std::make_unique<surefoot::test::MemoryRecording>(
      std::move(scans), std::vector<std::string>{"stamps: made up"});
}

std::vector<std::string> notes_of(const Scan& scan) {
  const auto recording = watch_point_times(recording_of(std::vector<Scan>(5, scan)), OpenOptions{});
  while (recording->next()) {
  }
  return recording->notes();
}

TEST(PointTimeWatch, SaysOnceThatThereAreNoTimesOrThatAllAreEqual) {
  Scan scan = spinning(0.0, -1.0);
  EXPECT_EQ(notes_of(scan), std::vector<std::string>{"stamps: made up"});
  std::fill(scan.times_ns.begin(), scan.times_ns.end(), 7);
  ASSERT_EQ(notes_of(scan).size(), 2U);
  EXPECT_NE(notes_of(scan)[1].find("all equal"), std::string::npos);
  scan.times_ns.clear();
  ASSERT_EQ(notes_of(scan).size(), 2U);
  EXPECT_NE(notes_of(scan)[1].find("--derive-times azimuth"), std::string::npos);
}

TEST(PointTimeWatch, NamesAFieldThatMayHoldThem) {
  const test::TemporaryFolder folder;
  std::string file =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z Laser_Time\nSIZE 4 4 4 4\n"
      "TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n"
      "1 2 3 0\n2 3 4 0.05\n3 4 5 0.1\n";
  for (const char* name : {"s/1.pcd", "s/2.pcd", "s/3.pcd"}) folder.write(name, file);
  folder.write("s/times.txt", "1\n2\n3\n");
  const auto recording = open_recording(folder.path() / "s");
  while (recording->next()) {
  }
  const std::string notes = test::joined(recording->notes());
  EXPECT_NE(notes.find("--time-field Laser_Time"), std::string::npos) << notes;
}

TEST(PointTimeWatch, SaysThatTimesRunBackward) {
  Scan scan = spinning(0.0, -1.0);
  for (std::int32_t& time : scan.times_ns) time = static_cast<std::int32_t>(kPeriod) - time;
  ASSERT_EQ(notes_of(scan).size(), 2U);
  EXPECT_NE(notes_of(scan)[1].find("reversed"), std::string::npos);
}

TEST(PointTimeWatch, SaysThatSweepsLastLongerThanItIsToTheNext) {
  const auto told = [](double share) {
    Scan scan = spinning(0.0, -1.0);
    for (std::int32_t& time : scan.times_ns) time = static_cast<std::int32_t>(time * share);
    const auto recording =
        watch_point_times(recording_of(std::vector<Scan>(20, scan)), OpenOptions{});
    while (recording->next()) {
    }
    return test::joined(recording->notes());
  };
  const std::string notes = told(10.0);  // a share of the sweep, read as seconds
  EXPECT_NE(notes.find("sweeps last 0.9989 s, and the scans are 0.1000 s apart"), std::string::npos)
      << notes;
  EXPECT_EQ(told(1.3).find("sweeps last"), std::string::npos);
}

TEST(PointTimeWatch, TimesAreDerivedFromTheColumnsOfWholeScansAlone) {
  Scan scan = spinning(0.0, -1.0);
  scan.times_ns.clear();
  OpenOptions options;
  options.rows = 16;
  for (const std::size_t columns : {std::size_t{900}, std::size_t{1024}}) {
    options.columns = columns;
    const auto recording = watch_point_times(recording_of(std::vector<Scan>(5, scan)), options);
    const auto first = recording->next();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->scan->times_ns.empty(), columns != 900);
    while (recording->next()) {
    }
    const std::string notes = test::joined(recording->notes());
    EXPECT_EQ(notes.find(": derived from the columns") != std::string::npos, columns == 900)
        << notes;
    EXPECT_EQ(notes.find("all 16384 points; the first has 14400") != std::string::npos,
              columns != 900)
        << notes;
  }
}

TEST(PointTimeWatch, KnowsTheSpinOfASpinningLidarOnly) {
  EXPECT_EQ(spin_of(spinning(30.0, -1.0)), Spin::clockwise);
  EXPECT_EQ(spin_of(spinning(30.0, 1.0)), Spin::counterclockwise);
  Scan everywhere = spinning(0.0, -1.0);  // looks all about at any instant
  for (std::size_t i = 0; i < everywhere.times_ns.size(); ++i) {
    everywhere.times_ns[i] = static_cast<std::int32_t>((i * 7919) % everywhere.times_ns.size());
  }
  EXPECT_EQ(spin_of(everywhere), std::nullopt);
  EXPECT_EQ(spin_of({}), std::nullopt);
}

TEST(PointTimeWatch, DerivedTimesAreThoseOfTheSweep) {
  for (const double sign : {-1.0, 1.0}) {
    for (const double cut_deg : {0.0, 180.0, 275.0}) {
      const Scan truth = spinning(cut_deg, sign);
      for (const StampAt stamp_at : {StampAt::start, StampAt::end}) {
        Scan scan = truth;
        scan.times_ns.clear();
        const Spin spin = sign < 0.0 ? Spin::clockwise : Spin::counterclockwise;
        derive_times(scan, {spin, cut_deg, kPeriod, stamp_at});
        const std::int64_t shift = stamp_at == StampAt::end ? kPeriod : 0;
        // The first column lies on the cut itself, where rounding decides.
        for (std::size_t i = 16; i < scan.times_ns.size(); ++i) {
          ASSERT_NEAR(static_cast<double>(scan.times_ns[i] + shift), truth.times_ns[i], 100.0);
        }
      }
    }
  }
}

TEST(PointTimeWatch, TheRecordingsStampsTellThePeriodAndNothingIsLost) {
  Scan scan = spinning(0.0, -1.0);
  scan.times_ns.clear();
  OpenOptions options;
  options.derive_times = DeriveTimes::azimuth;
  const auto recording = watch_point_times(recording_of(std::vector<Scan>(15, scan)), options);
  int scans = 0;
  while (const auto item = recording->next()) {
    ASSERT_EQ(item->scan->stamp_ns, kPeriod * scans++);
    const auto [least, greatest] =
        std::minmax_element(item->scan->times_ns.begin(), item->scan->times_ns.end());
    EXPECT_NEAR(*greatest - *least, kPeriod, 0.01 * kPeriod);
  }
  EXPECT_EQ(scans, 15);
  const auto lone = watch_point_times(recording_of(std::vector<Scan>{scan}), options);
  EXPECT_THROW((void)lone->next(), ReadError) << "one stamp tells no period";
}

TEST(PointTimeWatch, AgreesWithWhatWasDerivedElsewhere) {
  const std::filesystem::path folder =
      std::filesystem::path(SUREFOOT_SHARED_DATA) / "kitti_raw_0926_0048";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  const auto given = open_recording(folder);
  OpenOptions options;
  options.derive_times = DeriveTimes::azimuth;
  options.cut_azimuth_deg = 180.0;  // clockwise from the rear
  const auto derived = open_recording(folder, options);
  const auto a = given->next(), b = derived->next();
  ASSERT_TRUE(a && a->scan && b && b->scan);
  ASSERT_EQ(a->scan->points.size(), b->scan->points.size());
  std::vector<double> differences_ms;
  for (std::size_t i = 0; i < a->scan->points.size(); ++i) {
    differences_ms.push_back(1e-6 * std::abs(a->scan->times_ns[i] - b->scan->times_ns[i]));
  }
  std::nth_element(differences_ms.begin(), differences_ms.begin() + differences_ms.size() / 2,
                   differences_ms.end());
  // Nominal stamps there: a revolution is taken to be 3 % longer or shorter than here.
  EXPECT_LT(differences_ms[differences_ms.size() / 2], 2.0);
}

}  // namespace
}  // namespace surefoot::io
