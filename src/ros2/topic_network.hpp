// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "live/topic_network.hpp"
#include "ros2/participant.hpp"

namespace surefoot::ros2 {

/// Takes part in a domain. `reliable`: how topics are read. Throws std::runtime_error.
[[nodiscard]] std::unique_ptr<live::TopicNetwork> join_domain(const ParticipantOptions& options,
                                                              bool reliable);

}  // namespace surefoot::ros2
