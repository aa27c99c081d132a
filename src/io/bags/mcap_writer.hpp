// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bags/compression.hpp"
#include "io/bags/mcap_format.hpp"

namespace surefoot::io {

/// What a file holds besides its messages; the defaults are what readers like best.
struct McapOptions {
  std::string profile = "ros2";
  std::string library = "surefoot";
  bool chunks = true;
  std::uint64_t chunk_bytes = 1 << 20;
  Compression compression = Compression::zstd;  ///< of chunks
  bool message_index = true;
  bool chunk_index = true;
  bool attachment_index = true;
  bool metadata_index = true;
  bool statistics = true;
  bool repeated_schemas = true;
  bool repeated_channels = true;
  bool summary_offsets = true;
  /// Put at the end of every record outside of chunks that may have it: readers must pass over what
  /// they do not know.
  std::string record_tail;
};

/// Writes an MCAP file from front to back (mcap.dev/spec), with every checksum. The file grows
/// chunk by chunk: whatever ends the program leaves the chunks before it readable.
class McapWriter {
 public:
  using Metadata = std::vector<std::pair<std::string, std::string>>;

  /// Throws WriteError naming the file where it cannot be made.
  McapWriter(const std::filesystem::path& file, McapOptions options);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// The schema's number. Schemas and channels count from 1.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view data);
  /// The channel's number. `schema`: 0 for none.
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                            const Metadata& metadata = {});
  void write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time,
             std::uint64_t publish_time, std::string_view data);
  void attach(std::uint64_t log_time, std::uint64_t create_time, std::string_view name,
              std::string_view media_type, std::string_view data);
  void add_metadata(std::string_view name, const Metadata& metadata);
  /// Ends the file; throws WriteError where something could not be written.
  void finish();

 private:
  struct Chunk {
    std::string records;
    std::uint64_t start_time = 0;
    std::uint64_t end_time = 0;
    bool any_message = false;
    std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;
  };

  void put(std::string_view bytes);
  [[noreturn]] void fail() const;
  void put_record(mcap::Opcode opcode, std::string body, bool may_have_tail = true);
  [[nodiscard]] std::string record(mcap::Opcode opcode, std::string body, bool may_have_tail) const;
  void put_data(mcap::Opcode opcode, const std::string& body, bool may_have_tail);
  void finish_chunk();
  void put_group(mcap::Opcode opcode, const std::vector<std::string>& bodies);
  [[nodiscard]] std::string statistics() const;
  void put_footer(std::uint64_t summary_start, std::uint64_t offsets_start);

  std::filesystem::path path_;
  McapOptions options_;
  std::ofstream file_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;  ///< of the section that is being written
  Chunk chunk_;
  std::vector<std::string> schemas_, channels_, chunk_indexes_, attachment_indexes_,
      metadata_indexes_, summary_offsets_;  ///< contents of records
  std::map<std::uint16_t, std::uint64_t> message_counts_;
  std::uint64_t messages_ = 0;
  std::uint64_t start_time_ = 0;
  std::uint64_t end_time_ = 0;
  std::uint32_t attachments_ = 0;
  std::uint32_t metadata_ = 0;
  std::uint32_t chunks_ = 0;
  bool finished_ = false;
};

}  // namespace surefoot::io
