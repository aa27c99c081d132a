// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "io/files/kitti_bin.hpp"
#include "io/recording.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

using test::error_of;
using test::kitti_scan;
using test::little;
using test::read_all;
using test::TemporaryFolder;
using test::timed_pcd;

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

// Natural order takes the fractions for whole numbers.
TEST(FolderRecording, NamesInUnpaddedDecimalSecondsAreInTheOrderOfTime) {
  const std::vector<std::string> names = {"1644823589.112345.pcd", "1644823589.21234.pcd",
                                          "1644823589.3.pcd", "1644823589.40001.pcd"};
  const TemporaryFolder folder;
  for (const std::string& name : names) folder.write(name, timed_pcd<float>({0.0F, 0.0625F}));
  const std::vector<ScanItem> items = read_all(folder.path());
  ASSERT_EQ(items.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(items[i].name, names[i]);
  EXPECT_EQ(items[1].scan->stamp_ns, 1644823589212340000);
}

// Of f"{sec}.{nanosec}", without leading zeros.
TEST(FolderRecording, NamesInSecondsAndUnpaddedNanosecondsAreInTheOrderOfTime) {
  const TemporaryFolder folder;
  const auto stamp = [](std::int64_t i) { return 1'600'000'000'020'000'001 + i * 100'000'000; };
  for (int i = 0; i < 20; ++i) {
    const std::string name = std::to_string(stamp(i) / 1'000'000'000) + '.' +
                             std::to_string(stamp(i) % 1'000'000'000) + ".pcd";
    folder.write(name, timed_pcd<float>({0.0F, 0.0625F}));
  }
  const auto recording = open_recording(folder.path(), {});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(recording->next()->scan->stamp_ns, stamp(i));
  EXPECT_NE(test::joined(recording->notes()).find("nanoseconds without leading zeros"),
            std::string::npos);
}

TEST(FolderRecording, WhatWholeStampsCountIsSaid) {
  const TemporaryFolder folder;
  for (const char* name : {"0.pcd", "1.pcd"}) {
    folder.write(name, timed_pcd<float>({0.0F, 0.0625F}));
  }
  folder.write("times.txt", "1630577758569\n1630577758669\n");
  const auto recording = open_recording(folder.path(), {});
  EXPECT_EQ(recording->next()->scan->stamp_ns, 1630577758569000000);
  EXPECT_EQ(recording->notes().front(), "stamps: from times.txt, in milliseconds");
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
  EXPECT_NE(item.error.find("33 bytes, no multiple of 16"), std::string::npos) << item.error;
}

/// Rows of float32.
std::string rows(std::size_t count, const std::function<std::vector<float>(std::size_t)>& row) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    for (const float value : row(i)) bytes += little(value);
  }
  return bytes;
}

// nuScenes' points have a fifth number, the laser's; others' are not KITTI's either.
TEST(FolderRecording, BinFilesOfOtherWidthsAreToldByTheirValues) {
  const TemporaryFolder folder;
  const auto angle = [](std::size_t i) { return 0.37F * static_cast<float>(i); };
  folder.write("0.bin", rows(40, [&](std::size_t i) {
                 const float ring = static_cast<float>(i % 32);
                 return std::vector{5.0F * std::cos(angle(i)), 5.0F * std::sin(angle(i)),
                                    0.1F * ring - 1.7F, 20.0F, ring};
               }));
  const ScanItem item = read_all(folder.path())[0];
  ASSERT_TRUE(item.scan) << item.error;
  ASSERT_EQ(item.scan->points.size(), 40U);
  EXPECT_NEAR(item.scan->points[33].x(), 5.0F * std::cos(angle(33)), 1e-6);
  EXPECT_EQ(item.scan->rings[33], 1U);
  // Six: x y z red green blue.
  const TemporaryFolder coloured;
  coloured.write("0.bin", rows(40, [&](std::size_t i) {
                   return std::vector{-5.0F * std::cos(angle(i)), -5.0F, -0.3F, 0.1F, 0.2F, 0.3F};
                 }));
  const ScanItem other = read_all(coloured.path())[0];
  EXPECT_NE(other.error.find("are below zero; expected float32"), std::string::npos) << other.error;

  // NCLT's: uint16 x y z of 5 mm from -100 m on, uint8 intensity, uint8 laser.
  std::string nclt;
  for (int i = 0; i < 101; ++i) {
    const auto add = [&](int value) { nclt += {char(value & 0xFF), char(value >> 8)}; };
    add(20'000 + 37 * i);
    add(20'000 - 41 * i);
    add(19'000 + i);
    nclt += {char(i), char(i % 32)};
  }
  const TemporaryFolder michigan;
  michigan.write("0.bin", nclt);
  const std::string error = read_all(michigan.path())[0].error;
  EXPECT_NE(error.find("NCLT"), std::string::npos) << error;
}

std::string format_of(const std::string& bytes) {
  return parse_kitti_bin(test::bytes_of(bytes)).format;
}

// Of four points, which would be five of KITTI's, only one has an odd fifth number.
TEST(KittiBin, ALasersNumberIsAWholeOneOfAByte) {
  const auto with_ring = [](float ring) {
    return rows(4, [&](std::size_t i) {
      return std::vector{1.0F, 2.0F, 3.0F, 4.0F, i == 0 ? ring : 7.0F};
    });
  };
  for (const float ring : {0.0F, 255.0F}) EXPECT_EQ(format_of(with_ring(ring)), "nuScenes .bin");
  for (const float odd : {-1.0F, 256.0F, 0.5F, std::nanf("")}) {
    EXPECT_EQ(format_of(with_ring(odd)), "KITTI .bin") << odd;
  }
  EXPECT_EQ(format_of(""), "KITTI .bin");
}

TEST(KittiBin, ZerosAreNoIntegersAndFewIntensitiesAreBelowZero) {
  const auto zeros = [](std::size_t) { return std::vector{1.5F, 0.0F, 2.5F, 0.0F}; };
  EXPECT_EQ(format_of(rows(3, zeros)), "KITTI .bin");
  const auto some = [](std::size_t count, std::size_t below) {
    return rows(count, [below](std::size_t i) {
      return std::vector{1.5F, 1.0F, 2.5F, i < below ? -0.5F : 0.5F};
    });
  };
  EXPECT_EQ(format_of(some(101, 2)), "KITTI .bin");
  EXPECT_THROW((void)format_of(some(101, 3)), ReadError);
}

TEST(KittiBin, APointStraightAboveIsLeftAsItIs) {
  std::vector<Eigen::Vector3f> points = {{0.0F, 0.0F, 2.0F}};
  correct_kitti_hdl64(points);
  EXPECT_EQ(points[0], Eigen::Vector3f(0.0F, 0.0F, 2.0F));
}

// As of a KITTI drive of which some scans are not here.
TEST(FolderRecording, StampsOfAllFramesGoByTheFilesNumbers) {
  const TemporaryFolder folder;
  folder.write("0000000001.bin", kitti_scan(1));
  folder.write("0000000003.bin", kitti_scan(1));
  folder.write("times.txt", "0\n1\n2\n3\n");
  const auto items = read_all(folder.path());
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].scan->stamp_ns, 1'000'000'000);
  EXPECT_EQ(items[1].scan->stamp_ns, 3'000'000'000);
  folder.write("0000000004.bin", kitti_scan(1));
  EXPECT_NE(error_of(folder.path()).find("4 stamps for the 3 scans"), std::string::npos);
}

TEST(FolderRecording, WrongStampsFiles) {
  const TemporaryFolder folder;
  folder.write("7.bin", kitti_scan(1));
  folder.write("times.txt", "0\n1\n2\n");
  const std::string counts = error_of(folder.path());
  EXPECT_NE(counts.find("3 stamps for the 1 scans"), std::string::npos) << counts;
  folder.write("times.txt", "zero\n");
  EXPECT_NE(error_of(folder.path()).find("times.txt: line 1"), std::string::npos);
  folder.write("times.txt", "5000000000.0\n");
  const std::string late = error_of(folder.path());
  EXPECT_NE(late.find("line 1: '5000000000.0' is no instant from 1834 to 2106"), std::string::npos)
      << late;
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
  folder.write("times.txt", "0.0\n0.1\n");
  EXPECT_EQ(open_recording(folder.path(), options)->notes().back(),
            "stamps: not from the rate that was given, which only helps to mend them");
  EXPECT_EQ(read_all(folder.path(), options)[1].scan->stamp_ns, 100'000'000);
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

}  // namespace
}  // namespace surefoot::io
