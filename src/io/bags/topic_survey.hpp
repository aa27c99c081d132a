// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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
  std::int64_t first_ns = 0;  ///< when they were recorded
  std::int64_t last_ns = 0;
  std::string frame;
  std::string content;  ///< "28800 points: x f32, ...", or why it is not usable

  [[nodiscard]] double rate_hz() const;
};

struct BagSurvey {
  std::vector<TopicSurvey> topics;  ///< in the order they appear
  std::string calibration;          ///< a sensor's metadata that is in the bag, as Ouster's
};

/// A bag's first seconds, or all that comes until there is a topic that scans can be made of: the
/// one that is asked for, where one is.
[[nodiscard]] BagSurvey survey_topics(MessageSource& bag, const OpenOptions& options);

/// The topic to read: the one that is asked for, or the only usable one. Throws ReadError that
/// lists the topics where there is none, or several; `bag` is its name as it was given.
[[nodiscard]] const TopicSurvey& choose_topic(const std::vector<TopicSurvey>& topics,
                                              const std::string& asked, const std::string& bag);

}  // namespace surefoot::io
