// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros1/topic_subscription.hpp"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <optional>
#include <utility>

#include "io/messages/cloud_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::ros1 {
namespace {

using Clock = std::chrono::steady_clock;
using Say = std::function<void(const std::string&)>;
using topic_tools::ShapeShifter;
constexpr double kLongestWait = 0.1;          // [s]
constexpr std::chrono::seconds kPatience(3);  // before it is said what is waited for
constexpr std::uint32_t kDepth = 100;         // what comes too fast waits here, or goes beyond it

bool is_readable(const std::string& type) {
  return io::is_cloud_type(type) || io::is_packet_type(type);
}

/// Messages come on the thread that asks for them: roscpp's queue is worked on there alone.
class TopicSubscription final : public live::TopicSource {
 public:
  TopicSubscription(std::shared_ptr<Node> node, const std::string& topic, Say say)
      : node_(std::move(node)),
        topic_{ros::names::resolve(topic), {}, io::MessageEncoding::ros1},
        say_(std::move(say)),
        begun_(Clock::now()) {
    ros::SubscribeOptions terms = ros::SubscribeOptions::create<ShapeShifter>(
        topic_.name, kDepth, [this](const ShapeShifter::ConstPtr& message) { take(*message); },
        ros::VoidPtr(), &queue_);
    terms.transport_hints = ros::TransportHints().tcpNoDelay();
    subscriber_ = node_->handle().subscribe(terms);
  }

  live::Received receive(live::TopicArrival& arrival) override {
    if (!taken_) queue_.callOne(ros::WallDuration(kLongestWait));
    if (!taken_) {
      if (!said_ && topic_.type.empty() && Clock::now() - begun_ > kPatience) {
        say_once("nobody publishes it yet" + others());
      }
      return live::Received::nothing;
    }
    if (!is_readable(topic_.type)) {
      throw io::ReadError(name() + ": it is a " + text::printable(topic_.type) +
                          ", of which no scans can be made" + others());
    }
    arrival = std::move(*taken_);
    taken_.reset();
    return live::Received::something;
  }

  const io::Topic& topic() const override { return topic_; }
  io::MessageDefinition definition() const override { return definition_; }
  std::string name() const override { return "ROS 1 topic " + topic_.name; }

  std::string others() const override {
    std::string text;
    for (const auto& [topic, type] : Node::topics()) {
      if (!is_readable(type)) continue;
      text += "\n  " + text::printable(topic) + " (" + text::printable(type) + ")";
    }
    if (text.empty()) return "; no topic that scans can be made of is there";
    return "; topics that scans can be made of:" + text;
  }

 private:
  void take(const ShapeShifter& message) {
    if (topic_.type.empty()) {
      topic_.type = message.getDataType();
      definition_ = {topic_.type, {}, message.getMessageDefinition(), message.getMD5Sum()};
    }
    taken_.emplace();
    taken_->received = Clock::now();
    taken_->arrival_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                             std::chrono::system_clock::now().time_since_epoch())
                             .count();
    taken_->bytes.resize(message.size());
    ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(taken_->bytes.data()),
                                       message.size());
    message.write(stream);
  }

  void say_once(const std::string& text) {
    if (!std::exchange(said_, true) && say_) say_(name() + ": " + text);
  }

  std::shared_ptr<Node> node_;
  io::Topic topic_;  ///< its type is empty until something came
  Say say_;
  ros::CallbackQueue queue_;
  ros::Subscriber subscriber_;  ///< after the queue that it fills
  io::MessageDefinition definition_;
  std::optional<live::TopicArrival> taken_;
  Clock::time_point begun_;
  bool said_ = false;
};

}  // namespace

std::unique_ptr<live::TopicSource> subscribe(std::shared_ptr<Node> node, const std::string& topic,
                                             std::function<void(const std::string&)> say) {
  return std::make_unique<TopicSubscription>(std::move(node), topic, std::move(say));
}

}  // namespace surefoot::ros1
