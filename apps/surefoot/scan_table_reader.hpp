// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "report/report.hpp"

namespace surefoot::app {

/// A run's scans.csv. Columns that it does not know become numbers. A last line that was not
/// finished is left out. Throws dataset::ReadError naming file and line.
[[nodiscard]] report::ScanTable read_scan_table(const std::filesystem::path& file);

}  // namespace surefoot::app
