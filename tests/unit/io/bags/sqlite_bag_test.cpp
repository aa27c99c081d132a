// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstdlib>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/sqlite_bag_reader.hpp"
#include "io/recording.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
using test::ReadMessage;

// Tables as they were before there was a schema version, in version 3, and in version 4.
const char* const kTopics[] = {
    "topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format "
    "TEXT NOT NULL)",
    "topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format "
    "TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL DEFAULT '')",
    "topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format "
    "TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL DEFAULT '', type_description_hash TEXT NOT "
    "NULL DEFAULT '')"};

void make_bag(const fs::path& file, const char* topics, const std::vector<std::string>& blobs,
              int first_time = 0) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const auto run = [&](const std::string& command) {
    ASSERT_EQ(sqlite3_exec(database, command.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
  };
  run("CREATE TABLE " + std::string(topics));
  run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER "
      "NOT NULL, data BLOB NOT NULL)");
  run("INSERT INTO topics(id, name, type, serialization_format) VALUES (5, '/p', "
      "'sensor_msgs/msg/PointCloud2', 'cdr')");
  sqlite3_stmt* row = nullptr;
  sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES (5, ?, ?)",
                     -1, &row, nullptr);
  for (const std::string& blob : blobs) {
    sqlite3_bind_int64(row, 1, first_time++);
    sqlite3_bind_blob(row, 2, blob.data(), static_cast<int>(blob.size()), SQLITE_TRANSIENT);
    sqlite3_step(row);
    sqlite3_reset(row);
  }
  sqlite3_finalize(row);
  sqlite3_close(database);
}

ReadMessage expected_row(int i, const std::string& blob) {
  return {"/p", "sensor_msgs/PointCloud2", i, blob};
}

TEST(SqliteBag, EveryVersionOfTheTables) {
  for (const char* topics : kTopics) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "a b%20?#_0.db3";  // what a URI gives a meaning to
    make_bag(file, topics, {"one", "two"});
    const auto source = read_sqlite_bag(file);
    const auto messages = test::read_all_messages(*source);
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[1], expected_row(1, "two"));
    EXPECT_EQ(source->progress(), 1.0);
    EXPECT_TRUE(source->rewind());
    EXPECT_EQ(test::read_all_messages(*source), messages);
  }
}

TEST(SqliteBag, MessagesThatAreCompressed) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  const std::string large(100'000, 'z');
  std::string damaged = compress(Compression::zstd, large);
  damaged[6] ^= '\x7f';
  make_bag(file, kTopics[1], {compress(Compression::zstd, large), damaged, "plain"});
  const auto source = read_sqlite_bag(file);
  const auto messages = test::read_all_messages(*source);
  EXPECT_EQ(messages.front(), expected_row(0, large));
  EXPECT_EQ(messages.back(), expected_row(2, "plain"));
}

TEST(SqliteBag, FileThatIsCompressedAsAWhole) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  make_bag(file, kTopics[1], {"one", "two"});
  const fs::path compressed =
      folder.write("c/a.db3.zstd", compress(Compression::zstd, test::content_of(file)));
  EXPECT_EQ(test::read_all_messages(*open_bag(folder.path() / "c")).size(), 2U);
  EXPECT_EQ(test::read_all_messages(*open_bag(compressed)).size(), 2U);
}

// However the program ends: the file has no name from the moment that it is open.
TEST(SqliteBag, WhatItWasDecompressedIntoIsNotLeftBehind) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3", compressed = folder.path() / "a.db3.zstd";
  const std::string large(3'000'000, 'z');  // more than sqlite3 keeps of it in memory
  make_bag(file, kTopics[1], {large, "one", large, "two"});
  folder.write("a.db3.zstd", compress(Compression::zstd, test::content_of(file)));
  const fs::path place = folder.path() / "tmp";
  fs::create_directory(place);
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("TMPDIR", place.c_str(), 1);
  const auto source = read_sqlite_bag(compressed);
  before == nullptr ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1);
  EXPECT_TRUE(fs::is_empty(place));
  const auto messages = test::read_all_messages(*source);
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages[2], expected_row(2, large));
  EXPECT_TRUE(source->rewind());
  EXPECT_EQ(test::read_all_messages(*source), messages);
}

// A part that was not copied along, and messages that are not there.
TEST(SqliteBag, WhatTheMetadataPromiseAndIsNotThereIsNoted) {
  const test::TemporaryFolder folder;
  const auto metadata = [&](const std::string& second, int messages) {
    folder.write("metadata.yaml",
                 "rosbag2_bagfile_information:\n  topics_with_message_count:\n"
                 "    - topic_metadata:\n        name: /t\n      message_count: 77\n"
                 "  relative_file_paths:\n    - bag_0.db3\n    - " +
                     second + "\n  message_count: " + std::to_string(messages) + "\n");
  };
  const auto losses = [&](const std::string& wanted) {
    const auto source = open_bag(folder.path());
    source->want(wanted);
    EXPECT_EQ(test::read_all_messages(*source).size(), wanted.empty() ? 3U : 0U);
    EXPECT_FALSE(source->next().has_value());
    return test::joined(source->losses());
  };
  make_bag(folder.path() / "bag_0.db3", kTopics[1], {"x", "y"});
  make_bag(folder.path() / "bag_1.db3", kTopics[1], {"z"});
  metadata("bag_1.db3", 3);
  EXPECT_EQ(losses(""), "");
  EXPECT_EQ(losses("/another"), "");
  metadata("bag_1.db3", 9);
  EXPECT_EQ(losses("/another"), "metadata.yaml says 9 messages; 3 were found\n");
  metadata("bag\x1b.db3", 3);
  EXPECT_EQ(losses(""), "metadata.yaml names bag?.db3, which is not there\n");
}

TEST(SqliteBag, PartsInNaturalOrderAndOnePartThatIsNone) {
  const test::TemporaryFolder folder;
  for (const int part : {10, 9, 2}) {
    make_bag(folder.path() / ("bag_" + std::to_string(part) + ".db3"), kTopics[1], {"x"}, part);
  }
  folder.write("bag_11.db3", "no database");
  folder.write("metadata.yaml", "rosbag2_bagfile_information:\n");
  const auto source = open_bag(folder.path());
  const auto messages = test::read_all_messages(*source);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[0].logged_ns, 2);
  EXPECT_EQ(messages[2].logged_ns, 10);
  EXPECT_NE(test::joined(source->notes()).find("bag_11.db3"), std::string::npos);
}

TEST(SqliteBag, CutFilesGiveWhatCanBeRead) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  make_bag(file, kTopics[1], std::vector<std::string>(20, std::string(3000, 'x')));
  const std::string whole = test::content_of(file);
  std::size_t most = 0;
  for (std::size_t size = 0; size < whole.size(); size += 1024) {
    const fs::path cut = folder.write("cut.db3", whole.substr(0, size));
    try {
      most = std::max(most, test::read_all_messages(*read_sqlite_bag(cut)).size());
    } catch (const ReadError&) {
    }
  }
  EXPECT_GT(most, 0U);
}

// As sqlite3 itself does not: its own reader stops at the first page that is damaged.
TEST(SqliteBag, RowsBehindDamageAreReadByTheirNumbers) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  std::vector<std::string> blobs;
  for (char c = 'a'; c < 'u'; ++c) blobs.emplace_back(20'000, c);
  make_bag(file, kTopics[1], blobs);
  std::string bytes = test::content_of(file);
  constexpr std::size_t kPage = 4096;
  const std::size_t overflow = bytes.find(std::string(4000, 'h')) / kPage * kPage;
  bytes.replace(overflow, 4, "\x7f\xff\xff\xff");  // where the message goes on
  const auto source = read_sqlite_bag(folder.write("b.db3", bytes));
  std::vector<ReadMessage> messages = test::read_all_messages(*source);
  ASSERT_EQ(messages.size(), 19U);
  EXPECT_EQ(messages[6], expected_row(6, blobs[6]));
  EXPECT_EQ(messages[7], expected_row(8, blobs[8]));
  EXPECT_TRUE(source->rewind());
  EXPECT_EQ(test::read_all_messages(*source), messages);
  ASSERT_EQ(source->notes().size(), 2U) << test::joined(source->notes());  // each once
  EXPECT_NE(source->notes()[0].find("damaged after message 7"), std::string::npos);
  EXPECT_EQ(source->notes()[1], "1 messages of the database's damaged part are lost");
}

TEST(SqliteBag, CutFileGivesEveryMessageBeforeTheCut) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  make_bag(file, kTopics[1], std::vector<std::string>(20, std::string(20'000, 'x')));
  const std::string bytes = test::content_of(file);
  const auto source = read_sqlite_bag(folder.write("b.db3", bytes.substr(0, bytes.size() / 2)));
  EXPECT_GE(test::read_all_messages(*source).size(), 7U);
  EXPECT_NE(test::joined(source->notes()).find("cut short"), std::string::npos);
}

// Each of a topic's publishers has a profile: cut, they would be no YAML.
TEST(SqliteBag, ProfilesOfManyPublishersAreWholeOrNone) {
  for (const std::size_t publishers : {std::size_t{200}, std::size_t{200'000}}) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.path() / "a.db3";
    make_bag(file, kTopics[1], {"one"});
    std::string profiles;
    for (std::size_t i = 0; i < publishers; ++i) profiles += "- history: 3\n  durability: 1\n";
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    const std::string update = "UPDATE topics SET offered_qos_profiles = '" + profiles + "'";
    ASSERT_EQ(sqlite3_exec(database, update.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
    const auto source = read_sqlite_bag(file);
    const auto message = source->next();
    ASSERT_TRUE(message);
    const bool is_kept = publishers == 200;
    EXPECT_EQ(message->topic->definition->qos, is_kept ? profiles : "");
    EXPECT_EQ(message->topic->definition->latched, is_kept);
  }
}

TEST(SqliteBag, MessagesOfNoTopicAreNoted) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  make_bag(file, kTopics[1], {"one"});
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  sqlite3_exec(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES (6, 1, 'x')",
               nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const auto source = read_sqlite_bag(file);
  EXPECT_EQ(test::read_all_messages(*source).size(), 1U);
  EXPECT_NE(test::joined(source->notes()).find("not in the table of topics"), std::string::npos);
}

// sqlite3 begins a query anew after a row that it refuses for its size.
TEST(SqliteBag, MessagesThatAreTooLargeAreNoDamage) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.db3";
  make_bag(file, kTopics[1], {"one"});
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const auto insert = [&](const std::string& topic, const std::string& data) {
    const std::string command =
        "INSERT INTO messages(topic_id, timestamp, data) VALUES (" + topic + ", 1, " + data + ")";
    ASSERT_EQ(sqlite3_exec(database, command.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  };
  sqlite3_exec(database, "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF", nullptr, nullptr,
               nullptr);
  insert("5", "zeroblob(270000000)");
  insert("5", "CAST('two' AS BLOB)");
  sqlite3_close(database);
  const auto source = read_sqlite_bag(file);
  const auto messages = test::read_all_messages(*source);
  ASSERT_EQ(messages.size(), 2U) << test::joined(source->notes());
  EXPECT_EQ(messages[1], expected_row(1, "two"));
  EXPECT_EQ(source->met(), 3U);
  ASSERT_EQ(source->losses().size(), 1U) << test::joined(source->notes());
  EXPECT_EQ(source->losses()[0], "a message of /p is passed over: larger than 256 MiB");
  EXPECT_TRUE(source->rewind());
  EXPECT_EQ(test::read_all_messages(*source), messages);
}

TEST(SqliteBag, AnotherDatabaseIsRefused) {
  const test::TemporaryFolder folder;
  sqlite3* database = nullptr;
  sqlite3_open((folder.path() / "a.db3").c_str(), &database);
  sqlite3_exec(database, "CREATE TABLE songs(name TEXT)", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  const std::string message =
      test::message_of<ReadError>([&] { (void)read_sqlite_bag(folder.path() / "a.db3"); });
  EXPECT_NE(message.find("no rosbag2 file"), std::string::npos) << message;
  EXPECT_THROW((void)open_bag(folder.path() / "absent.db3"), ReadError);
}

// YAML would take what stands behind the # for a comment.
TEST(SqliteBag, FoldersOfAnyNameAreNamedInTheirMetadata) {
  const test::TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "my \"walk\" #2";
  const auto bag = make_sqlite_bag(bag_folder);
  bag->write(bag->add_topic("/points", point_cloud2_definition()), 100, "message");
  bag->finish();
  const std::string metadata = test::content_of(bag_folder / "metadata.yaml");
  const std::string name = "\"my \\\"walk\\\" #2_0.db3\"\n";
  EXPECT_NE(metadata.find("    - " + name), std::string::npos) << metadata;
  EXPECT_NE(metadata.find("    - path: " + name), std::string::npos) << metadata;
  const auto read = open_bag(bag_folder);
  EXPECT_EQ(test::read_all_messages(*read).size(), 1U);
  EXPECT_TRUE(read->losses().empty());
}

TEST(SqliteBag, WhatIsWrittenIsReadBack) {
  const test::TemporaryFolder folder;
  const fs::path bag_folder = folder.path() / "walk";
  const auto bag = make_sqlite_bag(bag_folder);
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  for (int i = 0; i < 3; ++i) bag->write(topic, 100 + i, "message");
  bag->finish();
  const auto messages = test::read_all_messages(*open_bag(bag_folder));
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[2], (ReadMessage{"/points", "sensor_msgs/PointCloud2", 102, "message"}));
  const std::string metadata = test::content_of(bag_folder / "metadata.yaml");
  EXPECT_NE(metadata.find("walk_0.db3"), std::string::npos);
  EXPECT_NE(metadata.find("message_count: 3"), std::string::npos);
}

TEST(SqliteBag, DefinitionsOfTypesAreReadBack) {
  const test::TemporaryFolder folder;
  const auto bag = make_sqlite_bag(folder.path() / "walk");
  MessageDefinition own{"pkg/Own", "int32 a\n", "", ""};
  own.ros2_language = "ros2idl";
  for (const char* name : {"/a", "/b"}) {
    bag->write(bag->add_topic(name, own), 100, "message");
  }
  bag->finish();
  const auto source = open_bag(folder.path() / "walk");
  std::size_t messages = 0;
  for (; const auto message = source->next(); ++messages) {
    ASSERT_NE(message->topic->definition, nullptr);
    EXPECT_EQ(message->topic->definition->type, "pkg/msg/Own");
    EXPECT_EQ(message->topic->definition->text, "int32 a\n");
    EXPECT_EQ(message->topic->definition->language, "ros2idl");
  }
  EXPECT_EQ(messages, 2U);
}

}  // namespace
}  // namespace surefoot::io
