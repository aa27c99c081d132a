// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/topic_messages.hpp"

namespace surefoot::io {

TopicMessages::TopicMessages(std::function<std::unique_ptr<MessageSource>()> open)
    : open_(std::move(open)), bag_(open_()) {}

void TopicMessages::begin(const Topic& topic) {
  format_ = bag_->format();  // known once something was read
  topic_ = topic;
  if (!bag_->rewind()) bag_ = open_();
  bag_->want(topic_.name);
}

std::optional<Message> TopicMessages::next() {
  std::optional<Message> message;
  do {
    message = bag_->next();
  } while (message && message->topic->type != topic_.type);
  return message;
}

std::string TopicMessages::description() const {
  return format_ + ", topic " + topic_.name + " (" + topic_.type + ")";
}

}  // namespace surefoot::io
