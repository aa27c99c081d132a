// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/mcap_reader.hpp"

#include <map>

#include "io/bags/compression.hpp"
#include "io/bags/mcap_format.hpp"
#include "io/messages/message_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

using mcap::Opcode;

// Longer schemas, channels and headers are passed over [bytes].
constexpr std::uint64_t kMostRecordBytes = 16 << 20;

constexpr std::uint64_t kLongestFrame = 1 << 10;  // that a compression adds which gains nothing
constexpr std::uint64_t kLongestRecord = std::uint64_t{1} << 40;

struct RecordHead {
  Opcode opcode{};
  std::uint64_t length = 0;
};

// Nothing at the end, also within a head.
std::optional<RecordHead> read_head(ByteStream& stream) {
  std::array<std::byte, 9> bytes;
  if (stream.read(bytes) < bytes.size()) return std::nullopt;
  return RecordHead{static_cast<Opcode>(bytes[0]), load<std::uint64_t>(bytes.data() + 1, false)};
}

/// A chunk that is being read. The parts refer to each other from top to bottom.
struct OpenChunk {
  OpenChunk(ByteStream& file, std::uint64_t record_bytes) : record(file, record_bytes) {}

  LimitedStream record;  ///< what is left of the chunk's record
  std::optional<LimitedStream> compressed;
  std::unique_ptr<ByteStream> inside;
  std::optional<LimitedStream> announced;  ///< of `inside`, where no length tells its end
  std::optional<ChecksumStream> content;
  std::uint64_t size = 0;
  std::uint32_t crc = 0;
  std::size_t number = 0;

  // Both lengths promise more where the file ended before.
  [[nodiscard]] bool is_cut() const { return compressed->left() > 0 && record.left() > 0; }
};

class McapReader final : public MessageSource {
 public:
  explicit McapReader(std::unique_ptr<ByteStream> file)
      : file_(std::move(file)), ahead_(*file_), data_(ahead_) {
    std::array<std::byte, mcap::kMagic.size()> magic{};
    const std::size_t got = data_.read(magic);
    if (got < magic.size() || std::memcmp(magic.data(), mcap::kMagic.data(), got) != 0) {
      throw ReadError("it does not begin as MCAP does (0x89 'MCAP0')");
    }
  }

  std::optional<Message> next() override {
    while (!ended_) {
      try {
        if (std::optional<Message> message = chunk_ ? read_from_chunk() : read_from_file()) {
          return message;
        }
      } catch (const ReadError& error) {
        give_up(error.what());
      }
    }
    return std::nullopt;
  }

  double progress() const override { return ended_ ? 1.0 : file_->progress(); }
  std::string format() const override {
    return "MCAP, profile " + (profile_.empty() ? "none" : profile_) +
           (compressed_.any() ? ", messages compressed" : "");
  }

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
    chunk_.reset();
  }

  std::optional<Message> read_from_file() {
    // The checksum that the record of the data's end holds is of all before it.
    const std::uint32_t crc = data_.crc();
    const std::optional<RecordHead> head = read_head(data_);
    if (!head) {
      ended_ = true;
      note("the file is cut short: it ends without MCAP's end of data, after " +
           std::to_string(data_.size()) + " bytes; what is whole was read");
      return std::nullopt;
    }
    LimitedStream record(data_, head->length);
    std::optional<Message> message;
    switch (head->opcode) {
      case Opcode::header:
        if (const auto body = read_body(record)) read_file_header(*body);
        break;
      case Opcode::chunk:
        open_chunk(head->length);
        return std::nullopt;
      case Opcode::data_end:
        if (const auto body = read_body(record)) check_data(*body, crc);
        pass_summary();
        ended_ = true;
        return std::nullopt;
      case Opcode::footer:
        ended_ = true;
        return std::nullopt;
      default:
        message = read_data_record(*head, record);
    }
    record.skip(record.left());
    return message;
  }

  std::optional<Message> read_from_chunk() {
    ByteStream& content = *chunk_->content;
    const std::optional<RecordHead> head = read_head(content);
    if (!head) {
      finish_chunk();
      return std::nullopt;
    }
    LimitedStream record(content, head->length);
    std::optional<Message> message = read_data_record(*head, record);
    record.skip(record.left());
    if (record.left() > 0 && !chunk_->is_cut()) {
      throw ReadError(std::string(head->opcode == Opcode::message ? "a message" : "a record") +
                      " of " + std::to_string(head->length) + " bytes ends " +
                      std::to_string(record.left()) + " bytes early");
    }
    return message;
  }

  // Nothing in the summary is needed; behind it the file ends.
  void pass_summary() {
    while (const std::optional<RecordHead> head = read_head(ahead_)) {
      LimitedStream record(ahead_, head->length);
      record.skip(record.left());
      if (head->opcode != Opcode::footer) continue;
      std::array<std::byte, mcap::kMagic.size() + 1> end{};
      if (ahead_.read(end) == end.size()) {
        note("the file goes on after its end, with another recording perhaps: it is not read");
      }
      return;
    }
  }

  // A schema, a channel or a message, which may be in a chunk or not.
  std::optional<Message> read_data_record(const RecordHead& head, LimitedStream& record) {
    switch (head.opcode) {
      case Opcode::schema:
        if (const auto body = read_body(record)) read_schema(*body);
        return std::nullopt;
      case Opcode::channel:
        if (const auto body = read_body(record)) read_channel(*body);
        return std::nullopt;
      case Opcode::message:
        return read_message(record);
      case Opcode::attachment:
        set_passed_over({passed_over().attachments + 1, passed_over().metadata});
        return std::nullopt;
      case Opcode::metadata:
        set_passed_over({passed_over().attachments, passed_over().metadata + 1});
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  std::optional<std::span<const std::byte>> read_body(LimitedStream& record) {
    if (record.left() > kMostRecordBytes) return std::nullopt;
    return read_bytes(record, record.left(), body_);
  }

  void read_file_header(std::span<const std::byte> body) {
    profile_ = std::string(MessageReader::packed(body).string("profile").substr(0, kMostNameBytes));
  }

  void read_schema(std::span<const std::byte> body) {
    MessageReader reader = MessageReader::packed(body);
    const auto id = reader.number<std::uint16_t>("schema's number");
    TopicDefinition definition;
    definition.type = reader.string("schema's name").substr(0, kMostNameBytes);
    try {
      definition.language = reader.string("schema's encoding");
      definition.text = reader.string("schema");
    } catch (const ReadError&) {
      definition.language.clear();  // its name is enough to read messages
    }
    const auto& known = schemas_[id];
    if (known && known->type == definition.type && known->text == definition.text) return;
    schemas_[id] = keep(std::move(definition));
  }

  // What a channel says of its topic besides, by keys that rosbag2 and converters of ROS 1 write.
  std::shared_ptr<const TopicDefinition> read_channel_metadata(
      MessageReader& reader, std::shared_ptr<const TopicDefinition> definition) {
    TopicDefinition all = definition ? *definition : TopicDefinition{};
    try {
      const auto bytes = reader.number<std::uint32_t>("channel's metadata");
      MessageReader map = MessageReader::packed(reader.take(bytes, "channel's metadata"));
      while (!map.rest().empty()) {
        const std::string_view key = map.string("key");
        const std::string_view value = map.string("value");
        if (key == "offered_qos_profiles") all.qos = value;
        if (key == "md5sum") all.md5 = value;
        if (key == "latching") all.latched = value == "1" || value == "true";
      }
    } catch (const ReadError&) {
      return definition;
    }
    all.latched = all.latched || is_latched_qos(all.qos);
    const bool says_more = !all.qos.empty() || !all.md5.empty() || all.latched;
    return says_more ? keep(std::move(all)) : definition;
  }

  void read_channel(std::span<const std::byte> body) {
    MessageReader reader = MessageReader::packed(body);
    const auto id = reader.number<std::uint16_t>("channel's number");
    const auto schema = reader.number<std::uint16_t>("channel's schema");
    if (channels_.count(id) > 0) return;  // repeated in every chunk
    Topic& topic = channels_[id];
    topic.name = reader.string("channel's topic").substr(0, kMostNameBytes);
    const std::string_view encoding = reader.string("channel's encoding");
    topic.encoding = encoding == "cdr"    ? MessageEncoding::cdr
                     : encoding == "ros1" ? MessageEncoding::ros1
                                          : MessageEncoding::other;
    const auto type = schemas_.find(schema);
    if (type != schemas_.end()) topic.definition = type->second;
    if (topic.definition) topic.type = plain_type_name(topic.definition->type);
    topic.definition = read_channel_metadata(reader, topic.definition);
    announce(topic);
  }

  std::optional<Message> read_message(LimitedStream& record) {
    std::array<std::byte, mcap::kMessageHead> bytes{};
    if (record.read(bytes) < bytes.size()) return std::nullopt;
    MessageReader reader = MessageReader::packed(bytes);
    const auto channel = channels_.find(reader.number<std::uint16_t>("channel"));
    (void)reader.number<std::uint32_t>("sequence");
    const auto time = [&reader] {
      return sane_time(static_cast<std::int64_t>(reader.number<std::uint64_t>("time")));
    };
    const std::int64_t logged_ns = time();
    const std::int64_t published_ns = time();
    if (channel == channels_.end()) {
      if (!lost_channel_) note("messages of a channel that was not announced are passed over");
      lost_channel_ = true;
      return std::nullopt;
    }
    if (!is_wanted(channel->second)) return std::nullopt;
    constexpr std::uint64_t kReadAhead = 1 << 16;
    std::optional<CompressedSource> source;
    if (chunk_ && chunk_->inside) source.emplace(CompressedSource{*chunk_->compressed, kReadAhead});
    const auto data =
        read_message_bytes(channel->second, record, source ? &*source : nullptr, message_);
    if (!data) return std::nullopt;
    std::optional<Message> message = plain_message(channel->second, logged_ns, *data);
    if (message) message->published_ns = published_ns;
    return message;
  }

  std::optional<Message> plain_message(const Topic& topic, std::int64_t logged_ns,
                                       std::span<const std::byte> data) {
    if (topic.encoding != MessageEncoding::cdr) return Message{&topic, logged_ns, data};
    const auto plain = compressed_.plain(data);
    if (plain) return Message{&topic, logged_ns, *plain};
    note_lost(topic, compressed_.problem());
    return std::nullopt;
  }

  void open_chunk(std::uint64_t length) {
    chunk_.emplace(data_, length);
    chunk_->number = chunks_++;
    std::array<std::byte, 8 + 8 + 8 + 4 + 4> bytes{};
    chunk_->record.read(bytes);
    MessageReader reader = MessageReader::packed(bytes);
    (void)reader.take(16, "chunk's times");
    chunk_->size = reader.number<std::uint64_t>("chunk's size");
    chunk_->crc = reader.number<std::uint32_t>("chunk's checksum");
    const auto name_bytes = reader.number<std::uint32_t>("length of the compression's name");
    if (name_bytes > kMostNameBytes) throw ReadError("its compression has no name");
    std::string name(name_bytes, '\0');
    chunk_->record.read(std::as_writable_bytes(std::span(name)));
    std::array<std::byte, 8> size{};
    chunk_->record.read(size);
    const std::optional<Compression> compression = compression_named(name);
    if (!compression) throw ReadError("its compression is '" + name + "'; expected lz4 or zstd");
    const bool plain = *compression == Compression::none;
    const ChunkEnd end = find_end(load<std::uint64_t>(size.data(), false), plain);
    chunk_->compressed.emplace(chunk_->record, end.content);
    if (plain) {
      chunk_->content.emplace(*chunk_->compressed);
      return;
    }
    chunk_->inside = decompress(*compression, *chunk_->compressed);
    if (end.has_tail) chunk_->announced.emplace(*chunk_->inside, chunk_->size);
    chunk_->content.emplace(end.has_tail ? static_cast<ByteStream&>(*chunk_->announced)
                                         : *chunk_->inside);
  }

  /// Bytes of a chunk's content, and whether something may follow it within the record.
  struct ChunkEnd {
    std::uint64_t content = 0;
    bool has_tail = false;
  };

  // A chunk says twice how long it is, `inside` and by its record's length; where they differ, one
  // is right that another record follows. Behind the content a record may have fields that later
  // versions add.
  ChunkEnd find_end(std::uint64_t inside, bool plain) {
    const std::uint64_t record = chunk_->record.left();
    const std::uint64_t size = chunk_->size;
    if (inside == record) return {inside, false};
    constexpr std::uint64_t kLongestTail = 1 << 16;
    const bool has_tail = inside < record && record - inside <= kLongestTail;
    const bool can_be = plain ? inside == size : inside <= size + kLongestFrame;
    const bool record_fits = is_followed(record);
    if (can_be && (is_followed(inside) || (!record_fits && !has_tail))) {
      note_length(record, inside, "latter");
      chunk_->record.set_left(inside);
      return {inside, false};
    }
    if (!record_fits) return {inside, false};
    if (!has_tail) note_length(record, inside, "former");
    return {plain ? std::min(size, record) : record, true};
  }

  // Whether two records of known or private kinds lie so many bytes further on, as far as the file
  // goes, and it is not too far.
  bool is_followed(std::uint64_t offset) {
    constexpr std::uint64_t kFarthest = 64 << 20;
    for (int i = 0; i < 2; ++i) {
      if (offset > kFarthest) return i > 0;
      std::array<std::byte, 9> bytes{};
      const std::size_t got = ahead_.peek(offset, bytes);
      if (got == 0 && i > 0) return ahead_.peek(offset - 1, std::span(bytes).first(1)) == 1;
      const auto opcode = static_cast<Opcode>(bytes[0]);
      const auto length = load<std::uint64_t>(bytes.data() + 1, false);
      if (got < bytes.size() || !is_kind(opcode) || length > kLongestRecord) return false;
      if (opcode == Opcode::footer) return true;
      offset += bytes.size() + length;
    }
    return true;
  }

  static bool is_kind(Opcode opcode) {
    constexpr auto kPrivate = static_cast<Opcode>(0x80);
    return (opcode >= Opcode::header && opcode <= Opcode::data_end) || opcode >= kPrivate;
  }

  void note_length(std::uint64_t record, std::uint64_t inside, const char* believed) {
    note("the record of chunk " + std::to_string(chunk_->number) + " has " +
         std::to_string(record) + " bytes left for its content of " + std::to_string(inside) +
         ": the " + believed + " is believed");
  }

  // A chunk that is cut with the file has no checksum to be compared.
  void finish_chunk() {
    const std::uint64_t size = chunk_->content->size();
    const std::string name = "chunk " + std::to_string(chunk_->number);
    if (chunk_->is_cut()) {
      // The end of the file is noted once it is met.
    } else if (size != chunk_->size) {
      note(name + " holds " + std::to_string(size) + " bytes where " +
           std::to_string(chunk_->size) + " were announced: messages are lost");
    } else if (chunk_->crc != 0 && chunk_->content->crc() != chunk_->crc) {
      note("the checksum of " + name + " differs: its messages may be damaged");
    }
    leave_chunk();
  }

  void check_data(std::span<const std::byte> body, std::uint32_t crc) {
    const auto expected = MessageReader::packed(body).number<std::uint32_t>("checksum");
    if (expected != 0 && expected != crc) {
      note("the checksum of the whole data differs: some of it may be damaged");
    }
  }

  std::unique_ptr<ByteStream> file_;
  LookAheadStream ahead_;
  ChecksumStream data_;
  std::optional<OpenChunk> chunk_;
  std::string profile_;
  std::map<std::uint16_t, std::shared_ptr<const TopicDefinition>> schemas_;
  std::map<std::uint16_t, Topic> channels_;
  std::vector<std::byte> body_;
  std::vector<std::byte> message_;
  CompressedMessages compressed_;
  std::size_t chunks_ = 0;
  bool lost_channel_ = false;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> read_mcap(std::unique_ptr<ByteStream> file) {
  return std::make_unique<McapReader>(std::move(file));
}

}  // namespace surefoot::io
