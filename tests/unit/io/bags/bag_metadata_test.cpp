// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/bag_metadata.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/bags/bag_files.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata =
    "rosbag2_bagfile_information:\n"
    "  version: 5\n"
    "  storage_identifier: sqlite3\n"
    "  relative_file_paths:\n"
    "    - walk_b.db3\n"
    "    - \"walk_a.db3\"\n"
    "    - ../../etc/walk_c.db3\n"
    "  compression_format: zstd\n"
    "  compression_mode: FILE\n"
    "  files:\n"
    "    - path: walk_b.db3\n";

TEST(BagMetadata, IsReadAsRosbag2WritesIt) {
  const BagMetadata metadata = parse_bag_metadata(kMetadata);
  EXPECT_EQ(metadata.storage, "sqlite3");
  EXPECT_EQ(metadata.compression_mode, "FILE");
  EXPECT_EQ(metadata.files, (std::vector<std::string>{"walk_b.db3", "walk_a.db3", "walk_c.db3"}));
  EXPECT_TRUE(parse_bag_metadata("").files.empty());
  EXPECT_TRUE(parse_bag_metadata("relative_file_paths:\n  - \n- ..\nx").files.size() <= 1);
}

TEST(BagMetadata, NamesAreThoseBeforeTheirQuotes) {
  const BagMetadata metadata = parse_bag_metadata(
      "relative_file_paths:\n"
      "  - \"a \\\"b\\\" #2.db3\"\n"
      "  - 'it''s: c.db3'\n"
      "  - d \"e\".db3\n"
      "  - \"fn\\x09\\n.db3\"\n"
      "  - \"g\\x9z.db3\"\n"
      "  - \"h\\\"\n"
      "  - 'i.db3\n"
      "  - j.db3j\n");
  EXPECT_EQ(metadata.files,
            (std::vector<std::string>{"a \"b\" #2.db3", "it's: c.db3", "d \"e\".db3", "fn\t\n.db3",
                                      "gx9z.db3", "h\\", "'i.db3", "j.db3j"}));
}

TEST(BagMetadata, KeysAreWholeWords) {
  EXPECT_EQ(parse_bag_metadata("storage_identifiers: mcap").storage, "");
  EXPECT_EQ(parse_bag_metadata(std::string_view("storage_identifier: mcap").substr(0, 18)).storage,
            "");
}

// Topics and files have counts, too.
TEST(BagMetadata, TheMessagesOfABagAreThoseFurthestToTheLeft) {
  const auto messages = [](const char* text) { return parse_bag_metadata(text).messages; };
  EXPECT_EQ(messages("  topics:\n"
                     "    - topic:\n"
                     "      message_count: 60\n"
                     "  message_count: 100\n"
                     "  files:\n"
                     "      message_count: 40\n"),
            100U);
  EXPECT_EQ(messages("  message_count: 12x\n"), std::nullopt);
  EXPECT_EQ(messages("  message_count: 99999999999999999999\n"), std::nullopt);
}

TEST(BagMetadata, NamesOfNoFilesAreNone) {
  EXPECT_EQ(parse_bag_metadata("relative_file_paths:\n  - \"\"\n  - folder/\n  - a.db3\n").files,
            (std::vector<std::string>{"a.db3"}));
  std::string many = "relative_file_paths:\n";
  for (int i = 0; i <= 100'000; ++i) many += "- a\n";
  EXPECT_EQ(parse_bag_metadata(many).files.size(), 100'000U);
}

TEST(BagMetadata, GivesThePartsTheirOrder) {
  const test::TemporaryFolder scratch;
  for (const char* name : {"walk_a.db3", "walk_b.db3.zstd", "walk_c.db3", "other.db3"}) {
    scratch.write(name, "");
  }
  scratch.write("metadata.yaml", kMetadata);
  std::vector<std::string> names;
  for (const fs::path& file : bag_files(scratch.path())) names.push_back(file.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"walk_b.db3.zstd", "walk_a.db3", "walk_c.db3"}));
}

// A bag that was copied without one of its parts, or whose metadata is another's.
TEST(BagMetadata, ThatNamesWhatIsNotThereIsPassedOver) {
  const test::TemporaryFolder scratch;
  for (const char* name : {"walk_a.db3", "walk_b.db3"}) scratch.write(name, "");
  scratch.write("metadata.yaml", kMetadata);
  ASSERT_EQ(bag_files(scratch.path()).size(), 2U);
  EXPECT_EQ(bag_files(scratch.path()).front().filename(), "walk_a.db3");
}

}  // namespace
}  // namespace surefoot::io
