// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/fingerprint.hpp"

#include "support/scratch.hpp"

namespace surefoot::experiments {
namespace {

namespace fs = std::filesystem;

using FilesMarkTest = test::Scratch;

// The offset basis, and the published algorithm by hand over the bytes 'a' and 0xFF.
TEST(Fingerprint, IsFnv1a) {
  EXPECT_EQ(Fingerprint().text(), "cbf29ce484222325");
  Fingerprint a;
  a.add("a");
  EXPECT_EQ(a.text(), "089bc907b544c769");
  Fingerprint ab_c, a_bc;
  ab_c.add("ab");
  ab_c.add("c");
  a_bc.add("a");
  a_bc.add("bc");
  EXPECT_NE(ab_c.text(), a_bc.text());
}

TEST_F(FilesMarkTest, ChangesWithNamesSizesAndTimes) {
  const fs::path file = write("in/000.pcd", "12345");
  write("in/times.txt", "0\n");
  const FilesMark before = mark_of(folder_ / "in");
  EXPECT_EQ(before.bytes, 7U);
  EXPECT_EQ(mark_of(folder_ / "in").fingerprint, before.fingerprint);

  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1));
  const FilesMark touched = mark_of(folder_ / "in");
  EXPECT_NE(touched.fingerprint, before.fingerprint);
  const auto time = fs::last_write_time(file);
  write("in/000.pcd", "123456");
  fs::last_write_time(file, time);
  const FilesMark longer = mark_of(folder_ / "in");
  EXPECT_NE(longer.fingerprint, touched.fingerprint);
  fs::rename(file, folder_ / "in/001.pcd");
  EXPECT_NE(mark_of(folder_ / "in").fingerprint, longer.fingerprint);
}

// KITTI's scans and stamps lie below the folder that is named; results beside them do not count.
TEST_F(FilesMarkTest, ChangesWithScansBelow) {
  write("in/velodyne_points/timestamps.txt", "0\n");
  write("in/velodyne_points/data/000.bin", "12345");
  const FilesMark before = mark_of(folder_ / "in");
  EXPECT_EQ(before.bytes, 7U);
  write("in/results/map.ply", "12345");
  EXPECT_EQ(mark_of(folder_ / "in").fingerprint, before.fingerprint);
  write("in/velodyne_points/data/001.bin", "12345");
  EXPECT_NE(mark_of(folder_ / "in").fingerprint, before.fingerprint);
}

// Stamps that lie above a folder of scans, and what an Ouster says of itself.
TEST_F(FilesMarkTest, ChangesWithWhatIsReadBesideARecording) {
  write("in/scans/000.pcd", "12345");
  const std::string without = mark_of(folder_ / "in/scans").fingerprint;
  write("in/times.txt", "0\n");
  EXPECT_NE(mark_of(folder_ / "in/scans").fingerprint, without);
  EXPECT_EQ(mark_of(folder_ / "in/scans").bytes, 5U);
  const fs::path capture = write("walk.pcap", "packets");
  const std::string bare = mark_of(capture).fingerprint;
  write("walk.json", "{\"beam_altitude_angles\": [1]}");
  const std::string one = mark_of(capture).fingerprint;
  EXPECT_NE(one, bare);
  write("walk.json", "{\"beam_altitude_angles\": [2]}");
  EXPECT_NE(mark_of(capture).fingerprint, one);
}

TEST_F(FilesMarkTest, OfOneFile) {
  const fs::path file = write("drive.pcap", "packets");
  EXPECT_EQ(mark_of(file).bytes, 7U);
  EXPECT_THROW((void)mark_of(folder_ / "none"), fs::filesystem_error);
}

TEST(BuildFingerprint, IsTheSameTwice) { EXPECT_EQ(build_fingerprint(), build_fingerprint()); }

}  // namespace
}  // namespace surefoot::experiments
