// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The scans.csv that `surefoot run` leaves, read for what a comparison tells of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace surefoot::app {

struct ScanLines {
  std::vector<std::int64_t> stamps_ns;
  std::map<std::string, std::size_t> statuses;  ///< how many scans had each
  std::vector<double> milliseconds;             ///< processing time of each scan
};

/// Throws dataset::ReadError naming file, line and column.
[[nodiscard]] ScanLines read_scans_csv(const std::filesystem::path& file);

}  // namespace surefoot::app
