// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::runs {

/// A text as a field: in quotes, on one line, as UTF-8, whatever bytes it holds.
[[nodiscard]] std::string csv_quoted(std::string_view text);

/// Fields of a line of CSV (RFC 4180) that spans no other, without their quotes.
[[nodiscard]] std::vector<std::string> csv_fields(std::string_view line);

/// The first line of a CSV file: the names of its columns.
struct CsvHead {
  std::string file;  ///< for messages
  std::vector<std::string> names;

  /// Throws io::ReadError naming file and column if there is no such column.
  [[nodiscard]] std::size_t column(std::string_view name) const;
};

/// A CSV file as text: its head, and a row for each line after it.
struct CsvTable : CsvHead {
  std::vector<std::vector<std::string>> rows;  ///< each as long as `names`
};

/// Line of the file that a row stands in.
[[nodiscard]] inline std::size_t csv_line(std::size_t row) { return row + 2; }

/// Reads a CSV file row by row, so that it is never in memory as a whole: first its head, then each
/// row. A last line that was not finished, as a killed writer leaves it, is left out. Throws
/// io::ReadError naming file and line.
void read_csv_rows(const std::filesystem::path& file,
                   const std::function<void(const CsvHead& head)>& begin,
                   const std::function<void(const std::vector<std::string>& row)>& use);

/// The same, kept.
[[nodiscard]] CsvTable read_csv_table(const std::filesystem::path& file);

}  // namespace surefoot::runs
