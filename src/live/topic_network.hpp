// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Others that a live run reads from, publishes to and obeys: ROS 1's or ROS 2's topics and
// services.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "live/command_queue.hpp"
#include "live/topic_source.hpp"

namespace surefoot::live {

class TopicNetwork {
 public:
  using Handler = std::function<CommandAnswer(const std::string& command)>;
  virtual ~TopicNetwork() = default;

  /// A topic's messages. `say` is told what is waited for; it may be empty.
  [[nodiscard]] virtual std::unique_ptr<TopicSource> subscribe(
      const std::string& topic, std::function<void(const std::string&)> say) = 0;
  /// Messages to topics as to a bag.
  [[nodiscard]] virtual std::unique_ptr<io::BagWriter> publisher() = 0;
  /// A service for each command, as long as this lives; `handler` is called on a thread of its own.
  /// Throws std::runtime_error.
  virtual void serve(const std::vector<std::string>& commands, Handler handler) = 0;
};

/// What a run does there.
struct TopicRequest {
  std::string topic;     ///< of scans or of a sensor's packets; empty: none is read
  bool publish = false;  ///< all that the run has to say
  bool commands = false;
  std::string network;    ///< "ros2", as in names of options and runs; empty: there is none
  std::string extension;  ///< ".mcap": of what its messages are recorded in
  std::function<std::unique_ptr<TopicNetwork>()> join;  ///< throws std::runtime_error

  [[nodiscard]] bool any() const { return !topic.empty() || publish || commands; }
};

}  // namespace surefoot::live
