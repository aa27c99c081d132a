// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "runs/map_outcome.hpp"
#include "runs/odometry_run.hpp"

namespace surefoot::app {

/// Where something begins in a map, in words.
std::string place_in_map(const Pose& begin);
/// Which frames the poses are in: the segments, what came of the loops, and whether the place in
/// the map was found, and when; a line or two each, of what there is.
void print_frames(const runs::RunOutcome& outcome);
/// Says on stderr where a map was to be continued and could not be; whether that is so.
bool say_if_apart(const runs::RunOutcome& outcome);

}  // namespace surefoot::app
