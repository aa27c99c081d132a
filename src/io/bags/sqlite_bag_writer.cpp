// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "io/bags/sqlite_handles.hpp"
#include "io/file_writer.hpp"
#include "io/yaml_word.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

// rosbag2_storage_sqlite3, version 4 of its tables, with types' definitions. Who knows version 3
// alone, as Humble, finds its own columns.
constexpr const char* kTables =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL,"
    " metadata TEXT NOT NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL,"
    " type_description_hash TEXT NOT NULL);"
    "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,"
    " encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL,"
    " type_description_hash TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
    " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "INSERT INTO schema(schema_version, ros_distro) VALUES (4, 'iron');";

class SqliteBag final : public BagWriter {
 public:
  explicit SqliteBag(const fs::path& folder) : folder_(folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw WriteError(folder.string() + ": cannot be made: " + error.message());
    const fs::path whole = fs::absolute(folder, error).lexically_normal();
    fs::path name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    if (name.extension() == kUnfinished) name = name.stem();  // it is renamed in the end
    file_name_ = name.string() + "_0.db3";
    const fs::path file = folder_ / file_name_;
    fs::remove(file, error);
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    database_.reset(database);
    run("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;");
    run(kTables);
    run("BEGIN;");
    insert_ = prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
  }

  ~SqliteBag() override {
    if (finished_) return;
    sqlite3_exec(database_.get(), "COMMIT;", nullptr, nullptr, nullptr);  // of none: does nothing
  }
  SqliteBag(const SqliteBag&) = delete;
  SqliteBag& operator=(const SqliteBag&) = delete;

  std::size_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    topics_.push_back({name, definition.ros2_type(), definition.qos, 0});
    const Statement statement = prepare("INSERT INTO topics VALUES (?, ?, ?, 'cdr', ?, '')");
    sqlite3_stmt* const row = statement.get();
    sqlite3_bind_int64(row, 1, static_cast<sqlite3_int64>(topics_.size()));
    sqlite3_bind_text(row, 2, name.c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_bind_text(row, 3, topics_.back().type.c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_bind_text(row, 4, definition.qos.c_str(), -1, SQLITE_TRANSIENT);
    if (sqlite3_step(row) != SQLITE_DONE) fail();
    define(definition);
    return topics_.size();
  }

  void write(std::size_t topic, std::int64_t stamp_ns, std::string_view message) override {
    sqlite3_stmt* const row = insert_.get();
    sqlite3_bind_int64(row, 1, static_cast<sqlite3_int64>(topic));
    sqlite3_bind_int64(row, 2, stamp_ns);
    sqlite3_bind_blob64(row, 3, message.data(), message.size(), SQLITE_STATIC);
    if (sqlite3_step(row) != SQLITE_DONE) fail();
    sqlite3_reset(row);
    first_ns_ = messages_ == 0 ? stamp_ns : std::min(first_ns_, stamp_ns);
    last_ns_ = messages_ == 0 ? stamp_ns : std::max(last_ns_, stamp_ns);
    ++messages_;
    ++topics_[topic - 1].messages;
  }

  void finish() override {
    if (finished_) return;
    finished_ = true;
    run("COMMIT;");
    write_whole_file(folder_ / "metadata.yaml", metadata());
  }

 private:
  struct TopicCount {
    std::string name;
    std::string type;
    std::string qos;
    std::size_t messages;
  };

  /// Every type once.
  void define(const MessageDefinition& definition) {
    if (definition.ros2_text.empty() || !defined_.insert(definition.ros2_type()).second) return;
    const Statement statement = prepare(
        "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition,"
        " type_description_hash) VALUES (?, ?, ?, '')");
    sqlite3_stmt* const row = statement.get();
    sqlite3_bind_text(row, 1, definition.ros2_type().c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_bind_text(row, 2, definition.ros2_language.c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_bind_text(row, 3, definition.ros2_text.c_str(), -1, SQLITE_TRANSIENT);
    if (sqlite3_step(row) != SQLITE_DONE) fail();
  }

  [[noreturn]] void fail() const {
    throw WriteError((folder_ / file_name_).string() + ": cannot be written: " +
                     (database_ != nullptr ? sqlite3_errmsg(database_.get()) : "no memory"));
  }
  void run(const char* commands) {
    if (sqlite3_exec(database_.get(), commands, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
  }
  Statement prepare(const char* command) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_.get(), command, -1, &statement, nullptr) != SQLITE_OK) fail();
    return Statement(statement);
  }

  [[nodiscard]] std::string metadata() const {
    const std::string duration = std::to_string(last_ns_ - first_ns_);
    const std::string count = std::to_string(messages_);
    const std::string file = yaml_word(file_name_);
    std::string text =
        "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n";
    text += "  duration:\n    nanoseconds: " + duration + "\n";
    text += "  starting_time:\n    nanoseconds_since_epoch: " + std::to_string(first_ns_) + "\n";
    text += "  message_count: " + count + "\n  topics_with_message_count:\n";
    for (const TopicCount& topic : topics_) {
      text += "    - topic_metadata:\n        name: " + yaml_word(topic.name) +
              "\n        type: " + yaml_word(topic.type) +
              "\n        serialization_format: cdr\n        offered_qos_profiles: " +
              yaml_word(topic.qos) + "\n      message_count: " + std::to_string(topic.messages) +
              "\n";
    }
    text += "  compression_format: \"\"\n  compression_mode: \"\"\n";
    text += "  relative_file_paths:\n    - " + file + "\n  files:\n    - path: " + file;
    text += "\n      starting_time:\n        nanoseconds_since_epoch: " + std::to_string(first_ns_);
    text += "\n      duration:\n        nanoseconds: " + duration;
    return text + "\n      message_count: " + count + "\n";
  }

  fs::path folder_;
  std::string file_name_;
  Database database_;
  Statement insert_;
  std::vector<TopicCount> topics_;
  std::set<std::string> defined_;  ///< types
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::size_t messages_ = 0;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<BagWriter> make_sqlite_bag(const fs::path& folder) {
  return std::make_unique<SqliteBag>(folder);
}

}  // namespace surefoot::io
