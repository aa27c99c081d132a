// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "live/topic_network.hpp"

namespace surefoot::app {

/// The flags of a network that a live run can be a part of, and how it is joined. `topics` must
/// live until the command line is parsed.
void add_ros1_options(CLI::App& command, live::TopicRequest& topics);
/// The domain is ROS_DOMAIN_ID's where none is given.
void add_ros2_options(CLI::App& command, live::TopicRequest& topics);

}  // namespace surefoot::app
