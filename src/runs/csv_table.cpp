// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/ascii_values.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::runs {

using io::ReadError;

std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool doubled = quoted && line.substr(i, 2) == "\"\"";
    if (doubled) {
      fields.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw ReadError(fmt::format(
        "{}: line 1: no column '{}'; expected a table as surefoot run writes it", file, name));
  }
  return static_cast<std::size_t>(found - names.begin());
}

CsvTable read_csv_table(const std::filesystem::path& file) {
  std::vector<std::byte> bytes;
  io::read_whole_file(file, bytes);
  std::string_view text = io::text_of(bytes);
  text = text.substr(0, text.rfind('\n') + 1);
  io::LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) {
    throw ReadError(file.string() +
                    ": its header line cannot be read; expected a table as surefoot run writes it");
  }
  CsvTable table{file.string(), csv_fields(line), {}};
  while (lines.next(line)) {
    table.rows.push_back(csv_fields(line));
    if (const std::size_t seen = table.rows.back().size(); seen != table.names.size()) {
      throw ReadError(fmt::format("{}: line {}: {} fields, {} expected", file.string(),
                                  lines.line_number(), seen, table.names.size()));
    }
  }
  return table;
}

}  // namespace surefoot::runs
