// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "runs/map_outcome.hpp"
#include "runs/odometry_run.hpp"

namespace surefoot::app {

/// Where something begins in a map, in words.
std::string place_in_map(const Pose& begin);
/// What came of the loops, in a line or two.
void print_map_outcome(const runs::MapOutcome& outcome);
/// Says on stderr where a map was to be continued and could not be; whether that is so.
bool say_if_apart(const runs::RunOutcome& outcome);
/// Whether the place in the map was found, and when.
void print_localization(const runs::LocalizationOutcome& outcome);

}  // namespace surefoot::app
