// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/ros1_bag_reader.hpp"

#include <array>
#include <cstring>
#include <map>

#include "io/bags/compression.hpp"
#include "io/bags/ros1_bag_format.hpp"
#include "io/messages/message_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::uint32_t kMostHeaderBytes = 1 << 20;
constexpr std::uint32_t kMostConnectionBytes = 16 << 20;
// More have never been seen; what a file of nothing else may hold in memory.
constexpr std::size_t kMostConnections = 65'536;

/// The "name=value" fields of a record's header, or of a connection's data.
class RecordFields {
 public:
  explicit RecordFields(std::span<const std::byte> bytes) : reader_(MessageReader::packed(bytes)) {}

  /// Empty where there is none of that name.
  [[nodiscard]] std::string_view find(std::string_view name) const {
    MessageReader reader = reader_;
    while (!reader.rest().empty()) {
      const std::string_view field = reader.string("header's field");
      const std::size_t equals = field.find('=');
      if (equals != std::string_view::npos && field.substr(0, equals) == name) {
        return field.substr(equals + 1);
      }
    }
    return {};
  }

  template <typename T>
  [[nodiscard]] T number(std::string_view name) const {
    const std::string_view value = find(name);
    if (value.size() != sizeof(T)) {
      throw ReadError("a record's header has no '" + std::string(name) + "' of " +
                      std::to_string(sizeof(T)) + " bytes");
    }
    return load<T>(reinterpret_cast<const std::byte*>(value.data()), false);
  }

 private:
  MessageReader reader_;
};

/// A chunk that is being read; the parts refer to each other from top to bottom.
struct OpenRos1Chunk {
  OpenRos1Chunk(ByteStream& file, std::uint32_t size, Compression compression)
      : record(file, size),
        inside(compression == Compression::none ? nullptr : decompress(compression, record)) {}
  [[nodiscard]] ByteStream& content() {
    return inside ? *inside : static_cast<ByteStream&>(record);
  }

  LimitedStream record;
  std::unique_ptr<ByteStream> inside;
  std::optional<std::uint64_t> announced;  ///< bytes of content, as the chunk's head says
  std::uint64_t passed = 0;                ///< of them in records so far
  std::size_t number = 0;
};

constexpr std::string_view kCutShort = "the file is cut short; what is whole was read";

class Ros1BagReader final : public MessageSource {
 public:
  explicit Ros1BagReader(std::unique_ptr<ByteStream> file) : file_(std::move(file)) {
    std::array<std::byte, kRos1BagMagic.size()> magic{};
    const std::size_t got = file_->read(magic);
    if (got < magic.size() || std::memcmp(magic.data(), kRos1BagMagic.data(), got) != 0) {
      throw ReadError("it does not begin as a ROS 1 bag of version 2.0 does ('#ROSBAG V2.0')");
    }
  }

  std::optional<Message> next() override {
    while (!ended_) {
      try {
        if (std::optional<Message> message = read_record(chunk_ ? chunk_->content() : *file_)) {
          return message;
        }
      } catch (const ReadError& error) {
        give_up(error.what());
      }
    }
    return std::nullopt;
  }

  double progress() const override { return ended_ ? 1.0 : file_->progress(); }
  std::string format() const override { return "ROS 1 bag"; }

 private:
  // A chunk that is damaged ends; what comes after its record may be whole.
  void give_up(const std::string& why) {
    if (!chunk_) {
      ended_ = true;
      return note("reading ends early: " + why);
    }
    note("chunk " + std::to_string(chunk_->number) + " is damaged, read as far as it goes: " + why);
    leave_chunk();
  }

  void leave_chunk() {
    chunk_->record.skip(chunk_->record.left());
    if (chunk_->record.left() > 0) note(kCutShort);
    chunk_.reset();
  }

  void end_of(bool between_records) {
    if (chunk_) return finish_chunk(between_records);
    ended_ = true;
    if (!between_records) note(kCutShort);
  }

  // That the file ends within the chunk is noted where the chunk is left.
  void finish_chunk(bool between_records) {
    const bool is_cut = chunk_->record.left() > 0;
    const std::string name = "chunk " + std::to_string(chunk_->number);
    if (!is_cut && chunk_->announced && chunk_->passed != *chunk_->announced) {
      note(name + " holds " + std::to_string(chunk_->passed) + " bytes in whole records where " +
           std::to_string(*chunk_->announced) + " were announced: messages are lost");
    } else if (!is_cut && !between_records) {
      note(name + " ends within a record");
    }
    leave_chunk();
  }

  static std::optional<std::uint32_t> read_length(ByteStream& stream, bool& at_end) {
    std::array<std::byte, 4> bytes;
    const std::size_t got = stream.read(bytes);
    at_end = got == 0;
    if (got < bytes.size()) return std::nullopt;
    return load<std::uint32_t>(bytes.data(), false);
  }

  // Nothing for a record that holds no message, and at the end.
  std::optional<Message> read_record(ByteStream& stream) {
    bool at_end = false;
    const auto header_bytes = read_length(stream, at_end);
    if (!header_bytes) {
      end_of(at_end);
      return std::nullopt;
    }
    if (*header_bytes > kMostHeaderBytes) {
      throw ReadError("a record's header of " + std::to_string(*header_bytes) + " bytes");
    }
    const auto header = read_bytes(stream, *header_bytes, header_);
    const auto data_bytes = header ? read_length(stream, at_end) : std::nullopt;
    if (!data_bytes) {
      end_of(false);
      return std::nullopt;
    }
    const RecordFields fields(*header);
    const auto op = static_cast<RecordKind>(fields.number<std::uint8_t>("op"));
    if (op == RecordKind::chunk && !chunk_) {
      open_chunk(fields, *data_bytes);
      return std::nullopt;
    }
    LimitedStream data(stream, *data_bytes);
    std::optional<Message> message;
    if (op == RecordKind::connection) read_connection(fields, data);
    if (op == RecordKind::message) message = read_message(fields, data);
    data.skip(data.left());
    if (chunk_) {
      pass_record(*header_bytes, *data_bytes, data.left());
    } else if (data.left() > 0) {
      end_of(false);
    }
    return message;
  }

  void pass_record(std::uint64_t header_bytes, std::uint64_t data_bytes, std::uint64_t missing) {
    constexpr std::uint64_t kTwoLengths = 8;
    chunk_->passed += kTwoLengths + header_bytes + data_bytes;
    if (missing > 0 && chunk_->record.left() == 0) {
      throw ReadError("a record of " + std::to_string(data_bytes) + " bytes ends " +
                      std::to_string(missing) + " bytes early");
    }
  }

  void open_chunk(const RecordFields& fields, std::uint32_t size) {
    const std::string name(fields.find("compression").substr(0, kMostNameBytes));
    const std::optional<Compression> compression = compression_named(name);
    chunk_.emplace(*file_, size, compression.value_or(Compression::none));
    chunk_->number = chunks_++;
    if (!fields.find("size").empty()) chunk_->announced = fields.number<std::uint32_t>("size");
    if (!compression) throw ReadError("its compression is '" + name + "'; expected bz2 or lz4");
  }

  void read_connection(const RecordFields& fields, LimitedStream& data) {
    const auto id = fields.number<std::uint32_t>("conn");
    if (topics_.count(id) > 0 || topics_.size() >= kMostConnections) return;
    if (data.left() > kMostConnectionBytes) return;
    Topic topic;
    topic.name = fields.find("topic").substr(0, kMostNameBytes);
    const auto bytes = read_bytes(data, data.left(), data_);
    if (!bytes) return;
    const RecordFields connection(*bytes);
    TopicDefinition definition;
    definition.type = connection.find("type").substr(0, kMostNameBytes);
    definition.text = connection.find("message_definition");
    definition.language = "ros1msg";
    definition.md5 = connection.find("md5sum");
    definition.latched = connection.find("latching") == "1";
    topic.type = plain_type_name(definition.type);
    topic.encoding = MessageEncoding::ros1;
    topic.definition = keep(std::move(definition));
    announce(topic);
    topics_.emplace(id, std::move(topic));
  }

  std::optional<Message> read_message(const RecordFields& fields, LimitedStream& data) {
    const auto topic = topics_.find(fields.number<std::uint32_t>("conn"));
    if (topic == topics_.end()) {
      if (!lost_connection_) {
        note("messages of a connection that was not announced are passed over");
      }
      lost_connection_ = true;
      return std::nullopt;
    }
    if (!is_wanted(topic->second)) return std::nullopt;
    const auto time = fields.number<std::uint64_t>("time");  // seconds, nanoseconds
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t logged_ns = static_cast<std::int64_t>(time & 0xffff'ffffU) * kSecond +
                                   static_cast<std::int64_t>(time >> 32);
    constexpr std::uint64_t kReadAhead = 1 << 20;  // a block of bzip2's among it
    std::optional<CompressedSource> source;
    if (chunk_ && chunk_->inside) source.emplace(CompressedSource{chunk_->record, kReadAhead});
    const auto bytes = read_message_bytes(topic->second, data, source ? &*source : nullptr, data_);
    return bytes ? std::optional(Message{&topic->second, logged_ns, *bytes}) : std::nullopt;
  }

  std::unique_ptr<ByteStream> file_;
  std::optional<OpenRos1Chunk> chunk_;
  std::map<std::uint32_t, Topic> topics_;
  std::vector<std::byte> header_;
  std::vector<std::byte> data_;
  std::size_t chunks_ = 0;
  bool lost_connection_ = false;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> read_ros1_bag(std::unique_ptr<ByteStream> file) {
  return std::make_unique<Ros1BagReader>(std::move(file));
}

}  // namespace surefoot::io
