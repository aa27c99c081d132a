// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "io/bags/bag_writer.hpp"
#include "ros2/participant.hpp"

namespace surefoot::ros2 {

/// Messages to topics as to a bag, so that who records a run and who listens to it get the same.
/// A thread of its own sends them: nobody who listens slowly holds up a run, or other topics. Where
/// too many of a topic wait its oldest is left out.
[[nodiscard]] std::unique_ptr<io::BagWriter> publish(std::shared_ptr<Participant> participant);

}  // namespace surefoot::ros2
