// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::runs {

/// Fields of a line of CSV (RFC 4180) that spans no other, without their quotes.
[[nodiscard]] std::vector<std::string> csv_fields(std::string_view line);

/// A CSV file as text: the names in its first line, and a row for each line after it.
struct CsvTable {
  std::string file;  ///< for messages
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `names`

  /// Throws io::ReadError naming file and column if there is no such column.
  [[nodiscard]] std::size_t column(std::string_view name) const;
};

/// Line of the file that a row stands in.
[[nodiscard]] inline std::size_t csv_line(std::size_t row) { return row + 2; }

/// A last line that was not finished, as a killed writer leaves it, is left out. Throws
/// io::ReadError naming file and line.
[[nodiscard]] CsvTable read_csv_table(const std::filesystem::path& file);

}  // namespace surefoot::runs
