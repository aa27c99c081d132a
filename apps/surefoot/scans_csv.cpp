// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "scans_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "dataset/decimal_time.hpp"

namespace surefoot::app {

namespace {

std::size_t column_of(const std::vector<std::string>& names, const std::string& name,
                      const std::filesystem::path& file) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::runtime_error(fmt::format("{}: line 1: no column '{}'", file.string(), name));
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<double> parse_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

ScanLines read_scans_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) throw std::runtime_error(file.string() + ": cannot be read");
  const std::vector<std::string> names = csv_fields(line);
  const std::size_t stamp_column = column_of(names, "stamp", file);
  const std::size_t status_column = column_of(names, "status", file);
  const std::size_t time_column = column_of(names, "ms_total", file);
  ScanLines lines;
  for (std::size_t number = 2; std::getline(stream, line); ++number) {
    const std::vector<std::string> fields = csv_fields(line);
    if (fields.size() != names.size()) {
      throw std::runtime_error(fmt::format("{}: line {}: {} fields instead of {}", file.string(),
                                           number, fields.size(), names.size()));
    }
    const auto stamp = dataset::parse_decimal_seconds(fields[stamp_column]);
    const auto time = parse_number(fields[time_column]);
    if (!stamp || !time) {
      throw std::runtime_error(
          fmt::format("{}: line {}: stamp '{}' and ms_total '{}' should be "
                      "numbers",
                      file.string(), number, fields[stamp_column], fields[time_column]));
    }
    lines.stamps_ns.push_back(*stamp);
    lines.milliseconds.push_back(*time);
    ++lines.statuses[fields[status_column]];
  }
  return lines;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  const auto index = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

}  // namespace surefoot::app
