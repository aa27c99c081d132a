// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "scan_table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "csv_table.hpp"
#include "dataset/ascii_values.hpp"
#include "dataset/decimal_time.hpp"
#include "dataset/recording.hpp"

namespace surefoot::app {

namespace {

using dataset::ReadError;

constexpr std::array<std::string_view, 5> kTexts = {"name", "stamp", "status", "message",
                                                    "degenerate"};

/// Texts of a column; empty ones if an older program did not write it.
std::vector<std::string> texts_of(const CsvTable& table, std::string_view name) {
  const auto found = std::find(table.names.begin(), table.names.end(), name);
  std::vector<std::string> texts(table.rows.size());
  if (found == table.names.end()) return texts;
  const auto column = static_cast<std::size_t>(found - table.names.begin());
  for (std::size_t row = 0; row < texts.size(); ++row) texts[row] = table.rows[row][column];
  return texts;
}

report::ScanColumn numbers_of(const CsvTable& table, std::size_t column) {
  report::ScanColumn numbers{table.names[column], {}};
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& field = table.rows[row][column];
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!field.empty() && !dataset::parse_real(field, value)) {
      throw ReadError(fmt::format("{}: line {}: {} is {}, no number", table.file, csv_line(row),
                                  numbers.name, dataset::in_quotes(field)));
    }
    numbers.values.push_back(static_cast<float>(value));
  }
  return numbers;
}

}  // namespace

report::ScanTable read_scan_table(const std::filesystem::path& file) {
  const CsvTable table = read_csv_table(file);
  const std::size_t stamp_column = table.column("stamp");
  report::ScanTable scans;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& field = table.rows[row][stamp_column];
    const auto stamp = dataset::parse_decimal_seconds(field);
    if (!stamp) {
      throw ReadError(fmt::format("{}: line {}: stamp is {}", table.file, csv_line(row),
                                  dataset::in_quotes(field)));
    }
    scans.stamps_ns.push_back(*stamp);
  }
  (void)table.column("status");
  scans.statuses = texts_of(table, "status");
  scans.messages = texts_of(table, "message");
  scans.degenerate = texts_of(table, "degenerate");
  for (std::size_t column = 0; column < table.names.size(); ++column) {
    const bool text = std::count(kTexts.begin(), kTexts.end(), table.names[column]) > 0;
    if (!text) scans.columns.push_back(numbers_of(table, column));
  }
  return scans;
}

}  // namespace surefoot::app
