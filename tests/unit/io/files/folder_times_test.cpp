// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/recording.hpp"
#include "io/recording_summary.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

using test::error_of;
using test::read_all;
using test::TemporaryFolder;
using test::timed_pcd;

TEST(FolderRecording, NegativeOffsetsCountFromTheLastPacket) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<float>({-0.0625F, 0.0F}));
  folder.write("times.txt", "100.5\n");
  EXPECT_EQ(read_all(folder.path())[0].scan->times_ns, (std::vector<std::int32_t>{-62'500'000, 0}));
}

TEST(FolderRecording, StampAtTheEnd) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("times.txt", "100.5\n");
  OpenOptions options;
  options.stamp_at = StampAt::end;
  EXPECT_EQ(read_all(folder.path(), options)[0].scan->times_ns,
            (std::vector<std::int32_t>{-62'500'000, 0}));
}

// Differences of any two fit 64 bits.
TEST(FolderRecording, StampsOfNoTimeAreKeptWithinThreeCenturies) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("b.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("c.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("times.txt", "-9000000000\n9000000000\n1630577758\n");
  OpenOptions options;
  options.repair_stamps = false;
  const std::vector<ScanItem> items = read_all(folder.path(), options);
  EXPECT_EQ(items[0].scan->stamp_ns, -4'294'967'296'000'000'000);
  EXPECT_EQ(items[1].scan->stamp_ns, 4'294'967'296'000'000'000);
}

TEST(FolderRecording, AbsoluteTimesGiveTheStamp) {
  const TemporaryFolder folder;
  const double start = 1630577758.0;
  folder.write("000000.pcd", timed_pcd<double>({start + 0.0625, start, start + 0.03125}));
  folder.write("000001.pcd", timed_pcd<double>({start + 0.125, start + 0.1875}));
  const std::vector<ScanItem> items = read_all(folder.path());
  EXPECT_EQ(items[0].scan->stamp_ns, 1630577758000000000);
  EXPECT_EQ(items[0].scan->times_ns, (std::vector<std::int32_t>{62'500'000, 0, 31'250'000}));
  EXPECT_EQ(items[1].scan->stamp_ns, 1630577758125000000);
}

TEST(FolderRecording, AbsoluteTimesGiveTheOrderWhereNamesTellNone) {
  const std::vector<std::string> names = {"hall.pcd", "attic.pcd", "cellar.pcd", "yard.pcd"};
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double begin = 1630577758.0 + 0.125 * static_cast<double>(i);
    folder.write(names[i], timed_pcd<double>({begin, begin + 0.0625}));
  }
  folder.write("broken.pcd", "garbage");
  const auto recording = open_recording(folder.path());
  EXPECT_EQ(recording->notes().back(), "scans: in the order of these times, not of their names");
  std::vector<std::string> read;
  while (const auto item = recording->next()) {
    if (item->scan) read.push_back(item->name);
  }
  EXPECT_EQ(read, names);
}

// Numbers are an order, and the clock may have been set back.
TEST(FolderRecording, NamesThatCountAreTheOrder) {
  const TemporaryFolder folder;
  for (int i = 0; i < 6; ++i) {
    const double begin = 1630577758.0 + 0.125 * i - (i < 3 ? 0.0 : 60.0);
    folder.write("scan" + std::to_string(i + 7) + ".pcd",
                 timed_pcd<double>({begin, begin + 0.0625}));
  }
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(items[i].name, "scan" + std::to_string(i + 7) + ".pcd");
  }
}

TEST(FolderRecording, AbsoluteNanosecondsInADoubleAgainstAStampsFile) {
  const TemporaryFolder folder;
  // Multiples of 256 ns, which a double holds at this size.
  const double start = 1630577758000000000.0;
  folder.write("a.pcd", timed_pcd<double>({start + 256.0, start + 99'999'744.0}, "timestamp"));
  folder.write("stamps.txt", "1630577758000000000\n");
  EXPECT_EQ(read_all(folder.path())[0].scan->times_ns,
            (std::vector<std::int32_t>{256, 99'999'744}));
}

TEST(FolderRecording, OusterNanoseconds) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<std::uint32_t>({0, 99'999'999, 5}, "t"));
  const auto recording = open_recording(folder.path());
  EXPECT_EQ(recording->next()->scan->times_ns, (std::vector<std::int32_t>{0, 99'999'999, 5}));
  ASSERT_FALSE(recording->notes().empty());
  EXPECT_EQ(recording->notes()[0],
            "time field 't': u32, nanoseconds relative to the stamp, 0 .. 99999999");
}

// The one in the middle is looked at first.
TEST(FolderRecording, AScanOfOnePacketDoesNotTellTheUnit) {
  const TemporaryFolder folder;
  for (const char* name : {"0.pcd", "2.pcd"}) {
    folder.write(name, timed_pcd<std::uint32_t>({0, 99'999'999}, "t"));
  }
  folder.write("1.pcd", timed_pcd<std::uint32_t>({0, 475'000}, "t"));
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[1].scan->times_ns, (std::vector<std::int32_t>{0, 475'000}));
  EXPECT_EQ(items[2].scan->times_ns, (std::vector<std::int32_t>{0, 99'999'999}));
}

TEST(FolderRecording, PointsWithoutTimeAreDroppedAndCounted) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<float>({0.0F, NAN, 0.0625F, INFINITY}));
  const ScanItem item = read_all(folder.path())[0];
  EXPECT_EQ(item.dropped_points, 2U);
  EXPECT_EQ(item.scan->times_ns, (std::vector<std::int32_t>{0, 62'500'000}));
  ASSERT_EQ(item.scan->points.size(), 2U);
  EXPECT_EQ(item.scan->points[1].x(), 3.0F);
}

TEST(FolderRecording, EqualTimesAreLegal) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<float>({0.0F, 0.0F}));
  EXPECT_EQ(read_all(folder.path())[0].scan->times_ns, (std::vector<std::int32_t>{0, 0}));
}

TEST(FolderRecording, TimesThatFitNoRuleAreAnErrorThatNamesThem) {
  const TemporaryFolder folder;
  folder.write("a.pcd", timed_pcd<std::uint32_t>({0, 7}));
  const std::string message = error_of(folder.path());
  EXPECT_NE(message.find("a.pcd: field 'time'"), std::string::npos) << message;
  EXPECT_NE(message.find("u32 values 0 .. 7"), std::string::npos) << message;
  OpenOptions options;
  options.time_unit = TimeUnit::milliseconds;
  EXPECT_EQ(read_all(folder.path(), options)[0].scan->times_ns[1], 7'000'000);
}

TEST(FolderRecording, OneScanOfOddTimesDoesNotRefuseTheOthers) {
  const TemporaryFolder folder;
  for (const char* name : {"0.pcd", "1.pcd", "2.pcd"}) {
    folder.write(name, timed_pcd<float>({0.0F, 0.0625F}));
  }
  folder.write("1.pcd", timed_pcd<float>({0.0F, 5000.0F}));
  const auto items = read_all(folder.path());
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].scan->times_ns[1], 62'500'000);
  EXPECT_FALSE(items[1].scan);
  EXPECT_EQ(items[2].scan->times_ns[1], 62'500'000);
}

// A sweep's first and last points may be none: that says nothing of their times.
TEST(FolderRecording, PointsThatAreNoReturnsAreNotSaidToLackTimes) {
  const TemporaryFolder folder;
  folder.write("0.pcd",
               "VERSION .7\nFIELDS x y z time\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
               "WIDTH 6\nHEIGHT 1\nPOINTS 6\nDATA ascii\n"
               "nan nan nan 0\n0 0 0 0.01\n1 2 3 0.02\nnan nan nan 0.05\n4 5 6 0.09\n"
               "nan 1 2 0.1\n");
  const ScanItem item = read_all(folder.path())[0];
  ASSERT_EQ(item.scan->points.size(), 3U);
  EXPECT_EQ(item.dropped_points, 0U);
  EXPECT_EQ(item.dropped_not_finite, 2U);
  EXPECT_EQ(item.dropped_zero, 1U);
  const RecordingSummary summary = summarise(*open_recording(folder.path()));
  EXPECT_EQ(summary.points.median, 6.0);
  for (const Oddity& oddity : summary.oddities) {
    EXPECT_EQ(oddity.what.find("usable time"), std::string::npos) << oddity.what;
    EXPECT_TRUE(oddity.what != "scans with points that are NaN or infinite" ||
                oddity.first == "0.pcd: 3");
  }
}

// As drivers leave them that overwrite what they still fill.
TEST(FolderRecording, AFewStrayTimesDoNotMoveTheScan) {
  const TemporaryFolder folder;
  std::vector<float> times(1000);
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = i % 30 == 0 ? 1.7F : 0.0001F * static_cast<float>(i);
  }
  folder.write("0.pcd", timed_pcd<float>(times));
  const auto items = read_all(folder.path());
  EXPECT_EQ(items[0].dropped_points, 34U);
  EXPECT_LT(items[0].scan->times_ns.back(), 100'000'000);
}

TEST(FolderRecording, TimesThatAreLeftOutNeedFitNoRule) {
  const TemporaryFolder folder;
  folder.write("0.pcd", timed_pcd<std::uint32_t>({0, 7}));
  folder.write("1.pcd", timed_pcd<float>({0.0F, 5000.0F}));
  folder.write("times.txt", "10.0\n10.1\n");
  OpenOptions options;
  options.time_direction = TimeDirection::none;
  const auto items = read_all(folder.path(), options);
  ASSERT_EQ(items.size(), 2U);
  for (const ScanItem& item : items) {
    ASSERT_TRUE(item.scan) << item.error;
    EXPECT_EQ(item.scan->points.size(), 2U);
    EXPECT_TRUE(item.scan->times_ns.empty());
  }
}

TEST(FolderRecording, TimesThatAreLeftOutMayStillGiveTheStamps) {
  const TemporaryFolder folder;
  folder.write("0.pcd", timed_pcd<double>({1700000000.25, 1700000000.3125}));
  OpenOptions options;
  options.time_direction = TimeDirection::none;
  const auto items = read_all(folder.path(), options);
  EXPECT_EQ(items[0].scan->stamp_ns, 1700000000250000000);
  EXPECT_TRUE(items[0].scan->times_ns.empty());
}

TEST(FolderRecording, APointFarFromItsStampIsARejectedItem) {
  const TemporaryFolder folder;
  folder.write("0.pcd", timed_pcd<float>({0.0F, 5000.0F}));
  folder.write("1.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  const std::vector<ScanItem> items = read_all(folder.path());
  EXPECT_NE(items[0].error.find("2.1 s"), std::string::npos) << items[0].error;
  EXPECT_TRUE(items[1].scan.has_value());
}

TEST(FolderRecording, MillisecondsInCurvatureAreTimesAndCurvaturesAreNot) {
  const auto times_with = [](const char* last) {
    const TemporaryFolder folder;
    const std::string header =
        "VERSION .7\nFIELDS x y z curvature\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
        "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3 0\n4 5 6 ";
    folder.write("0.pcd", header + last + "\n");
    return open_recording(folder.path())->next()->scan->times_ns;
  };
  EXPECT_EQ(times_with("95.5"), (std::vector<std::int32_t>{0, 95'500'000}));
  EXPECT_TRUE(times_with("0.31").empty()) << "a curvature is at most a third";
}

TEST(FolderRecording, OneStrayPointTimeNeitherMovesTheScanNorRefusesTheRecording) {
  for (const char* stray : {"1.7", "-3", "1e30", "nan", "inf"}) {
    const TemporaryFolder folder;
    std::string text =
        "VERSION .7\nFIELDS x y z time\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
        "WIDTH 1000\nHEIGHT 1\nPOINTS 1000\nDATA ascii\n";
    for (int i = 0; i < 1000; ++i) {
      text += "1 2 3 " + (i == 500 ? std::string(stray) : std::to_string(1e-4 * i)) + "\n";
    }
    folder.write("0.pcd", text);
    const auto item = open_recording(folder.path())->next();
    ASSERT_TRUE(item && item->scan) << stray;
    const auto& times = item->scan->times_ns;
    ASSERT_EQ(times.size(), 999U) << stray;
    EXPECT_EQ(item->dropped_points, 1U);
    EXPECT_EQ(*std::min_element(times.begin(), times.end()), 0);
    EXPECT_NEAR(*std::max_element(times.begin(), times.end()), 99'900'000, 10);
  }
}

}  // namespace
}  // namespace surefoot::io
