// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "io/recording.hpp"
#include "io/recording_summary.hpp"
#include "io/scan_sink.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::little;
using test::TemporaryFolder;

// A PCD of points (i + 1, 0, 0) with times of type T, in the order given.
template <typename T>
std::string timed_pcd(const std::vector<T>& times, const char* name = "time") {
  const std::string n = std::to_string(times.size());
  std::string file = std::string("VERSION 0.7\nFIELDS x y z ") + name + "\nSIZE 4 4 4 " +
                     std::to_string(sizeof(T)) + "\nTYPE F F F " +
                     (std::is_floating_point_v<T> ? "F" : "U") + "\nWIDTH " + n + "\nDATA binary\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    file += little(float(i + 1)) + little(0.0F) + little(0.0F) + little(times[i]);
  }
  return file;
}

std::string kitti_scan(std::size_t points) {
  std::string file;
  for (std::size_t i = 0; i < points; ++i) {
    file += little(float(i + 1)) + little(1.0F) + little(2.0F) + little(0.5F);
  }
  return file;
}

std::vector<ScanItem> read_all(const std::filesystem::path& path, const OpenOptions& options = {}) {
  std::vector<ScanItem> items;
  const auto recording = open_recording(path, options);
  while (auto item = recording->next()) {
    items.push_back(std::move(*item));
  }
  EXPECT_EQ(recording->progress(), 1.0);
  return items;
}

std::string error_of(const std::filesystem::path& path, const OpenOptions& options = {}) {
  return test::message_of<ReadError>([&] { (void)open_recording(path, options); });
}

TEST(FolderRecording, NaturalOrderStampsAndTimes) {
  const TemporaryFolder folder;
  folder.write("scan10.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("scan9.pcd", timed_pcd<float>({0.0F, 0.03125F}));
  folder.write("times.txt", "1630577758.569489956\n1630577758.669489957\n");
  folder.write("notes.md", "not a scan");
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].name, "scan9.pcd");
  EXPECT_EQ(items[0].scan->stamp_ns, 1630577758569489956);
  EXPECT_EQ(items[1].scan->stamp_ns, 1630577758669489957);
  EXPECT_EQ(items[0].scan->times_ns, (std::vector<std::int32_t>{0, 31'250'000}));
  EXPECT_EQ(items[1].scan->times_ns, (std::vector<std::int32_t>{0, 62'500'000}));
}

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

TEST(FolderRecording, ABadFileDoesNotEndTheReading) {
  const TemporaryFolder folder;
  for (int i = 0; i < 7; ++i) {
    folder.write(std::to_string(i) + ".pcd", timed_pcd<float>({0.0F, 0.0625F}));
  }
  folder.write("3.pcd", "garbage");
  folder.write("6.pcd", "");
  folder.write("0.pcd", "FIELDS a b c\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nDATA binary\n");
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), 7U);
  for (const std::size_t bad : {0U, 3U, 6U}) {
    EXPECT_FALSE(items[bad].scan);
    EXPECT_NE(items[bad].error.find(std::to_string(bad) + ".pcd: "), std::string::npos);
  }
  EXPECT_EQ(items[5].scan->stamp_ns, 500'000'000);  // the tenth of a second assumed
}

TEST(FolderRecording, KittiFoldersAndDates) {
  const TemporaryFolder folder;
  folder.write("drive/velodyne_points/data/0000000000.bin", kitti_scan(3));
  folder.write("drive/velodyne_points/data/0000000001.bin", kitti_scan(2));
  folder.write("drive/velodyne_points/timestamps.txt",
               "2011-09-26 14:30:14.950485851\n2011-09-26 14:30:15.054041005\n");
  for (const char* below : {"drive", "drive/velodyne_points", "drive/velodyne_points/data"}) {
    if (std::string(below) == "drive/velodyne_points") {
      EXPECT_NE(error_of(folder.path() / below), "");  // neither scans nor KITTI's root
      continue;
    }
    const std::vector<ScanItem> items = read_all(folder.path() / below);
    ASSERT_EQ(items.size(), 2U);
    EXPECT_EQ(items[0].scan->stamp_ns, 1317047414950485851);
    EXPECT_EQ(items[0].scan->points.size(), 3U);
    EXPECT_TRUE(items[0].scan->times_ns.empty());
    EXPECT_EQ(items[0].scan->intensities[0], 0.5F);
  }
}

TEST(FolderRecording, KittiCorrectionTurnsUpByItsAngle) {
  const TemporaryFolder folder;
  folder.write("0.bin", little(10.0F) + little(0.0F) + little(0.0F) + little(0.0F));
  OpenOptions options;
  options.kitti_hdl64_correction = true;
  const Scan scan = *read_all(folder.path(), options)[0].scan;
  EXPECT_NEAR(std::atan2(scan.points[0].z(), scan.points[0].x()), 0.205 * M_PI / 180.0, 1e-7);
  EXPECT_NEAR(scan.points[0].norm(), 10.0, 1e-5);
}

TEST(FolderRecording, KittiSizeMustFit) {
  const TemporaryFolder folder;
  folder.write("0.bin", kitti_scan(2) + "x");
  const ScanItem item = read_all(folder.path())[0];
  EXPECT_NE(item.error.find("33 bytes; expected a multiple of 16"), std::string::npos);
}

TEST(FolderRecording, WrongStampsFiles) {
  const TemporaryFolder folder;
  folder.write("0.bin", kitti_scan(1));
  folder.write("times.txt", "0\n1\n2\n");
  const std::string counts = error_of(folder.path());
  EXPECT_NE(counts.find("3 stamps for the 1 scans"), std::string::npos) << counts;
  folder.write("times.txt", "zero\n");
  EXPECT_NE(error_of(folder.path()).find("times.txt: line 1"), std::string::npos);
  OpenOptions options;
  options.stamps_file = folder.write("other", "7.5\n");
  EXPECT_EQ(read_all(folder.path(), options)[0].scan->stamp_ns, 7'500'000'000);
  options.stamps_file = folder.path() / "missing";
  EXPECT_NE(error_of(folder.path(), options).find("missing"), std::string::npos);
}

TEST(FolderRecording, RateAndAssumption) {
  const TemporaryFolder folder;
  folder.write("0.bin", kitti_scan(1));
  folder.write("1.bin", kitti_scan(1));
  const auto assumed = open_recording(folder.path());
  EXPECT_EQ(assumed->notes().back(), "stamps: none found, 10 scans a second assumed");
  OpenOptions options;
  options.rate_hz = 20.0;
  EXPECT_EQ(read_all(folder.path(), options)[1].scan->stamp_ns, 50'000'000);
}

TEST(FolderRecording, SkipAndSize) {
  const TemporaryFolder folder;
  for (int i = 0; i < 5; ++i) {
    folder.write(std::to_string(i) + ".bin", kitti_scan(std::size_t(i)));
  }
  const auto recording = open_recording(folder.path());
  EXPECT_EQ(recording->size(), 5U);
  recording->skip(3);
  EXPECT_EQ(recording->next()->name, "3.bin");
  recording->skip(1000);
  EXPECT_FALSE(recording->next());
}

TEST(OpenRecording, SaysWhatWasSeenAndExpected) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of(folder.path()).find("0 PCD"), std::string::npos);
  EXPECT_NE(error_of(folder.path() / "none").find("no such file"), std::string::npos);
  EXPECT_NE(error_of(folder.write("a.txt", "x")).find("'.txt'; expected"), std::string::npos);
  folder.write("mixed/a.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("mixed/b.ply", "ply\n");
  const std::string mixed = error_of(folder.path() / "mixed");
  EXPECT_NE(mixed.find("1 PCD, 1 PLY"), std::string::npos) << mixed;
  OpenOptions options;
  options.format = "pcd";
  EXPECT_EQ(read_all(folder.path() / "mixed", options).size(), 1U);
  options.format = "bin";
  EXPECT_NE(error_of(folder.path() / "mixed", options).find("bin is asked for"), std::string::npos);
  options.format = "xyz";
  EXPECT_NE(error_of(folder.path() / "mixed", options).find("expected pcd, ply, bin or las"),
            std::string::npos);
}

// A link that leads nowhere, a pipe and a folder keep their places: the others their stamps.
TEST(OpenRecording, WhatIsNamedAsAScanAndIsNoFileIsAScanThatCannotBeRead) {
  const TemporaryFolder folder;
  folder.write("a.bin", kitti_scan(1));
  folder.write("d.bin", kitti_scan(2));
  std::filesystem::create_symlink("nowhere", folder.path() / "b.bin");
  std::filesystem::create_directory(folder.path() / "c.bin");
  folder.write("times.txt", "1\n2\n3\n4\n");
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), 4U);
  EXPECT_NE(items[1].error.find("b.bin"), std::string::npos) << items[1].error;
  EXPECT_NE(items[2].error.find("c.bin"), std::string::npos) << items[2].error;
  ASSERT_TRUE(items[3].scan.has_value());
  EXPECT_EQ(items[3].scan->stamp_ns, 4'000'000'000);
}

std::string notes_of(const std::filesystem::path& path, const OpenOptions& options = {}) {
  std::string text;
  const auto recording = open_recording(path, options);
  for (const std::string& note : recording->notes()) text += note + '\n';
  return text;
}

TEST(OpenRecording, OptionsThatSayNothingAboutItAreNoted) {
  const TemporaryFolder folder;
  folder.write("a.bin", kitti_scan(1));
  OpenOptions options;
  options.topic = "/x";
  options.calibration_file = "/nope";
  const std::string notes = notes_of(folder.path(), options);
  EXPECT_NE(notes.find("--topic counts for nothing here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("--calibration counts for nothing here"), std::string::npos) << notes;
  EXPECT_EQ(notes_of(folder.path()).find("counts for nothing"), std::string::npos);
}

TEST(OpenRecording, WhatLiesBesideIsNoted) {
  const TemporaryFolder folder;
  folder.write("in/a.bin", kitti_scan(1));
  const auto sink = make_scan_sink(folder.path() / "in" / "b.mcap", ScanFormat::mcap);
  sink->add(*read_all(folder.path() / "in").front().scan);
  sink->finish();
  const std::string scans = notes_of(folder.path() / "in");
  EXPECT_NE(scans.find("not read: 1 bag in the same folder"), std::string::npos) << scans;
  // A folder that rosbag2 made is its bag.
  folder.write("in/metadata.yaml", "rosbag2_bagfile_information:\n");
  EXPECT_NE(open_recording(folder.path() / "in")->description().find("MCAP"), std::string::npos);
  const std::string bag = notes_of(folder.path() / "in");
  EXPECT_NE(bag.find("not read: 1 scan file in the same folder"), std::string::npos) << bag;
  std::filesystem::create_directory(folder.path() / "two");
  for (const char* name : {"x.mcap", "y.mcap"}) {
    std::filesystem::copy_file(folder.path() / "in" / "b.mcap", folder.path() / "two" / name);
  }
  const std::string parts = notes_of(folder.path() / "two");
  EXPECT_NE(parts.find("2 bags are read as parts of one recording, x.mcap first"),
            std::string::npos)
      << parts;
}

TEST(Summary, SaysWhatIsOdd) {
  const TemporaryFolder folder;
  folder.write("0.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("1.pcd", timed_pcd<float>({0.0F, NAN, 0.0625F}));
  folder.write("2.pcd", "garbage");
  folder.write("3.pcd", timed_pcd<float>({0.0F, 0.0625F}));
  folder.write("4.pcd", timed_pcd<float>({0.0F, 0.001F}));
  folder.write("times.txt", "10\n10\n10.2\n9\n9.1\n");
  OpenOptions as_it_is;
  as_it_is.repair_stamps = false;
  const RecordingSummary summary = summarise(*open_recording(folder.path(), as_it_is));
  EXPECT_EQ(summary.scans, 4U);
  EXPECT_EQ(summary.unreadable, 1U);
  EXPECT_EQ(summary.points.greatest, 2.0);
  EXPECT_EQ(summary.range_m.least, 1.0);
  EXPECT_EQ(summary.range_m.greatest, 3.0);
  std::string oddities;
  for (const Oddity& oddity : summary.oddities) {
    oddities += oddity.what + " x" + std::to_string(oddity.scans) + "; ";
  }
  for (const char* what : {"unreadable x1", "dropped x1", "equal to the one before x1",
                           "stamp before the one before x1", "shorter than 0.01 s x1"}) {
    EXPECT_NE(oddities.find(what), std::string::npos) << what << " not in " << oddities;
  }
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
