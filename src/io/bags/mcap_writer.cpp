// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/mcap_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

using mcap::Opcode;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

void append_string(std::string& out, std::string_view text) {
  append_bytes(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

void append_map(std::string& out, const McapWriter::Metadata& map) {
  std::string entries;
  for (const auto& [key, value] : map) {
    append_string(entries, key);
    append_string(entries, value);
  }
  append_string(out, entries);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& file, McapOptions options)
    : path_(file), options_(std::move(options)), file_(file, std::ios::binary) {
  if (!file_) fail();
  put(mcap::kMagic);
  std::string body;
  append_string(body, options_.profile);
  append_string(body, options_.library);
  put_record(Opcode::header, std::move(body));
}

McapWriter::~McapWriter() {
  try {
    finish();
  } catch (const WriteError&) {  // finish() by hand tells it
  }
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding,
                                     std::string_view data) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  std::string body;
  append_bytes(body, id);
  append_string(body, name);
  append_string(body, encoding);
  append_string(body, data);
  put_data(Opcode::schema, body, true);
  schemas_.push_back(std::move(body));
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic,
                                      std::string_view encoding, const Metadata& metadata) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  std::string body;
  append_bytes(body, id);
  append_bytes(body, schema);
  append_string(body, topic);
  append_string(body, encoding);
  append_map(body, metadata);
  put_data(Opcode::channel, body, true);
  channels_.push_back(std::move(body));
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time,
                       std::uint64_t publish_time, std::string_view data) {
  std::string body;
  body.reserve(mcap::kMessageHead + data.size());
  append_bytes(body, channel);
  append_bytes(body, sequence);
  append_bytes(body, log_time);
  append_bytes(body, publish_time);
  body += data;
  if (options_.chunks) chunk_.index[channel].emplace_back(log_time, chunk_.records.size());
  put_data(Opcode::message, body, false);
  chunk_.start_time = chunk_.any_message ? std::min(chunk_.start_time, log_time) : log_time;
  chunk_.end_time = chunk_.any_message ? std::max(chunk_.end_time, log_time) : log_time;
  chunk_.any_message = true;
  start_time_ = messages_ == 0 ? log_time : std::min(start_time_, log_time);
  end_time_ = std::max(end_time_, log_time);
  ++messages_;
  ++message_counts_[channel];
  if (options_.chunks && chunk_.records.size() >= options_.chunk_bytes) finish_chunk();
}

void McapWriter::attach(std::uint64_t log_time, std::uint64_t create_time, std::string_view name,
                        std::string_view media_type, std::string_view data) {
  finish_chunk();
  std::string body;
  append_bytes(body, log_time);
  append_bytes(body, create_time);
  append_string(body, name);
  append_string(body, media_type);
  append_bytes(body, static_cast<std::uint64_t>(data.size()));
  body += data;
  append_bytes(body, crc32(bytes_of(body)));
  const std::uint64_t offset = position_;
  put_record(Opcode::attachment, std::move(body));
  ++attachments_;
  if (!options_.attachment_index) return;
  std::string index;
  append_bytes(index, offset);
  append_bytes(index, position_ - offset);
  append_bytes(index, log_time);
  append_bytes(index, create_time);
  append_bytes(index, static_cast<std::uint64_t>(data.size()));
  append_string(index, name);
  append_string(index, media_type);
  attachment_indexes_.push_back(std::move(index));
}

void McapWriter::add_metadata(std::string_view name, const Metadata& metadata) {
  finish_chunk();
  std::string body;
  append_string(body, name);
  append_map(body, metadata);
  const std::uint64_t offset = position_;
  put_record(Opcode::metadata, std::move(body));
  ++metadata_;
  if (!options_.metadata_index) return;
  std::string index;
  append_bytes(index, offset);
  append_bytes(index, position_ - offset);
  append_string(index, name);
  metadata_indexes_.push_back(std::move(index));
}

// Schemas, channels and messages go into the chunk, where there are chunks, and have no tail there.
void McapWriter::put_data(Opcode opcode, const std::string& body, bool may_have_tail) {
  if (options_.chunks) {
    chunk_.records += record(opcode, body, false);
  } else {
    put_record(opcode, body, may_have_tail);
  }
}

void McapWriter::finish_chunk() {
  if (!options_.chunks || chunk_.records.empty()) return;
  const std::string compressed = compress(options_.compression, chunk_.records);
  const std::string name = options_.compression == Compression::zstd  ? "zstd"
                           : options_.compression == Compression::lz4 ? "lz4"
                                                                      : "";
  std::string body;
  append_bytes(body, chunk_.start_time);
  append_bytes(body, chunk_.end_time);
  append_bytes(body, static_cast<std::uint64_t>(chunk_.records.size()));
  append_bytes(body, crc32(bytes_of(chunk_.records)));
  append_string(body, name);
  append_bytes(body, static_cast<std::uint64_t>(compressed.size()));
  body += compressed;
  const std::uint64_t chunk_start = position_;
  put_record(Opcode::chunk, std::move(body), false);
  const std::uint64_t chunk_end = position_;
  std::string offsets;
  for (const auto& [channel, messages] : chunk_.index) {
    if (!options_.message_index) break;
    append_bytes(offsets, channel);
    append_bytes(offsets, position_);
    std::string entries;
    for (const auto& [time, offset] : messages) {
      append_bytes(entries, time);
      append_bytes(entries, offset);
    }
    std::string index;
    append_bytes(index, channel);
    append_string(index, entries);
    put_record(Opcode::message_index, std::move(index));
  }
  ++chunks_;
  if (options_.chunk_index) {
    std::string index;
    append_bytes(index, chunk_.start_time);
    append_bytes(index, chunk_.end_time);
    append_bytes(index, chunk_start);
    append_bytes(index, chunk_end - chunk_start);
    append_string(index, offsets);
    append_bytes(index, position_ - chunk_end);
    append_string(index, name);
    append_bytes(index, static_cast<std::uint64_t>(compressed.size()));
    append_bytes(index, static_cast<std::uint64_t>(chunk_.records.size()));
    chunk_indexes_.push_back(std::move(index));
  }
  chunk_ = {};
  file_.flush();
}

void McapWriter::finish() {
  if (finished_) return;
  finished_ = true;
  finish_chunk();
  std::string data_end;
  append_bytes(data_end, crc_);
  put_record(Opcode::data_end, std::move(data_end), false);
  crc_ = 0;
  const std::uint64_t summary_start = position_;
  if (options_.repeated_schemas) put_group(Opcode::schema, schemas_);
  if (options_.repeated_channels) put_group(Opcode::channel, channels_);
  if (options_.statistics) put_group(Opcode::statistics, {statistics()});
  put_group(Opcode::metadata_index, metadata_indexes_);
  put_group(Opcode::attachment_index, attachment_indexes_);
  put_group(Opcode::chunk_index, chunk_indexes_);
  const std::uint64_t offsets_start = options_.summary_offsets ? position_ : 0;
  const bool has_summary = position_ > summary_start;
  for (const std::string& offset : summary_offsets_) put_record(Opcode::summary_offset, offset);
  put_footer(has_summary ? summary_start : 0, offsets_start);
  put(mcap::kMagic);
  file_.close();
  if (!file_) fail();
}

void McapWriter::put_footer(std::uint64_t summary_start, std::uint64_t offsets_start) {
  // The summary's checksum is of all of it, and of the footer up to the checksum itself.
  std::string footer(1, static_cast<char>(Opcode::footer));
  append_bytes(footer, std::uint64_t{8 + 8 + 4});
  append_bytes(footer, summary_start);
  append_bytes(footer, offsets_start);
  append_bytes(footer, crc32(bytes_of(footer), crc_));
  put(footer);
}

void McapWriter::put_group(Opcode opcode, const std::vector<std::string>& bodies) {
  const std::uint64_t start = position_;
  for (const std::string& body : bodies) put_record(opcode, body);
  if (bodies.empty() || !options_.summary_offsets) return;
  std::string offset(1, static_cast<char>(opcode));
  append_bytes(offset, start);
  append_bytes(offset, position_ - start);
  summary_offsets_.push_back(std::move(offset));
}

std::string McapWriter::statistics() const {
  std::string body;
  append_bytes(body, messages_);
  append_bytes(body, static_cast<std::uint16_t>(schemas_.size()));
  append_bytes(body, static_cast<std::uint32_t>(channels_.size()));
  append_bytes(body, attachments_);
  append_bytes(body, metadata_);
  append_bytes(body, chunks_);
  append_bytes(body, start_time_);
  append_bytes(body, end_time_);
  std::string counts;
  for (const auto& [channel, count] : message_counts_) {
    append_bytes(counts, channel);
    append_bytes(counts, count);
  }
  append_string(body, counts);
  return body;
}

std::string McapWriter::record(Opcode opcode, std::string body, bool may_have_tail) const {
  if (may_have_tail) body += options_.record_tail;
  std::string bytes(1, static_cast<char>(opcode));
  append_bytes(bytes, static_cast<std::uint64_t>(body.size()));
  return bytes + body;
}

void McapWriter::put_record(Opcode opcode, std::string body, bool may_have_tail) {
  put(record(opcode, std::move(body), may_have_tail));
}

void McapWriter::fail() const {
  throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
}

void McapWriter::put(std::string_view bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) fail();
  crc_ = crc32(bytes_of(bytes), crc_);
  position_ += bytes.size();
}

}  // namespace surefoot::io
