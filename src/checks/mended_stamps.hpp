// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checks/scan_facts.hpp"
#include "io/recording.hpp"

namespace surefoot::checks {

/// Tells every scan its stamp as a run mends it, where that differs from the one that is stored.
void mend_stamps(std::vector<ScanFacts>& scans, const io::OpenOptions& options);

}  // namespace surefoot::checks
