// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros1/topic_publisher.hpp"

#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "ros1/message_types.hpp"

namespace surefoot::ros1 {
namespace {

constexpr std::uint32_t kMostWaiting = 100;

bool is_latched_topic(std::string_view topic) {
  return topic == "/tf_static" || topic.ends_with("/path") || topic.ends_with("/local_map");
}

class TopicPublisher final : public io::BagWriter {
 public:
  explicit TopicPublisher(std::shared_ptr<Node> node) : node_(std::move(node)) {}

  std::size_t add_topic(const std::string& name, const io::MessageDefinition& definition) override {
    const auto [known, is_new] = numbers_.emplace(name, topics_.size());
    if (!is_new) return known->second;
    const MessageType type = message_type(definition.type);
    const bool latched = is_latched_topic(name);
    ros::AdvertiseOptions options(name, latched ? 1 : kMostWaiting, type.md5, type.name,
                                  type.definition);
    options.latch = latched;
    topics_.push_back({node_->handle().advertise(options), {}});
    topics_.back().message.morph(type.md5, type.name, type.definition, latched ? "1" : "0");
    return known->second;
  }

  void write(std::size_t topic, std::int64_t /*stamp_ns*/, std::string_view message) override {
    std::vector<std::uint8_t> bytes(message.begin(), message.end());
    ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    topics_.at(topic).message.read(stream);
    topics_.at(topic).publisher.publish(topics_.at(topic).message);
  }

  /// roscpp says nothing of what it has sent yet, and drops what it has not when it ends.
  void finish() override {
    const bool heard = std::any_of(topics_.begin(), topics_.end(), [](const Topic& topic) {
      return topic.publisher.getNumSubscribers() > 0;
    });
    if (heard) std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
  bool is_latched() const override { return true; }
  io::MessageWriter::Flavour flavour() const override { return io::MessageWriter::Flavour::ros1; }

 private:
  struct Topic {
    ros::Publisher publisher;
    topic_tools::ShapeShifter message;
  };
  std::shared_ptr<Node> node_;
  std::vector<Topic> topics_;
  std::map<std::string, std::size_t> numbers_;  ///< by topic
};

}  // namespace

std::unique_ptr<io::BagWriter> publish(std::shared_ptr<Node> node) {
  return std::make_unique<TopicPublisher>(std::move(node));
}

}  // namespace surefoot::ros1
