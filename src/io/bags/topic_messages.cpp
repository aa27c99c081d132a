// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/topic_messages.hpp"

#include "io/bags/bag_files.hpp"

namespace surefoot::io {

TopicMessages::TopicMessages(std::filesystem::path bag)
    : path_(std::move(bag)), bag_(open_bag(path_)) {}

void TopicMessages::begin(const Topic& topic) {
  format_ = bag_->format();  // known once something was read
  topic_ = topic;
  if (!bag_->rewind()) bag_ = open_bag(path_);
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
