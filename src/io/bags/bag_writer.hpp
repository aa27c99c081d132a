// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "io/messages/message_definitions.hpp"
#include "io/messages/message_writer.hpp"

namespace surefoot::io {

/// Writes messages to a bag of any kind, from front to back.
class BagWriter {
 public:
  virtual ~BagWriter() = default;
  /// The topic's number. Listeners' topics keep it where they are added again; a bag has each once.
  virtual std::size_t add_topic(const std::string& name, const MessageDefinition& definition) = 0;
  /// `message` in the flavour of the bag.
  virtual void write(std::size_t topic, std::int64_t stamp_ns, std::string_view message) = 0;
  /// With when it was published, where the format has room for it.
  virtual void write_published(std::size_t topic, std::int64_t stamp_ns,
                               std::int64_t /*published_ns*/, std::string_view message) {
    write(topic, stamp_ns, message);
  }
  /// A file to go with the messages, where the format has room for one.
  virtual void attach(std::string_view /*name*/, std::string_view /*media_type*/,
                      std::string_view /*content*/) {}
  /// Throws WriteError where something could not be written.
  virtual void finish() = 0;
  /// Whether who comes late gets what was written before: what never changes is written once.
  [[nodiscard]] virtual bool is_latched() const { return false; }
  [[nodiscard]] virtual MessageWriter::Flavour flavour() const {
    return MessageWriter::Flavour::cdr;
  }
};

/// MCAP with the profile ros2, chunks compressed with Zstandard. All throw WriteError.
[[nodiscard]] std::unique_ptr<BagWriter> make_mcap_bag(const std::filesystem::path& file);
/// A folder as rosbag2 makes it: one sqlite3 file and metadata.yaml.
[[nodiscard]] std::unique_ptr<BagWriter> make_sqlite_bag(const std::filesystem::path& folder);
/// A ROS 1 bag, version 2.0, indexed, not compressed.
[[nodiscard]] std::unique_ptr<BagWriter> make_ros1_bag(const std::filesystem::path& file);

}  // namespace surefoot::io
