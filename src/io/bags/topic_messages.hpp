// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// The messages of one topic of a bag, as often as they are wanted from the beginning.
class TopicMessages {
 public:
  /// Of a bag that `open` opens, as often as it is begun anew.
  explicit TopicMessages(std::function<std::unique_ptr<MessageSource>()> open);
  /// Of a source that can begin anew.
  explicit TopicMessages(std::unique_ptr<MessageSource> source) : bag_(std::move(source)) {}

  /// All of the bag, for a look at it.
  [[nodiscard]] MessageSource& bag() { return *bag_; }
  /// From here on the messages of this topic alone, from the first one.
  void begin(const Topic& topic);

  [[nodiscard]] std::optional<Message> next();
  [[nodiscard]] const Topic& topic() const { return topic_; }
  [[nodiscard]] double progress() const { return bag_->progress(); }
  [[nodiscard]] const std::vector<std::string>& notes() const { return bag_->notes(); }
  [[nodiscard]] const std::vector<std::string>& losses() const { return bag_->losses(); }
  /// "MCAP, profile ros2, topic /points (sensor_msgs/PointCloud2)".
  [[nodiscard]] std::string description() const;

 private:
  std::function<std::unique_ptr<MessageSource>()> open_;
  std::unique_ptr<MessageSource> bag_;
  std::string format_;
  Topic topic_;
};

}  // namespace surefoot::io
