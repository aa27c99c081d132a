// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Commands of others: a service of std_srvs/Trigger for each.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "live/command_queue.hpp"
#include "ros1/node.hpp"

namespace surefoot::ros1 {

/// /surefoot/NAME for each command.
class TriggerServices {
 public:
  using Handler = std::function<live::CommandAnswer(const std::string& command)>;
  /// `handler` is called on a thread of its own. Throws std::runtime_error.
  TriggerServices(std::shared_ptr<Node> node, const std::vector<std::string>& commands,
                  Handler handler);
  ~TriggerServices();
  TriggerServices(const TriggerServices&) = delete;
  TriggerServices& operator=(const TriggerServices&) = delete;

 private:
  struct Servers;
  std::shared_ptr<Node> node_;
  Handler handler_;
  std::unique_ptr<Servers> servers_;
};

}  // namespace surefoot::ros1
