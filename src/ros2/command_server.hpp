// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Commands of others: a service of std_srvs/Trigger for each, and a topic for who cannot call it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "live/command_queue.hpp"
#include "ros2/participant.hpp"

namespace surefoot::ros2 {

/// /surefoot/NAME for each command, as ROS 2's layer for Cyclone DDS calls services: who asked and
/// which of its requests it was go before the message, and come back before the answer. Layers for
/// other DDS put that elsewhere, so that none of them can call another's services; they write the
/// name to /surefoot/command (std_msgs/String), without an answer.
class CommandServer {
 public:
  using Handler = std::function<live::CommandAnswer(const std::string& command)>;
  /// `handler` is called on a thread of its own. Throws std::runtime_error.
  CommandServer(std::shared_ptr<Participant> participant, const std::vector<std::string>& commands,
                Handler handler);
  ~CommandServer();
  CommandServer(const CommandServer&) = delete;
  CommandServer& operator=(const CommandServer&) = delete;

 private:
  struct Service {
    std::string command;
    Participant::Endpoint requests, replies;
  };
  void serve();
  void answer(const Service& service, const std::vector<std::byte>& request) const;
  void obey(const std::vector<std::byte>& message) const;

  std::shared_ptr<Participant> participant_;
  Handler handler_;
  std::vector<Service> services_;
  Participant::Endpoint topic_;
  int waitset_ = 0;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace surefoot::ros2
