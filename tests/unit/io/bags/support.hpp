// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/bags/message_source.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io::test {

struct ReadMessage {
  std::string topic;
  std::string type;
  std::int64_t logged_ns;
  std::string data;
  bool operator==(const ReadMessage&) const = default;
};

inline void PrintTo(const ReadMessage& message, std::ostream* out) {
  *out << message.topic << " " << message.logged_ns << " (" << message.data.size() << " bytes)";
}

inline std::vector<ReadMessage> read_all_messages(MessageSource& source) {
  std::vector<ReadMessage> messages;
  while (const auto message = source.next()) {
    messages.push_back(
        {message->topic->name,
         message->topic->type,
         message->logged_ns,
         {reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size()}});
  }
  return messages;
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace surefoot::io::test
