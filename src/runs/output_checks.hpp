// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "runs/run_options.hpp"

namespace surefoot::runs {

/// Whether a run's files can go where they are to go, without harm to what is there. Throws
/// std::runtime_error that names what is in the way.
void check_outputs(const RunOptions& options);

}  // namespace surefoot::runs
