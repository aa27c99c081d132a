// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "scans_csv.hpp"

#include <fmt/format.h>

#include "csv_table.hpp"
#include "dataset/ascii_values.hpp"
#include "dataset/decimal_time.hpp"
#include "dataset/recording.hpp"

namespace surefoot::app {

ScanLines read_scans_csv(const std::filesystem::path& file) {
  const CsvTable table = read_csv_table(file);
  const std::size_t stamp_column = table.column("stamp");
  const std::size_t status_column = table.column("status");
  const std::size_t time_column = table.column("ms_total");
  ScanLines lines;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::vector<std::string>& fields = table.rows[row];
    const auto stamp = dataset::parse_decimal_seconds(fields[stamp_column]);
    double time = 0.0;
    if (!stamp || !dataset::parse_real(fields[time_column], time)) {
      throw dataset::ReadError(
          fmt::format("{}: line {}: stamp '{}' and ms_total '{}' should be numbers", table.file,
                      csv_line(row), fields[stamp_column], fields[time_column]));
    }
    lines.stamps_ns.push_back(*stamp);
    lines.milliseconds.push_back(time);
    ++lines.statuses[fields[status_column]];
  }
  return lines;
}

}  // namespace surefoot::app
