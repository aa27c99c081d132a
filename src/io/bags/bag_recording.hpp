// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/bags/topic_recordings.hpp"
#include "io/recording.hpp"

namespace surefoot::io {

/// The scans of one topic of a bag: ROS 1, ROS 2 (sqlite3, MCAP) or plain MCAP, one file or a
/// folder of its parts. Read from front to back once, after a look at its first seconds. A message
/// that cannot be used is an item without scan. Throws ReadError.
[[nodiscard]] std::unique_ptr<Recording> open_bag_recording(const std::filesystem::path& path,
                                                            const OpenOptions& options);

/// What that reads: the topic that is asked for, or the only one, and what the bag has of its
/// sensor.
struct BagTopic {
  TopicRecordingParts parts;
  Topic topic;
  std::string calibration;
};
/// Throws ReadError.
[[nodiscard]] BagTopic open_bag_topic(const std::filesystem::path& path,
                                      const OpenOptions& options);
/// Of messages that are not opened by a path. `name`: what they are called.
[[nodiscard]] BagTopic open_bag_topic(TopicMessages messages, const std::string& name,
                                      const OpenOptions& options);

}  // namespace surefoot::io
