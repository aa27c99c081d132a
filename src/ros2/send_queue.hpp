// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace surefoot::ros2 {

/// Messages that wait to be sent, in the order in which they came. Where too many of a topic wait
/// its oldest goes, no other topic's: of a latched one, which everybody is to have, the newest
/// stays.
class SendQueue {
 public:
  struct Message {
    std::size_t topic = 0;
    std::string content;
  };

  /// @param most of this topic's that may wait, with this one.
  void add(Message message, std::size_t most) {
    const auto is_same = [&](const Message& other) { return other.topic == message.topic; };
    const auto waiting = std::count_if(messages_.begin(), messages_.end(), is_same);
    if (static_cast<std::size_t>(waiting) >= most) {
      messages_.erase(std::find_if(messages_.begin(), messages_.end(), is_same));
    }
    messages_.push_back(std::move(message));
  }

  [[nodiscard]] bool empty() const { return messages_.empty(); }

  /// Of a queue that is not empty.
  Message take_first() {
    Message first = std::move(messages_.front());
    messages_.pop_front();
    return first;
  }

 private:
  std::deque<Message> messages_;
};

}  // namespace surefoot::ros2
