// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/sqlite_bag_reader.hpp"

#include <sqlite3.h>

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>

#include "io/bags/compression.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, EndStatement>;

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
        throw ReadError(path_.string() + ": no room to decompress it into (disk full?)");
      }
    }
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
    const fs::path database = unpack(file);
    open(database);
    read_topics();
    count_rows();
    messages_ = prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY rowid");
  }

  std::optional<Message> next() override {
    while (const std::optional<std::pair<const Topic*, std::int64_t>> row = next_row()) {
      const auto [topic, logged_ns] = *row;
      if (topic == nullptr || !is_wanted(*topic)) continue;
      const void* const blob = sqlite3_column_blob(messages_.get(), 2);
      const auto size = static_cast<std::size_t>(sqlite3_column_bytes(messages_.get(), 2));
      if (blob == nullptr && size > 0) continue;
      const std::span<const std::byte> bytes(static_cast<const std::byte*>(blob), size);
      if (const auto plain = compressed_.plain(bytes)) return Message{topic, logged_ns, *plain};
      note("message " + std::to_string(rows_read_) + " is passed over: " + compressed_.problem());
    }
    return std::nullopt;
  }

  bool rewind() override {
    sqlite3_reset(messages_.get());
    rows_read_ = 0;
    ended_ = false;
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
  fs::path unpack(const fs::path& file) {
    std::array<std::byte, 4> begin{};
    FileStream stream(file);
    const std::size_t got = stream.read(begin);
    if (!is_zstd(std::span(begin).first(got))) return file;
    temporary_ = std::make_unique<TemporaryFile>(*open_stream(file));
    note("it is compressed as a whole, and was written out to a temporary file to be read");
    return temporary_->path();
  }

  void open(const fs::path& file) {
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
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, static_cast<int>(kMostMessageBytes));
  }

  Statement prepare(const char* query) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr) != SQLITE_OK) {
      throw ReadError(std::string("it is no rosbag2 file: sqlite3: ") +
                      sqlite3_errmsg(database_.get()));
    }
    return Statement(statement);
  }

  static std::string text_of(sqlite3_stmt* row, int column) {
    const unsigned char* const text = sqlite3_column_text(row, column);
    return text == nullptr
               ? std::string()
               : std::string(reinterpret_cast<const char*>(text)).substr(0, kMostNameBytes);
  }

  void read_topics() {
    constexpr std::size_t kMostTopics = 65'536;
    const Statement rows = prepare("SELECT id, name, type, serialization_format FROM topics");
    while (sqlite3_step(rows.get()) == SQLITE_ROW && topics_.size() < kMostTopics) {
      Topic topic{text_of(rows.get(), 1), plain_type_name(text_of(rows.get(), 2)),
                  MessageEncoding::other};
      const std::string encoding = text_of(rows.get(), 3);
      if (encoding == "cdr" || encoding.empty()) topic.encoding = MessageEncoding::cdr;
      if (encoding == "ros1" || encoding == "rosmsg_v2") topic.encoding = MessageEncoding::ros1;
      topics_.insert_or_assign(sqlite3_column_int64(rows.get(), 0), std::move(topic));
    }
  }

  // The greatest row number stands at the end of the table's tree: no counting.
  void count_rows() {
    const Statement row = prepare("SELECT max(rowid) FROM messages");
    if (sqlite3_step(row.get()) == SQLITE_ROW) rows_ = sqlite3_column_int64(row.get(), 0);
  }

  // The next row's topic, null where it is not known, and time.
  std::optional<std::pair<const Topic*, std::int64_t>> next_row() {
    if (ended_) return std::nullopt;
    const int result = sqlite3_step(messages_.get());
    ended_ = result != SQLITE_ROW;
    if (ended_) {
      if (result != SQLITE_DONE) {
        note("reading ends early after " + std::to_string(rows_read_) +
             " messages: sqlite3: " + sqlite3_errmsg(database_.get()));
      }
      return std::nullopt;
    }
    ++rows_read_;
    const auto topic = topics_.find(sqlite3_column_int64(messages_.get(), 0));
    return std::pair{topic == topics_.end() ? nullptr : &topic->second,
                     sane_time(sqlite3_column_int64(messages_.get(), 1))};
  }

  std::unique_ptr<TemporaryFile> temporary_;
  Database database_;
  Statement messages_;
  std::map<std::int64_t, Topic> topics_;
  CompressedMessages compressed_;
  std::int64_t rows_ = 0;
  std::int64_t rows_read_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> read_sqlite_bag(const fs::path& file) {
  return std::make_unique<SqliteBagReader>(file);
}

}  // namespace surefoot::io
