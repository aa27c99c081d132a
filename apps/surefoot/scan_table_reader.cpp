// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "scan_table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>

#include "dataset/ascii_values.hpp"
#include "dataset/decimal_time.hpp"
#include "dataset/file_reader.hpp"
#include "dataset/recording.hpp"

namespace surefoot::app {

namespace {

using dataset::ReadError;

/// One line of RFC 4180 that spans no other: fields between commas, quoted ones with "" for ".
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

/// Where the lines' fields go.
class TableBuilder {
 public:
  explicit TableBuilder(std::vector<std::string> header) : header_(std::move(header)) {
    for (const char* name : {"stamp", "status"}) {
      if (std::find(header_.begin(), header_.end(), name) == header_.end()) {
        throw ReadError(fmt::format("line 1: no column '{}'; expected a run's scans.csv", name));
      }
    }
    for (const std::string& name : header_) {
      if (!is_text(name)) columns_.push_back({name, {}});
    }
  }

  void add(const std::vector<std::string>& fields) {
    if (fields.size() != header_.size()) {
      throw ReadError(fmt::format("{} fields, {} expected", fields.size(), header_.size()));
    }
    std::size_t column = 0;
    std::map<std::string_view, std::string_view> texts;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (is_text(header_[i])) {
        texts[header_[i]] = fields[i];
      } else {
        columns_[column++].values.push_back(number(header_[i], fields[i]));
      }
    }
    const auto stamp = dataset::parse_decimal_seconds(texts["stamp"]);
    if (!stamp) throw ReadError(fmt::format("stamp is {}", dataset::in_quotes(texts["stamp"])));
    table_.stamps_ns.push_back(*stamp);
    table_.statuses.emplace_back(texts["status"]);
    table_.messages.emplace_back(texts["message"]);
    table_.degenerate.emplace_back(texts["degenerate"]);
  }

  [[nodiscard]] report::ScanTable take() {
    table_.columns = std::move(columns_);
    return std::move(table_);
  }

 private:
  static bool is_text(std::string_view name) {
    return name == "name" || name == "stamp" || name == "status" || name == "message" ||
           name == "degenerate";
  }
  static float number(const std::string& name, std::string_view field) {
    if (field.empty()) return std::numeric_limits<float>::quiet_NaN();
    double value = 0.0;
    if (!dataset::parse_real(field, value)) {
      throw ReadError(fmt::format("{} is {}, no number", name, dataset::in_quotes(field)));
    }
    return static_cast<float>(value);
  }

  std::vector<std::string> header_;
  std::vector<report::ScanColumn> columns_;
  report::ScanTable table_;
};

report::ScanTable parse_scan_table(std::string_view text) {
  text = text.substr(0, text.rfind('\n') + 1);
  dataset::LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) throw ReadError("empty; expected a run's scans.csv");
  TableBuilder table(csv_fields(line));
  while (lines.next(line)) {
    try {
      table.add(csv_fields(line));
    } catch (const ReadError& error) {
      throw ReadError(fmt::format("line {}: {}", lines.line_number(), error.what()));
    }
  }
  return table.take();
}

}  // namespace

report::ScanTable read_scan_table(const std::filesystem::path& file) {
  try {
    std::vector<std::byte> bytes;
    dataset::read_whole_file(file, bytes);
    return parse_scan_table(dataset::text_of(bytes));
  } catch (const ReadError& error) {
    throw ReadError(file.string() + ": " + error.what());
  }
}

}  // namespace surefoot::app
