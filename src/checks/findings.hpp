// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What of a recording a person should know before running it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checks/figures.hpp"
#include "checks/scan_facts.hpp"
#include "io/recording.hpp"

namespace surefoot::checks {

struct Finding {
  bool suffers = false;   ///< a run suffers of it; else it is odd, and a run copes
  std::string what;       ///< "stamps go back"
  std::string detail;     ///< what it means, or what helps
  std::size_t scans = 0;  ///< that have it; 0: it is of the whole recording
  std::string first;      ///< the first of them
};

/// What is odd about the scans, what a run suffers of first. `losses`: what the recording says that
/// it could not read.
[[nodiscard]] std::vector<Finding> findings_of(const std::vector<ScanFacts>& scans,
                                               const Figures& figures,
                                               const io::CaptureCounts& counts,
                                               const std::vector<std::string>& losses = {});

}  // namespace surefoot::checks
