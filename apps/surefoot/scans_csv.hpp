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

/// Fields of a line of CSV (RFC 4180), without their quotes.
[[nodiscard]] std::vector<std::string> csv_fields(const std::string& line);

/// Throws std::runtime_error naming file, line and column.
[[nodiscard]] ScanLines read_scans_csv(const std::filesystem::path& file);

/// The value below which the share `q` of the values lies; 0 for none. The same rule as in the
/// summary of `surefoot run`.
[[nodiscard]] double quantile(std::vector<double> values, double q);

}  // namespace surefoot::app
