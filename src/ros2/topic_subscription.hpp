// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "live/topic_source.hpp"
#include "ros2/participant.hpp"

namespace surefoot::ros2 {

struct SubscriptionOptions {
  std::string topic;                            ///< "/velodyne_points"
  bool reliable = false;                        ///< else what comes, as sensors' data are read
  std::function<void(const std::string&)> say;  ///< what is waited for; may be empty
};

/// A topic's messages, whatever it is of: its type is taken from who publishes it, and waited for.
[[nodiscard]] std::unique_ptr<live::TopicSource> subscribe(std::shared_ptr<Participant> participant,
                                                           SubscriptionOptions options);

}  // namespace surefoot::ros2
