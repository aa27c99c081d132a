// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/ascii_values.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"
#include "text/utf8.hpp"

namespace surefoot::runs {

using io::ReadError;

std::string csv_quoted(std::string_view text) {
  const unsigned last = text::is_utf8(text) ? 0xFF : 0x7E;
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || byte > last) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += c == '"' ? "\"\"" : std::string(1, c);
    }
  }
  return result + '"';
}

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

std::size_t CsvHead::column(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw ReadError(fmt::format(
        "{}: line 1: no column '{}'; expected a table as surefoot run writes it", file, name));
  }
  return static_cast<std::size_t>(found - names.begin());
}

void read_csv_rows(const std::filesystem::path& file,
                   const std::function<void(const CsvHead& head)>& begin,
                   const std::function<void(const std::vector<std::string>& row)>& use) {
  std::size_t line_number = 0;
  std::size_t columns = 0;
  const auto read = [&](std::string_view text) {
    text = text.substr(0, text.rfind('\n') + 1);
    io::LineReader lines(text, line_number);
    for (std::string_view line; lines.next(line);) {
      std::vector<std::string> fields = csv_fields(line);
      if (lines.line_number() == 1) {
        columns = fields.size();
        begin({file.string(), std::move(fields)});
      } else if (fields.size() == columns) {
        use(fields);
      } else {
        throw ReadError(fmt::format("{}: line {}: {} fields, {} expected", file.string(),
                                    lines.line_number(), fields.size(), columns));
      }
    }
    line_number = lines.line_number();
  };
  io::read_lines_in_parts(file, read);
  if (line_number > 0) return;
  throw ReadError(file.string() +
                  ": its header line cannot be read; expected a table as surefoot run writes it");
}

CsvTable read_csv_table(const std::filesystem::path& file) {
  CsvTable table;
  read_csv_rows(
      file, [&](const CsvHead& head) { static_cast<CsvHead&>(table) = head; },
      [&](const std::vector<std::string>& row) { table.rows.push_back(row); });
  return table;
}

}  // namespace surefoot::runs
