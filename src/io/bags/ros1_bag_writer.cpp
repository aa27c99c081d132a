// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A ROS 1 bag as rosbag_storage lays it out: the file's header, chunks each with its index, and at
// the end all connections and a summary of every chunk.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "io/bags/ros1_bag_format.hpp"
#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kFileHeaderBytes = 4096;
constexpr std::size_t kChunkBytes = 768 * 1024;

template <typename T>
std::string little_endian(T value) {
  std::string bytes;
  append_bytes(bytes, value);
  return bytes;
}

void append_sized(std::string& out, std::string_view bytes) {
  append_bytes(out, static_cast<std::uint32_t>(bytes.size()));
  out += bytes;
}

class Fields {
 public:
  explicit Fields(RecordKind op) { add("op", std::string(1, static_cast<char>(op))); }
  Fields() = default;
  Fields& add(std::string_view name, std::string_view value) {
    append_sized(bytes_, std::string(name) + '=' + std::string(value));
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string record(const Fields& fields, std::string_view data) {
  std::string bytes;
  append_sized(bytes, fields.bytes());
  append_sized(bytes, data);
  return bytes;
}

std::string ros_time(std::int64_t stamp_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t time = std::max<std::int64_t>(stamp_ns, 0);
  return little_endian(static_cast<std::uint32_t>(time / kSecond)) +
         little_endian(static_cast<std::uint32_t>(time % kSecond));
}

class Ros1Bag final : public BagWriter {
 public:
  explicit Ros1Bag(const std::filesystem::path& file) : path_(file), file_(file, std::ios::binary) {
    put(std::string(kRos1BagMagic) + file_header(0));
  }

  ~Ros1Bag() override {
    try {
      finish();
    } catch (const WriteError&) {  // finish() by hand tells it
    }
  }
  Ros1Bag(const Ros1Bag&) = delete;
  Ros1Bag& operator=(const Ros1Bag&) = delete;

  std::size_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    const auto id = static_cast<std::uint32_t>(connections_.size());
    Fields data;
    data.add("topic", name).add("type", definition.type).add("md5sum", definition.ros1_md5);
    data.add("message_definition", definition.ros1_text);
    if (definition.latched) data.add("latching", "1");
    Fields header(RecordKind::connection);
    header.add("conn", little_endian(id)).add("topic", name);
    connections_.push_back(record(header, data.bytes()));
    chunk_.content += connections_.back();
    return id;
  }

  void write(std::size_t topic, std::int64_t stamp_ns, std::string_view message) override {
    const auto id = static_cast<std::uint32_t>(topic);
    const std::string time = ros_time(stamp_ns);
    const auto offset = static_cast<std::uint32_t>(chunk_.content.size());
    std::string& index = chunk_.index[id];
    index += time + little_endian(offset);
    Fields header(RecordKind::message);
    header.add("conn", little_endian(id)).add("time", time);
    chunk_.content += record(header, message);
    const bool first = chunk_.first_ns > chunk_.last_ns;
    chunk_.first_ns = first ? stamp_ns : std::min(chunk_.first_ns, stamp_ns);
    chunk_.last_ns = first ? stamp_ns : std::max(chunk_.last_ns, stamp_ns);
    if (chunk_.content.size() >= kChunkBytes) finish_chunk();
  }

  void finish() override {
    if (finished_) return;
    finished_ = true;
    finish_chunk();
    const std::uint64_t index_position = position_;
    for (const std::string& connection : connections_) put(connection);
    for (const std::string& info : chunk_infos_) put(info);
    file_.seekp(static_cast<std::streamoff>(kRos1BagMagic.size()));
    put(file_header(index_position));
    file_.close();
    if (!file_) fail();
  }

  [[nodiscard]] MessageWriter::Flavour flavour() const override {
    return MessageWriter::Flavour::ros1;
  }

 private:
  struct Chunk {
    std::string content;
    std::map<std::uint32_t, std::string> index;  ///< by connection: times and offsets
    std::int64_t first_ns = 1;
    std::int64_t last_ns = 0;
  };

  // Always of one size, so that it can be written again at the end.
  [[nodiscard]] std::string file_header(std::uint64_t index_position) const {
    Fields fields(RecordKind::file_header);
    fields.add("index_pos", little_endian(index_position));
    fields.add("conn_count", little_endian(static_cast<std::uint32_t>(connections_.size())));
    fields.add("chunk_count", little_endian(static_cast<std::uint32_t>(chunk_infos_.size())));
    const std::size_t used = fields.bytes().size() + 2 * sizeof(std::uint32_t);
    return record(fields, std::string(kFileHeaderBytes - used, ' '));
  }

  void finish_chunk() {
    if (chunk_.content.empty()) return;
    const std::uint64_t chunk_position = position_;
    Fields header(RecordKind::chunk);
    header.add("compression", "none");
    header.add("size", little_endian(static_cast<std::uint32_t>(chunk_.content.size())));
    put(record(header, chunk_.content));
    std::string counts;
    for (const auto& [id, entries] : chunk_.index) {
      constexpr std::size_t kEntryBytes = 12;
      const auto count = static_cast<std::uint32_t>(entries.size() / kEntryBytes);
      Fields index(RecordKind::index);
      index.add("ver", little_endian(std::uint32_t{1})).add("conn", little_endian(id));
      index.add("count", little_endian(count));
      put(record(index, entries));
      counts += little_endian(id) + little_endian(count);
    }
    Fields info(RecordKind::chunk_info);
    info.add("ver", little_endian(std::uint32_t{1}))
        .add("chunk_pos", little_endian(chunk_position));
    info.add("start_time", ros_time(chunk_.first_ns)).add("end_time", ros_time(chunk_.last_ns));
    info.add("count", little_endian(static_cast<std::uint32_t>(chunk_.index.size())));
    chunk_infos_.push_back(record(info, counts));
    chunk_ = {};
  }

  [[noreturn]] void fail() const {
    throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
  }

  void put(std::string_view bytes) {
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file_) fail();
    position_ += bytes.size();
  }

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint64_t position_ = 0;
  Chunk chunk_;
  std::vector<std::string> connections_, chunk_infos_;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<BagWriter> make_ros1_bag(const std::filesystem::path& file) {
  return std::make_unique<Ros1Bag>(file);
}

}  // namespace surefoot::io
