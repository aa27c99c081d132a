// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "live/topic_source.hpp"
#include "ros1/node.hpp"

namespace surefoot::ros1 {

/// A topic's messages, whatever it is of: the first one tells its type, and is waited for. `say` is
/// told what is waited for; it may be empty.
[[nodiscard]] std::unique_ptr<live::TopicSource> subscribe(
    std::shared_ptr<Node> node, const std::string& topic,
    std::function<void(const std::string&)> say);

}  // namespace surefoot::ros1
