// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/output_folder.hpp"

#include "runs/run_files.hpp"
#include "runs/scans_csv.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public test::Scratch {
 protected:
  OutputFolderTest() { write("in/000000.pcd", ""); }

  void expect_refused(const std::string& folder, const std::string& named,
                      bool overwrite = false) const {
    try {
      const OutputFolder taken(folder_ / folder, folder_ / "in", overwrite);
      ADD_FAILURE() << "taken: " << folder;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(folder), std::string::npos) << error.what();
    }
  }
};

TEST_F(OutputFolderTest, AnEarlierRunsFilesGoAndOthersStay) {
  for (const char* name : kRunFiles) write(std::string("out/") + name, scans_csv_header());
  const std::string numbered[] = {kSegmentFiles + std::string("1.tum"),
                                  kMapFrameFiles + std::string("1.tum")};
  for (const std::string& name : numbered) write("out/" + name, "");
  fs::remove(folder_ / "out" / kSavedMapFile);
  fs::remove(folder_ / "out" / kApartMapFile);
  const auto thesis = write("out/thesis.tex", "years of work");
  OutputFolder folder(folder_ / "out", folder_ / "in", false);
  for (const char* name : kRunFiles) {
    const bool map = name == std::string(kSavedMapFile) || name == std::string(kApartMapFile);
    EXPECT_EQ(fs::exists(folder.path() / name), !map) << name;
  }
  folder.clear();
  EXPECT_TRUE(folder.replaced());
  for (const char* name : kRunFiles) EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
  for (const std::string& name : numbered) EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
  EXPECT_TRUE(fs::exists(thesis));
}

TEST_F(OutputFolderTest, WhatOnlyBeginsLikeARunsNumberedFilesStays) {
  write("out/scans.csv", scans_csv_header());
  const fs::path others[] = {write("out/trajectory_map_of_campus.png", "mine"),
                             write("out/trajectory_segment_.tum", "mine"),
                             write("out/trajectory_segment_1b.tum", "mine"),
                             write("out/trajectory_segment_2.tum/mine.txt", "mine")};
  OutputFolder folder(folder_ / "out", folder_ / "in", false);
  folder.clear();
  EXPECT_TRUE(folder.replaced());
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
}

TEST_F(OutputFolderTest, AMapToComeBackToIsNotLost) {
  write("out/scans.csv", scans_csv_header());
  for (const char* name : {kSavedMapFile, kApartMapFile}) {
    const auto map = write(std::string("out/") + name, "days of work");
    expect_refused("out", name);
    EXPECT_TRUE(fs::exists(map));
    EXPECT_TRUE(fs::exists(folder_ / "out/scans.csv"));
    fs::remove(map);
  }
  write(std::string("out/") + kSavedMapFile, "old");
  OutputFolder taken(folder_ / "out", folder_ / "in", true);
  taken.clear();
  EXPECT_FALSE(fs::exists(taken.path() / kSavedMapFile));
}

TEST_F(OutputFolderTest, AMapThatIsReadStaysWhereTheRestIsOverwritten) {
  for (const bool found_in : {false, true}) {
    write("out/scans.csv", scans_csv_header());
    const auto map = write(std::string("out/") + kSavedMapFile, "days of work");
    OutputFolder taken(folder_ / "out", folder_ / "in", true, found_in ? fs::path{} : map,
                       found_in ? map : fs::path{});
    taken.clear();
    EXPECT_TRUE(fs::exists(map)) << found_in;
    EXPECT_FALSE(fs::exists(folder_ / "out/scans.csv"));
  }
}

TEST_F(OutputFolderTest, WhatNoRunHasLeftIsRefused) {
  for (const char* name : {"trajectory.tum", "map.ply", "scans.csv", "000000.pcd", "cloud.ply",
                           "trajectory_segment_1.tum", "trajectory_map_12.tum"}) {
    const auto foreign = write("other/" + std::string(name), "mine");
    expect_refused("other", name);
    EXPECT_TRUE(fs::exists(foreign));
    const OutputFolder taken(folder_ / "other", folder_ / "in", true);
    fs::remove_all(folder_ / "other");
  }
}

TEST_F(OutputFolderTest, ARecordingIsNeverTheOutput) {
  expect_refused("in", "recording");
  expect_refused("in", "recording", true);
  fs::create_directory_symlink(folder_ / "in", folder_ / "link");
  expect_refused("link", "recording", true);
  const auto capture = write("captures/walk.pcap", "");
  EXPECT_THROW(OutputFolder(folder_ / "captures", capture, true), std::runtime_error);
}

// A live run's input has a name alone, as if it lay in the folder that one is in.
TEST_F(OutputFolderTest, WhatIsHeardLiesNowhere) {
  fs::create_directory(folder_ / "out");
  const OutputFolder taken(folder_ / "out", folder_ / "out/udp-2368", false);
  EXPECT_TRUE(fs::equivalent(taken.path(), folder_ / "out"));
}

TEST_F(OutputFolderTest, OneRunAtATime) {
  OutputFolder first(folder_ / "out", folder_ / "in", false);
  first.clear();
  EXPECT_FALSE(first.replaced());
  expect_refused("out", "another process", true);
}

/// Runs without -o, in a folder of its own.
class Latest : public OutputFolderTest {
 protected:
  Latest() : before_(fs::current_path()) { fs::current_path(folder_); }
  ~Latest() override { fs::current_path(before_); }

 private:
  fs::path before_;
};

TEST_F(Latest, PointsToTheLastRun) {
  for (int i = 0; i < 2; ++i) {
    const OutputFolder folder({}, "in", false);
    EXPECT_TRUE(fs::is_symlink("results/latest"));
    EXPECT_TRUE(fs::equivalent("results/latest", folder.path()));
  }
}

TEST_F(Latest, MapContinuesTheOneItPointedTo) {
  const fs::path first = OutputFolder({}, "in", false).path();
  write((first / kSavedMapFile).string(), "a map");
  const fs::path map = fs::path("results") / "latest" / kSavedMapFile;
  OutputFolder second({}, "in", false, map);
  second.clear();
  EXPECT_FALSE(fs::equivalent(first, second.path()));
  EXPECT_TRUE(fs::exists(first / kSavedMapFile));
}

TEST_F(Latest, WhatSomebodyElsePutThereStays) {
  write("results/latest", "mine");
  (void)OutputFolder({}, "in", false);
  EXPECT_TRUE(fs::is_regular_file("results/latest"));
  fs::remove("results/latest");
  fs::create_directory("results/latest");
  (void)OutputFolder({}, "in", false);
  EXPECT_FALSE(fs::is_symlink("results/latest"));
  fs::remove("results/latest");
  fs::create_directory_symlink("../in", "results/latest");
  (void)OutputFolder({}, "in", false);
  EXPECT_EQ(fs::read_symlink("results/latest"), "../in");
}

}  // namespace
}  // namespace surefoot::runs
