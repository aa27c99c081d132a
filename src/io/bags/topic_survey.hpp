// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "io/bags/message_source.hpp"
#include "io/recording.hpp"

namespace surefoot::io {

/// A topic of a bag, and what its first message showed where scans can be made of it.
struct TopicSurvey {
  Topic topic;
  bool usable = false;
  std::size_t messages = 0;   ///< of those that were looked at
  std::size_t tried = 0;      ///< of them, whether scans can be made of them
  std::int64_t first_ns = 0;  ///< when they were recorded
  std::int64_t last_ns = 0;
  std::string frame;
  std::string content;  ///< "28800 points: x f32, ...", or why it is not usable

  [[nodiscard]] double rate_hz() const;
};

struct BagSurvey {
  std::vector<TopicSurvey> topics;  ///< in the order they appear
  /// What sensors say about themselves, as Ousters do, by the topic that it is on.
  std::map<std::string, std::string> metadata;

  /// Of the topics with metadata the one whose name begins most as this one's does; empty: there is
  /// none.
  [[nodiscard]] std::string metadata_topic_for(const std::string& topic) const;
  /// What it says; empty: there is none.
  [[nodiscard]] std::string metadata_for(const std::string& topic) const;
};

/// A bag's first seconds from its first cloud or packets on, or all that comes until there is a
/// topic that scans can be made of: the one that is asked for, where one is. Packets may lie before
/// their sensor's metadata.
[[nodiscard]] BagSurvey survey_topics(MessageSource& bag, const OpenOptions& options);

/// The topic to read: the one that is asked for, or the only usable one. Throws ReadError that
/// lists the topics where there is none, or several; `bag` is its name as it was given.
[[nodiscard]] const TopicSurvey& choose_topic(const std::vector<TopicSurvey>& topics,
                                              const std::string& asked, const std::string& bag);

}  // namespace surefoot::io
