// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "runs/map_outcome.hpp"

namespace surefoot::app {

/// What came of the loops, in a line or two.
void print_map_outcome(const runs::MapOutcome& outcome);
/// Whether the place in the map was found, and when.
void print_localization(const runs::LocalizationOutcome& outcome);

}  // namespace surefoot::app
