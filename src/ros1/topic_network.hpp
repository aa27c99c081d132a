// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "live/topic_network.hpp"
#include "ros1/node.hpp"

namespace surefoot::ros1 {

/// Throws std::runtime_error where no master answers.
[[nodiscard]] std::unique_ptr<live::TopicNetwork> join_master(const NodeOptions& options);

}  // namespace surefoot::ros1
