// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is named like a file of data and is none: refused at once, by what it is.
#include "io/file_reader.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/recording.hpp"
#include "io/trajectory_files.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

std::filesystem::path make_pipe(const std::filesystem::path& path) {
  EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
  return path;
}

std::string refusal_of(const std::filesystem::path& file) {
  std::vector<std::byte> bytes;
  return test::message_of<ReadError>([&] { read_whole_file(file, bytes); });
}

// The reading of a pipe would wait for a writer, and the test with it.
TEST(ReadWholeFile, SaysWhatIsNoRegularFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(refusal_of(folder.path()), "it is a folder; expected a regular file");
  EXPECT_EQ(refusal_of(make_pipe(folder.path() / "a.pcd")),
            "it is a named pipe; expected a regular file");
  EXPECT_EQ(refusal_of("/dev/zero"), "it is a device; expected a regular file");
  EXPECT_EQ(refusal_of(folder.path() / "none.pcd"), "cannot read it: No such file or directory");
}

TEST(ReadWholeFile, FollowsLinks) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.pcd", "four");
  std::filesystem::create_symlink(file, folder.path() / "link.pcd");
  std::vector<std::byte> bytes;
  read_whole_file(folder.path() / "link.pcd", bytes);
  EXPECT_EQ(bytes.size(), 4U);
  std::filesystem::create_symlink(make_pipe(folder.path() / "pipe"), folder.path() / "to_pipe.pcd");
  EXPECT_NE(refusal_of(folder.path() / "to_pipe.pcd").find("named pipe"), std::string::npos);
}

TEST(NamedPipe, IsRefusedByEveryReader) {
  const test::TemporaryFolder folder;
  const auto scan = make_pipe(folder.path() / "scan.pcd");
  const auto recording = open_recording(scan);
  const auto item = recording->next();
  ASSERT_TRUE(item);
  EXPECT_FALSE(item->scan);
  EXPECT_NE(item->error.find("scan.pcd: it is a named pipe"), std::string::npos) << item->error;

  const auto path = make_pipe(folder.path() / "path.txt");
  for (const std::string& message :
       {test::message_of<ReadError>([&] { (void)read_tum(path); }),
        test::message_of<ReadError>([&] { (void)read_tum_thinned(path, 1); }),
        test::message_of<ReadError>([&] { (void)read_kitti_poses(path); })}) {
    EXPECT_NE(message.find("path.txt: it is a named pipe"), std::string::npos) << message;
  }
}

TEST(NamedPipe, AmongScansIsOneThatCannotBeRead) {
  const test::TemporaryFolder folder;
  folder.write("0.bin", std::string(160, '\0'));
  make_pipe(folder.path() / "1.bin");
  const auto recording = open_recording(folder.path());
  EXPECT_EQ(recording->size(), 2U);
  int unreadable = 0;
  while (const auto item = recording->next()) unreadable += item->error.empty() ? 0 : 1;
  EXPECT_EQ(unreadable, 1);
}

}  // namespace
}  // namespace surefoot::io
