// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/sqlite_bag_reader.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>

#include "io/bags/compression.hpp"
#include "io/bags/sqlite_handles.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

/// A file of our own that goes with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(ByteStream& content) {
    std::string name = (fs::temp_directory_path() / "surefoot_bag_XXXXXX").string();
    const int handle = mkstemp(name.data());
    if (handle < 0) throw ReadError("no temporary file can be made to decompress it into: " + name);
    ::close(handle);
    path_ = name;
    try {
      fill(content);
    } catch (...) {
      remove();
      throw;
    }
  }
  ~TemporaryFile() { remove(); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  void fill(ByteStream& content) {
    std::ofstream file(path_, std::ios::binary);
    std::vector<std::byte> part(1 << 18);
    while (const std::size_t got = content.read(part)) {
      file.write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(got));
      if (!file.flush()) {
        throw ReadError(path_.string() + ": cannot decompress into it: " + std::strerror(errno));
      }
      if (!has_room()) {
        throw ReadError(path_.string() + ": no room to decompress into it: 64 MB are to be left");
      }
    }
  }
  /// What is compressed may be any length: others need the disk as well.
  [[nodiscard]] bool has_room() const {
    constexpr std::uintmax_t kLeft = std::uintmax_t{64} << 20;
    std::error_code error;
    const fs::space_info space = fs::space(path_, error);
    return error || space.available >= kLeft;
  }
  void remove() const {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  fs::path path_;
};

// "file:" and the path, with what a URI gives a meaning to written as %XX.
std::string uri_of(const fs::path& file) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string uri = "file:";
  for (const char c : fs::absolute(file).string()) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' || c == '_' ||
        c == '-') {
      uri += c;
    } else {
      uri += {'%', kDigits[static_cast<unsigned char>(c) >> 4],
              kDigits[static_cast<unsigned char>(c) & 15]};
    }
  }
  return uri;
}

class SqliteBagReader final : public MessageSource {
 public:
  explicit SqliteBagReader(const fs::path& file) {
    require_regular_file(file);
    // Once it is open nobody needs its name: without one it goes however the program ends.
    const std::unique_ptr<TemporaryFile> unpacked = unpack(file);
    const fs::path database = unpacked ? unpacked->path() : file;
    open(database, State::whole);
    if (is_malformed()) {
      open(database, State::malformed);
      note("the file is cut short or damaged; what can be reached is read");
    }
    read_topics();
    count_rows();
    in_order_ = prepare(std::string(kMessages) + kByNumber);
    by_number_ = prepare("SELECT topic_id, timestamp, data FROM messages WHERE rowid = ?");
  }

  std::optional<Message> next() override {
    while (sqlite3_stmt* const row = next_row()) {
      ++rows_read_;
      const auto topic = topics_.find(sqlite3_column_int64(row, 0));
      if (topic == topics_.end()) {
        note("messages of a topic that is not in the table of topics are passed over");
        continue;
      }
      if (!is_wanted(topic->second)) continue;
      const void* const blob = sqlite3_column_blob(row, 2);
      const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, 2));
      if (blob == nullptr && size > 0) {
        note_lost(topic->second, "it cannot be read");
        continue;
      }
      const std::span<const std::byte> bytes(static_cast<const std::byte*>(blob), size);
      const auto plain = compressed_.plain(bytes);
      if (plain) return Message{&topic->second, sane_time(sqlite3_column_int64(row, 1)), *plain};
      note_lost(topic->second, compressed_.problem());
    }
    return std::nullopt;
  }

  bool rewind() override {
    begin_anew();
    in_order_ = prepare(std::string(kMessages) + kByNumber);
    sqlite3_reset(by_number_.get());
    rows_read_ = row_number_ = lost_ = 0;
    is_searching_ = ended_ = false;
    return true;
  }
  double progress() const override {
    return rows_ <= 0 ? 1.0
                      : std::min(1.0, static_cast<double>(rows_read_) / static_cast<double>(rows_));
  }
  std::string format() const override {
    return compressed_.any() ? "ROS 2 bag (sqlite3, messages compressed)" : "ROS 2 bag (sqlite3)";
  }

 private:
  /// Nothing where sqlite3 can read it as it is.
  std::unique_ptr<TemporaryFile> unpack(const fs::path& file) {
    std::array<std::byte, 16> begin{};
    FileStream stream(file);
    const std::size_t got = stream.read(begin);
    const bool compressed =
        compression_by_content(std::span(begin).first(got)) != Compression::none;
    std::error_code ignored;
    const bool nameless = fs::hard_link_count(file, ignored) == 0;  // sqlite3 asks for the name
    if (!compressed && !nameless) return nullptr;
    auto unpacked = std::make_unique<TemporaryFile>(*open_stream(file));
    note_harmless(std::string("it is ") +
                  (compressed ? "compressed as a whole" : "a file without a name") +
                  ", and was written out to a temporary file to be read");
    return unpacked;
  }

  enum class State { whole, malformed };

  void open(const fs::path& file, State state) {
    // A bag whose recorder was stopped short has its last messages in a log beside it.
    std::error_code ignored;
    const bool has_log = fs::exists(file.string() + "-wal", ignored);
    const std::string uri = uri_of(file) + (has_log ? "?mode=ro" : "?immutable=1");
    sqlite3* handle = nullptr;
    const int result =
        sqlite3_open_v2(uri.c_str(), &handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    database_.reset(handle);
    if (result != SQLITE_OK) throw ReadError(std::string("sqlite3: ") + sqlite3_errmsg(handle));
    // What a file says must not run on: no views, no functions of a schema, no oversized rows.
    // A file that is shorter than it says opens only where its schema may be mended.
    const bool malformed = state == State::malformed;
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, malformed ? 0 : 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_WRITABLE_SCHEMA, malformed ? 1 : 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, static_cast<int>(kMostMessageBytes));
  }

  [[nodiscard]] bool is_malformed() const {
    constexpr const char* kQuery = "SELECT count(*) FROM sqlite_schema";
    return sqlite3_exec(database_.get(), kQuery, nullptr, nullptr, nullptr) == SQLITE_CORRUPT;
  }

  Statement prepare(const std::string& query) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_.get(), query.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
      throw ReadError(std::string("it is no rosbag2 file: sqlite3: ") +
                      sqlite3_errmsg(database_.get()));
    }
    return Statement(statement);
  }

  // Null where the database has no such table or column.
  Statement try_to_prepare(const char* query) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr);
    return Statement(statement);
  }

  static std::string text_of(sqlite3_stmt* row, int column) {
    const unsigned char* const text = sqlite3_column_text(row, column);
    return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
  }
  static std::string name_in(sqlite3_stmt* row, int column) {
    return text_of(row, column).substr(0, kMostNameBytes);
  }
  // Cut it would be no definition and no YAML. A profile for each of a topic's publishers takes
  // some hundred bytes.
  static std::string whole_text_in(sqlite3_stmt* row, int column) {
    constexpr std::size_t kMostBytes = 1 << 20;
    std::string text = text_of(row, column);
    return text.size() > kMostBytes ? std::string() : text;
  }

  // Bags since Iron hold the definitions of their types.
  TopicDefinition definition_of(std::string type) {
    TopicDefinition definition;
    definition.type = std::move(type);
    sqlite3_stmt* const row = definitions_.get();
    if (row == nullptr) return definition;
    sqlite3_reset(row);
    sqlite3_bind_text(row, 1, definition.type.c_str(), -1, SQLITE_TRANSIENT);
    if (sqlite3_step(row) != SQLITE_ROW) return definition;
    definition.language = name_in(row, 0);
    definition.text = whole_text_in(row, 1);
    return definition;
  }

  void read_topics() {
    constexpr std::size_t kMostTopics = 65'536;
    Statement rows = try_to_prepare(
        "SELECT id, name, type, serialization_format, offered_qos_profiles FROM topics");
    // The oldest bags have no such column.
    if (!rows) rows = prepare("SELECT id, name, type, serialization_format, '' FROM topics");
    definitions_ = try_to_prepare(
        "SELECT encoding, encoded_message_definition FROM message_definitions "
        "WHERE topic_type = ?");
    while (sqlite3_step(rows.get()) == SQLITE_ROW && topics_.size() < kMostTopics) {
      TopicDefinition definition = definition_of(name_in(rows.get(), 2));
      Topic topic{name_in(rows.get(), 1), plain_type_name(definition.type), MessageEncoding::other};
      definition.qos = whole_text_in(rows.get(), 4);
      definition.latched = is_latched_qos(definition.qos);
      topic.definition = keep(std::move(definition));
      const std::string encoding = name_in(rows.get(), 3);
      if (encoding == "cdr" || encoding.empty()) topic.encoding = MessageEncoding::cdr;
      if (encoding == "ros1" || encoding == "rosmsg_v2") topic.encoding = MessageEncoding::ros1;
      announce(topic);
      topics_.insert_or_assign(sqlite3_column_int64(rows.get(), 0), std::move(topic));
    }
  }

  // The greatest row number stands at the end of the table's tree: no counting.
  void count_rows() {
    const Statement row = prepare("SELECT max(rowid) FROM messages");
    if (sqlite3_step(row.get()) == SQLITE_ROW) rows_ = sqlite3_column_int64(row.get(), 0);
  }

  // Null at the end.
  sqlite3_stmt* next_row() {
    sqlite3_stmt* row = nullptr;
    while (row == nullptr && !ended_) row = is_searching_ ? row_by_number() : row_in_order();
    return row;
  }

  // A message that sqlite3 does not give out for its size; false where it is not found.
  bool pass_over_too_large() {
    const std::string behind = " WHERE rowid > ";
    const Statement large = prepare("SELECT rowid, topic_id FROM messages" + behind +
                                    std::to_string(row_number_) + kByNumber);
    if (sqlite3_step(large.get()) != SQLITE_ROW) return false;
    row_number_ = sqlite3_column_int64(large.get(), 0);
    in_order_ = prepare(kMessages + behind + std::to_string(row_number_) + kByNumber);
    ++rows_read_;
    const auto topic = topics_.find(sqlite3_column_int64(large.get(), 1));
    if (topic == topics_.end() || !is_wanted(topic->second)) return true;
    note_lost(topic->second, "larger than 256 MiB");
    return true;
  }

  // Null at the end, where a message is too large, and where the table's tree is damaged; then rows
  // are searched one by one.
  sqlite3_stmt* row_in_order() {
    sqlite3_stmt* const row = in_order_.get();
    const int result = sqlite3_step(row);
    if (result == SQLITE_ROW && (rows_read_ == 0 || sqlite3_column_int64(row, 3) > row_number_)) {
      row_number_ = sqlite3_column_int64(row, 3);
      return row;
    }
    ended_ = result == SQLITE_DONE;
    if (ended_) return nullptr;
    if (result == SQLITE_TOOBIG && pass_over_too_large()) return nullptr;
    note("the database is damaged after message " + std::to_string(row_number_) +
         "; what can be reached is read: sqlite3: " + sqlite3_errmsg(database_.get()));
    is_searching_ = true;
    return nullptr;
  }

  sqlite3_stmt* row_by_number() {
    // Of a tree's inner page that is lost; nothing says how many rows a damaged file holds.
    constexpr std::int64_t kMostMissed = 50'000;
    sqlite3_stmt* const row = by_number_.get();
    for (std::int64_t missed = 0; missed < kMostMissed && row_number_ != rows_; ++missed) {
      sqlite3_reset(row);
      sqlite3_bind_int64(row, 1, ++row_number_);
      const int result = sqlite3_step(row);
      if (result == SQLITE_ROW) return row;
      lost_ += result == SQLITE_DONE ? 0 : 1;
    }
    ended_ = true;
    if (rows_ > 0 && lost_ > 0) {
      note(std::to_string(lost_) + " messages of the database's damaged part are lost");
    }
    return nullptr;
  }

  static constexpr const char* kMessages = "SELECT topic_id, timestamp, data, rowid FROM messages";
  static constexpr const char* kByNumber = " ORDER BY rowid";
  Database database_;
  Statement in_order_;
  Statement by_number_;
  Statement definitions_;  ///< of a type; null where the bag has none
  std::map<std::int64_t, Topic> topics_;
  CompressedMessages compressed_;
  std::int64_t rows_ = -1;  ///< greatest row number; -1: not known
  std::int64_t rows_read_ = 0;
  std::int64_t row_number_ = 0;
  std::int64_t lost_ = 0;
  bool is_searching_ = false;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> read_sqlite_bag(const fs::path& file) {
  return std::make_unique<SqliteBagReader>(file);
}

}  // namespace surefoot::io
