// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/bags/topic_messages.hpp"
#include "io/recording.hpp"

namespace surefoot::io {

/// What is the same for the recordings of any topic.
struct TopicRecordingParts {
  std::string bag;  ///< its name as it was given, for messages
  TopicMessages messages;
  std::vector<std::string> notes;  ///< what was found out already
  std::vector<Topic> seen;         ///< topics that could be chosen from
  bool others_are_read = false;    ///< by somebody else

  /// A note on topics with scans that the bag announced too late to be chosen from, at its end.
  void note_late_topics();
};

/// Scans of messages that hold one each. Throws ReadError where none of the first ones can be used.
[[nodiscard]] std::unique_ptr<Recording> open_cloud_topic(TopicRecordingParts parts,
                                                          const Topic& topic,
                                                          const OpenOptions& options);

/// Scans of messages that hold a sensor's packets; `calibration`: what the bag holds of the sensor.
[[nodiscard]] std::unique_ptr<Recording> open_packet_topic(TopicRecordingParts parts,
                                                           const Topic& topic,
                                                           const OpenOptions& options,
                                                           std::string calibration);

}  // namespace surefoot::io
