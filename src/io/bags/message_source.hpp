// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a bag is to its readers: messages from front to back, whatever they are stored in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bags/byte_stream.hpp"
#include "io/saturated.hpp"

namespace surefoot::io {

/// Longer names of topics and types are cut: no bag has any.
inline constexpr std::size_t kMostNameBytes = 4096;

enum class MessageEncoding { cdr, ros1, other };

/// How a bag defines a type, and what it says of a topic: for who copies messages as they are.
struct TopicDefinition {
  std::string type;      ///< as the bag spells it: "sensor_msgs/msg/PointCloud2"
  std::string text;      ///< of the type and those that it refers to; empty: not known
  std::string language;  ///< of the text: "ros2msg", "ros2idl"
  std::string md5;       ///< ROS 1's
  std::string qos;       ///< rosbag2's YAML of what was offered
  bool latched = false;  ///< who comes late gets the last message, too
};

/// Whether a topic's YAML of rosbag2's says that who comes late gets its last messages.
[[nodiscard]] bool is_latched_qos(std::string_view qos);

struct Topic {
  std::string name;
  std::string type;  ///< "sensor_msgs/PointCloud2", for ROS 2 as well
  MessageEncoding encoding = MessageEncoding::other;
  std::shared_ptr<const TopicDefinition> definition = {};  ///< may be null
};

struct Message {
  const Topic* topic = nullptr;                   ///< never null; lives as long as its source
  std::int64_t logged_ns = 0;                     ///< when it was recorded
  std::span<const std::byte> bytes;               ///< until the next call of next()
  std::optional<std::int64_t> published_ns = {};  ///< where the bag says it, too
};

/// What a bag may hold besides messages, and is passed over.
struct PassedOver {
  std::size_t attachments = 0, metadata = 0;
};

struct CompressedSource;

class MessageSource {
 public:
  virtual ~MessageSource() = default;
  /// The next message, or nothing at the end. Damaged parts are passed over, with a note. Throws
  /// ReadError where nothing can be read at all.
  [[nodiscard]] virtual std::optional<Message> next() = 0;
  /// Begins anew where that is cheaper than opening it again; false where it is not.
  virtual bool rewind() { return false; }
  /// Share that was read, 0..1.
  [[nodiscard]] virtual double progress() const = 0;
  /// "MCAP (ros2)", "ROS 1 bag", ...
  [[nodiscard]] virtual std::string format() const = 0;
  /// What was damaged or passed over, one sentence each. Grows while reading.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Those of the notes that tell of damage.
  [[nodiscard]] const std::vector<std::string>& losses() const { return losses_; }
  /// The topics that the bag has said it has, so far, with messages or without.
  [[nodiscard]] const std::vector<Topic>& announced() const { return announced_; }
  /// Messages that were come across so far, of whatever topic, and since the last rewind.
  [[nodiscard]] std::uint64_t met() const { return met_; }
  [[nodiscard]] const PassedOver& passed_over() const { return passed_over_; }
  /// Whether messages come about in the order that they were recorded in, over all files: so does
  /// what rosbag2 split.
  [[nodiscard]] virtual bool is_in_order_of_time() const { return false; }
  /// Leaves the rest of a file for the next one, which may be of the same time; false where there
  /// is none, and where it cannot be.
  virtual bool leave_file() { return false; }
  /// From here on messages of one topic alone are needed.
  void want(std::string topic) { wanted_ = std::move(topic); }

 protected:
  [[nodiscard]] const std::string& wanted() const { return wanted_; }
  /// Counts a message; whether it is needed.
  [[nodiscard]] bool is_wanted(const Topic& topic) {
    ++met_;
    return wanted_.empty() || topic.name == wanted_;
  }
  void begin_anew() { met_ = 0; }
  void set_passed_over(const PassedOver& all) { passed_over_ = all; }
  /// Adds a note, once, and unless there are too many already: of damage, or not.
  void note(std::string_view text);
  void note_harmless(std::string_view text);
  /// Adds a topic, once.
  void announce(const Topic& topic);
  /// A definition to keep; without its texts where all of a bag take more memory than they may.
  [[nodiscard]] std::shared_ptr<const TopicDefinition> keep(TopicDefinition definition);
  /// A message's bytes; nothing where it is too large or, decompressed while it is read (`source`
  /// is not null), too dense, or ends early, as `record` then shows. The former are noted.
  [[nodiscard]] std::optional<std::span<const std::byte>> read_message_bytes(
      const Topic& topic, LimitedStream& record, const CompressedSource* source,
      std::vector<std::byte>& buffer);
  /// Notes why a message is passed over.
  void note_lost(const Topic& topic, std::string_view why);

 private:
  std::string wanted_;
  std::uint64_t met_ = 0;
  PassedOver passed_over_;
  std::size_t definition_bytes_ = 0;
  std::vector<std::string> notes_, losses_;
  std::vector<Topic> announced_;
};

/// Larger messages are passed over: no sweep of a LiDAR is of this size [bytes].
inline constexpr std::uint64_t kMostMessageBytes = 256 << 20;

/// One name for a type however a bag spells it: "sensor_msgs/msg/PointCloud2" and
/// "sensor_msgs::msg::dds_::PointCloud2_" are "sensor_msgs/PointCloud2".
[[nodiscard]] std::string plain_type_name(std::string_view name);

}  // namespace surefoot::io
