// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "io/bags/bag_writer.hpp"
#include "ros1/node.hpp"

namespace surefoot::ros1 {

/// Messages to topics as to a bag, so that who records a run and who listens to it get the same.
/// roscpp sends them on a thread of its own, and leaves out the oldest where too many wait.
[[nodiscard]] std::unique_ptr<io::BagWriter> publish(std::shared_ptr<Node> node);

}  // namespace surefoot::ros1
