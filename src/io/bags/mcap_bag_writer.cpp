// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/bags/bag_writer.hpp"
#include "io/bags/mcap_writer.hpp"

namespace surefoot::io {
namespace {

class McapBag final : public BagWriter {
 public:
  explicit McapBag(const std::filesystem::path& file) : writer_(file, McapOptions{}) {}

  std::size_t add_topic(const std::string& name, const MessageDefinition& definition) override {
    // rosbag2 leaves the language away, too, where it does not know a type's text.
    const std::string& text = definition.ros2_text;
    const std::uint16_t schema = writer_.add_schema(
        definition.ros2_type(), text.empty() ? "" : definition.ros2_language, text);
    // rosbag2 looks for the key.
    return writer_.add_channel(schema, name, "cdr", {{"offered_qos_profiles", definition.qos}});
  }

  void write(std::size_t topic, std::int64_t stamp_ns, std::string_view message) override {
    write_published(topic, stamp_ns, stamp_ns, message);
  }

  void write_published(std::size_t topic, std::int64_t stamp_ns, std::int64_t published_ns,
                       std::string_view message) override {
    // MCAP's times are not negative.
    const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(stamp_ns, 0));
    const auto published = static_cast<std::uint64_t>(std::max<std::int64_t>(published_ns, 0));
    writer_.write(static_cast<std::uint16_t>(topic), sequence_++, time, published, message);
    last_ = std::max(last_, time);
  }

  void attach(std::string_view name, std::string_view media_type,
              std::string_view content) override {
    writer_.attach(last_, last_, name, media_type, content);
  }

  void finish() override { writer_.finish(); }

 private:
  McapWriter writer_;
  std::uint32_t sequence_ = 0;
  std::uint64_t last_ = 0;
};

}  // namespace

std::unique_ptr<BagWriter> make_mcap_bag(const std::filesystem::path& file) {
  return std::make_unique<McapBag>(file);
}

}  // namespace surefoot::io
