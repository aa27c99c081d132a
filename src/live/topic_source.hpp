// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a live run's messages come from.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/bags/message_source.hpp"
#include "io/messages/message_definitions.hpp"
#include "io/recording.hpp"
#include "live/datagram_source.hpp"

namespace surefoot::live {

struct TopicArrival {
  std::vector<std::byte> bytes;  ///< in the topic's encoding
  std::int64_t arrival_ns = 0;   ///< since 1970
  std::chrono::steady_clock::time_point received;
};

class TopicSource {
 public:
  virtual ~TopicSource() = default;

  /// Waits a tenth of a second at most, or asks several times in that what ask() gave. Throws
  /// io::ReadError where the topic holds no scans.
  [[nodiscard]] virtual Received receive(TopicArrival& arrival) = 0;
  /// Whom to ask whether it is worth waiting, before each receive().
  virtual void ask(const std::function<bool()>& /*go_on*/) {}
  /// Known once something was received.
  [[nodiscard]] virtual const io::Topic& topic() const = 0;
  /// Of its type, for who records it: for ROS 2 clouds' alone, which no reader of ours asks for.
  [[nodiscard]] virtual io::MessageDefinition definition() const {
    const io::MessageDefinition cloud = io::point_cloud2_definition();
    return topic().type == cloud.type ? cloud : io::MessageDefinition{topic().type, "", "", ""};
  }
  /// Messages that were sent but lost before they could be received.
  [[nodiscard]] virtual std::uint64_t lost() const { return 0; }
  [[nodiscard]] virtual bool patient() const { return false; }
  /// What is known of the sensor whose packets the messages hold, as Ouster's metadata.
  [[nodiscard]] virtual std::string calibration() const { return {}; }
  /// "ROS 2 topic /velodyne_points".
  [[nodiscard]] virtual std::string name() const = 0;
  /// What there is instead of the topic, for messages; empty where that is not known.
  [[nodiscard]] virtual std::string others() const { return {}; }
};

/// A bag's topic. @param speed times its own; 0: as fast as it is taken. Throws io::ReadError.
[[nodiscard]] std::unique_ptr<TopicSource> replay_bag(const std::filesystem::path& path,
                                                      const io::OpenOptions& options, double speed);

/// The topic of a bag (MCAP, ROS 1) that is still written to: all that is there, as fast as it is
/// taken, then what comes. Throws io::ReadError.
[[nodiscard]] std::unique_ptr<TopicSource> follow_bag(const std::filesystem::path& file,
                                                      const io::OpenOptions& options);

}  // namespace surefoot::live
