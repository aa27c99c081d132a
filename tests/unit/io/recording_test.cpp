// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/file_kind.hpp"
#include "io/files/scan_files.hpp"
#include "io/recording.hpp"
#include "io/scan_sink.hpp"
#include "unit/io/scan_folders.hpp"

namespace surefoot::io {
namespace {

using test::error_of;
using test::kitti_scan;
using test::read_all;
using test::TemporaryFolder;
using test::timed_pcd;

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

TEST(OpenRecording, WhatGitLfsLeavesIsNamed) {
  const test::TemporaryFolder folder;
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 123456\n";
  for (const char* name : {"a.bag", "a.mcap", "a.db3", "a.pcap", "a.pcd", "a.bin"}) {
    try {
      (void)open_recording(folder.write(name, pointer));
      ADD_FAILURE() << name;
    } catch (const ReadError& error) {
      EXPECT_NE(std::string(error.what()).find("git lfs pull"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)parse_scan_file(ScanFileKind::kitti_bin, test::bytes_of(pointer)), ReadError);
}

TEST(OpenRecording, ABagOfMetadataAloneIsNamed) {
  const test::TemporaryFolder folder;
  const std::string head = "rosbag2_bagfile_information:\n  relative_file_paths:\n    - a_0.mcap\n";
  folder.write("one/metadata.yaml", head);
  folder.write("two/metadata.yaml", head + "    - a_1.mcap\n");
  const auto why = [&](const char* name) {
    return test::message_of<ReadError>([&] { (void)open_recording(folder.path() / name); });
  };
  EXPECT_NE(why("one").find("metadata.yaml names a_0.mcap, which is not there"), std::string::npos)
      << why("one");
  EXPECT_NE(why("two").find("a_0.mcap and 1 more, which are not there"), std::string::npos)
      << why("two");
}

TEST(OpenRecording, ContentGoesBeforeTheExtension) {
  const TemporaryFolder folder;
  const std::string pcd = timed_pcd<float>({0.0F, 0.0625F});
  for (const char* name : {"a.txt", "a.ply", "a.bag", "scan"}) {
    const auto recording = open_recording(folder.write(name, pcd));
    const auto item = recording->next();
    EXPECT_TRUE(item && item->scan) << name;
  }
  EXPECT_EQ(kind_of(folder.write("walk.cap", "\xd4\xc3\xb2\xa1")), FileKind::capture);
  EXPECT_EQ(kind_of(folder.write("a.mcap", "no mcap")), FileKind::mcap);  // its reader says so
  EXPECT_EQ(kind_of(folder.write("a.bin", "ply")), FileKind::kitti_bin);
  EXPECT_EQ(kind_by_name("a.pcd.zst"), std::nullopt);
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

TEST(OpenRecording, ScansThatLieDeeperAndARunsParametersAreNamed) {
  const test::TemporaryFolder folder;
  folder.write("drive/lidar/top/1.pcd", "");
  const std::string deeper =
      test::message_of<ReadError>([&] { (void)open_recording(folder.path() / "drive"); });
  EXPECT_NE(deeper.find("there are some in lidar/top"), std::string::npos) << deeper;
  const auto file = folder.write("results/out/run.yaml", "surefoot: 0.1.0\n");
  folder.write("results/out/map.ply", "");
  const std::string runs =
      test::message_of<ReadError>([&] { (void)open_recording(folder.path() / "results"); });
  EXPECT_EQ(runs.find("there are some in"), std::string::npos) << runs;
  const std::string yaml = test::message_of<ReadError>([&] { (void)open_recording(file); });
  EXPECT_NE(yaml.find("--config"), std::string::npos) << yaml;
}

TEST(OpenRecording, OptionsThatSayNothingAboutItAreNoted) {
  const TemporaryFolder folder;
  folder.write("a.bin", kitti_scan(1));
  OpenOptions options;
  options.topic = "/x";
  options.calibration_file = "/nope";
  options.dual_return = ReturnChoice::last;
  options.cut_azimuth_deg = 90.0;
  options.spin = Spin::counterclockwise;
  const std::string notes = notes_of(folder.path(), options);
  EXPECT_NE(notes.find("--topic counts for nothing here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("--calibration counts for nothing here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("--return counts for nothing here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("--cut counts for nothing here"), std::string::npos) << notes;
  EXPECT_NE(notes.find("--spin counts for nothing here"), std::string::npos) << notes;
  options.derive_times = DeriveTimes::azimuth;
  const std::string derived = notes_of(folder.path(), options);
  EXPECT_EQ(derived.find("--cut counts for nothing here"), std::string::npos) << derived;
  EXPECT_EQ(derived.find("--spin counts for nothing here"), std::string::npos) << derived;
  EXPECT_EQ(derived.find("--derive-times counts for nothing"), std::string::npos) << derived;
  EXPECT_EQ(derived.find("--time-field counts for nothing"), std::string::npos) << derived;
  options.time_direction = TimeDirection::none;
  options.time_field = "t";
  const std::string left_out = notes_of(folder.path(), options);
  EXPECT_NE(left_out.find("--derive-times counts for nothing"), std::string::npos) << left_out;
  EXPECT_NE(left_out.find("--time-field counts for nothing"), std::string::npos) << left_out;
  EXPECT_EQ(notes_of(folder.path()).find("counts for nothing"), std::string::npos);
}

TEST(OpenRecording, AFolderOpensByTheOnlyBagInAFolderBelow) {
  const TemporaryFolder folder;
  folder.write("scan.bin", kitti_scan(1));
  const auto sink = make_scan_sink(folder.path() / "in" / "bag", ScanFormat::rosbag2);
  sink->add(*read_all(folder.path() / "scan.bin").front().scan);
  sink->finish();
  folder.write("in/gt.tum", "");
  const auto opens_as_bag = [&] {
    return open_recording(folder.path() / "in")->description().find("sqlite3") != std::string::npos;
  };
  EXPECT_TRUE(opens_as_bag());
  folder.write("in/other/metadata.yaml", "rosbag2_bagfile_information:\n");
  EXPECT_THROW((void)open_recording(folder.path() / "in"), ReadError) << "which of the two?";
  std::filesystem::remove_all(folder.path() / "in/other");
  folder.write("in/velodyne/0.bin", kitti_scan(1));
  EXPECT_FALSE(opens_as_bag()) << "scans, as before there was a bag below";
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

}  // namespace
}  // namespace surefoot::io
