// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "io/recording.hpp"
#include "runs/run_options.hpp"
#include "runs/run_scans.hpp"

namespace surefoot::runs {

/// Throws io::ReadError where the folder of a run is given for a recording.
void refuse_run_folder(const std::filesystem::path& input);

/// Throws io::ReadError where a run that begins with this scan cannot become one: there is none,
/// its coordinates are not metres, or no scan of the recording can be read.
void check_first_scan(const RunOptions& options, const std::optional<io::ScanItem>& first);

/// Throws io::ReadError where the truth that was given ends before the first scans: it has nothing
/// to tell of this recording. One stamp alone may be wrong.
void refuse_past_truth(const RunOptions& options, const std::optional<io::ScanItem>& first,
                       RunScans& scans);

}  // namespace surefoot::runs
