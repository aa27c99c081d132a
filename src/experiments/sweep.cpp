// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "evaluation/comparison_tables.hpp"
#include "evaluation/marked_table.hpp"
#include "io/ascii_values.hpp"

namespace surefoot::experiments {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kFormatVersion = 1;  // changes when a key changes its meaning or goes
constexpr int kMostValues = 1000;  // of a range

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// first:last:step, the last one included if a step meets it.
std::vector<std::string> values_of_range(const std::string& range) {
  const std::vector<std::string> parts = split(range, ':');
  double first = 0.0, last = 0.0, step = 0.0;
  if (parts.size() != 3 || !io::parse_real(parts[0], first) || !io::parse_real(parts[1], last) ||
      !io::parse_real(parts[2], step) || !(step > 0.0) || !(last >= first) ||
      !((last - first) / step < kMostValues)) {
    throw ConfigError(fmt::format(
        "--vary: range {}: expected first:last:step with first <= last, a step above 0 and fewer "
        "than {} values, as in 0.1:0.5:0.1",
        range, kMostValues));
  }
  std::vector<std::string> values;
  const int steps = static_cast<int>(std::floor((last - first) / step + 1e-9));
  for (int i = 0; i <= steps; ++i) values.push_back(fmt::format("{:.12g}", first + i * step));
  return values;
}

void fill_row(const evaluation::Comparison& comparison, std::size_t method, SweepRow& row) {
  double milliseconds = 0.0;
  int timed = 0;  // whole runs: a part of a recording takes other times
  for (const evaluation::ComparedRecording& recording : comparison.recordings) {
    const evaluation::MethodResult& result = recording.results[method];
    SweepCell cell{.lost = result.verdict.text};
    if (cell.lost.empty()) {
      cell.ape = evaluation::find_statistics(*result.evaluation, "ape_translation")->rmse;
      const auto* step = evaluation::find_statistics(*result.evaluation, "rpe_translation");
      if (step != nullptr) cell.step = step->rmse;
    }
    row.cells.push_back(cell);
    if (const auto& run = result.runs.front(); cell.lost.empty() && run.scans > 0) {
      milliseconds += run.median_ms;
      ++timed;
    }
    for (const auto& [status, count] : evaluation::not_ok(result)) {
      if (status != "degenerate" && status != "first_scan") row.untrusted += count;
    }
  }
  if (timed > 0) row.milliseconds = milliseconds / timed;
}

std::optional<double> ratio(const SweepRow& row, const SweepRow& base,
                            std::optional<double> SweepCell::*error) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t r = 0; r < row.cells.size(); ++r) {
    const std::optional<double>&one = row.cells[r].*error, &usual = base.cells[r].*error;
    if (!one || !usual) continue;
    const double change = std::log(*one / *usual);
    if (!std::isfinite(change)) continue;  // one of them has no error at all
    sum += change;
    ++count;
  }
  return count > 0 ? std::optional(std::exp(sum / count)) : std::nullopt;
}

std::string text_of(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::string csv_of(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

OrderedJson json_of(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

}  // namespace

SweepPlan sweep_plan(const std::string& method, const std::vector<std::string>& variations) {
  SweepPlan plan{{parse_variant(method)}, {"unchanged"}};
  for (const std::string& variation : variations) {
    const std::size_t equals = variation.find('=');
    const std::string text = equals == std::string::npos ? "" : variation.substr(equals + 1);
    if (text.empty()) {
      throw ConfigError(fmt::format(
          "--vary {}: expected key=value,value,... as in preprocess.max_range=50,100, or "
          "key=first:last:step",
          variation));
    }
    const std::string key = variation.substr(0, equals);
    const bool is_range = text.find(':') != std::string::npos;
    for (const std::string& value : is_range ? values_of_range(text) : split(text, ',')) {
      const std::string setting = fmt::format("{}={}", key, value);
      const std::string label = fmt::format("{} = {}", key, value);
      if (std::find(plan.labels.begin(), plan.labels.end(), label) != plan.labels.end()) {
        throw ConfigError(fmt::format("--vary: {} is named twice", setting));
      }
      plan.variants.push_back({method + '+' + setting, method, {setting}});
      plan.labels.push_back(label);
    }
  }
  return plan;
}

SweepResult sweep_of(const evaluation::Comparison& comparison,
                     const std::vector<std::string>& labels) {
  SweepResult sweep;
  for (const auto& recording : comparison.recordings) sweep.recordings.push_back(recording.name);
  for (std::size_t m = 0; m < labels.size(); ++m) {
    SweepRow row{.label = labels[m]};
    fill_row(comparison, m, row);
    const SweepRow& base = m == 0 ? row : sweep.rows.front();
    row.ape_ratio = ratio(row, base, &SweepCell::ape);
    row.step_ratio = ratio(row, base, &SweepCell::step);
    sweep.rows.push_back(std::move(row));
  }
  sweep.notes = evaluation::trouble_notes(comparison);
  return sweep;
}

std::string sweep_markdown(const SweepResult& sweep) {
  evaluation::Table table{.title = "", .head_names = {"parameter"}, .columns = sweep.recordings};
  for (const char* name : {"APE ratio", "step ratio", "ms", "untrusted"}) {
    table.columns.emplace_back(name);
  }
  for (const SweepRow& row : sweep.rows) {
    evaluation::TableRow& line = table.rows.emplace_back();
    line.heads = {row.label};
    for (const SweepCell& cell : row.cells) {
      line.cells.push_back(
          {cell.lost.empty() ? text_of(cell.ape, 3) + " / " + text_of(cell.step, 3) : cell.lost});
    }
    for (const std::string& text : {text_of(row.ape_ratio, 2), text_of(row.step_ratio, 2),
                                    text_of(row.milliseconds, 1), std::to_string(row.untrusted)}) {
      line.cells.push_back({text});
    }
  }
  std::string text = evaluation::to_markdown(table);
  if (!sweep.notes.empty()) text += '\n';
  for (const std::string& note : sweep.notes) text += "- " + note + '\n';
  return text;
}

std::string sweep_csv(const SweepResult& sweep) {
  std::string text = "parameter,recording,ape_rmse_m,step_rmse_m,lost\n";
  for (const SweepRow& row : sweep.rows) {
    for (std::size_t r = 0; r < row.cells.size(); ++r) {
      const SweepCell& cell = row.cells[r];
      text += fmt::format("{},{},", evaluation::csv_field(row.label),
                          evaluation::csv_field(sweep.recordings[r]));
      text += cell.lost.empty() ? fmt::format("{},{},\n", csv_of(cell.ape), csv_of(cell.step))
                                : fmt::format(",,{}\n", evaluation::csv_field(cell.lost));
    }
  }
  return text;
}

std::string sweep_json(const SweepResult& sweep, const evaluation::Comparison& comparison) {
  OrderedJson rows = OrderedJson::array();
  for (std::size_t m = 0; m < sweep.rows.size(); ++m) {
    const SweepRow& row = sweep.rows[m];
    OrderedJson cells = OrderedJson::array();
    for (std::size_t r = 0; r < row.cells.size(); ++r) {
      const SweepCell& cell = row.cells[r];
      OrderedJson json = {{"recording", sweep.recordings[r]}};
      if (cell.lost.empty()) {
        json["ape_rmse_m"] = json_of(cell.ape);
        json["step_rmse_m"] = json_of(cell.step);
      } else {
        json["lost"] = cell.lost;
      }
      cells.push_back(json);
    }
    rows.push_back({{"parameter", row.label},
                    {"method", comparison.methods[m].label},
                    {"ape_ratio", json_of(row.ape_ratio)},
                    {"step_ratio", json_of(row.step_ratio)},
                    {"median_ms", json_of(row.milliseconds)},
                    {"untrusted_scans", row.untrusted},
                    {"recordings", cells}});
  }
  const OrderedJson document = {{"format", "surefoot-sweep"},
                                {"format_version", kFormatVersion},
                                {"version", comparison.version},
                                {"build", comparison.build},
                                {"run_arguments", comparison.run_arguments},
                                {"notes", sweep.notes},
                                {"rows", rows}};
  return document.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

}  // namespace surefoot::experiments
