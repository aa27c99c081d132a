// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "evaluation/evaluation_json.hpp"
#include "evaluation/marked_table.hpp"
#include "evaluation/statistics_names.hpp"

namespace surefoot::evaluation {

namespace {

std::vector<NamedStatistics> all_statistics(const Evaluation& evaluation) {
  std::vector<NamedStatistics> all = evaluation.absolute;
  all.insert(all.end(), evaluation.relative.begin(), evaluation.relative.end());
  return all;
}

std::string count_text(const SegmentError& segment) {
  return fmt::format("{} {}", segment.count, segment.count == 1 ? "segment" : "segments");
}

void append_text(std::string& text, const Evaluation& evaluation) {
  text +=
      fmt::format("{}: {} of {} poses paired, {:.1f} % of the reference covered\n", evaluation.name,
                  evaluation.pairs, evaluation.poses, 100.0 * evaluation.coverage);
  text += fmt::format("  {:<22}{:>5}", "", "");
  for (const auto& [name, member] : kStatisticsNames) text += fmt::format("{:>12}", name);
  text += '\n';
  for (const NamedStatistics& named : all_statistics(evaluation)) {
    text += fmt::format("  {:<22}{:>5}", named.name, named.unit);
    for (const auto& [name, member] : kStatisticsNames) {
      text += fmt::format("{:>12.6g}", named.statistics.*member);
    }
    text += '\n';
  }
  for (const SegmentError& segment : evaluation.segments.by_length) {
    if (segment.count == 0) continue;
    text +=
        fmt::format("  segments of {:g} m: {:.4f} %, {:.6f} deg/m ({})\n", segment.length,
                    segment.translation_percent, segment.rotation_deg_per_m, count_text(segment));
  }
  const SegmentError& segments = evaluation.segments.all;
  if (segments.count > 0) {
    text += fmt::format("  segments of all lengths: {:.4f} %, {:.6f} deg/m ({})\n",
                        segments.translation_percent, segments.rotation_deg_per_m,
                        count_text(segments));
  }
  const EndDrift& drift = evaluation.drift;
  const double vertical = std::round(1e4 * drift.vertical) / 1e4 + 0.0;  // no -0
  text += fmt::format(
      "  end drift {:.4f} m ({:.4f} % of {:.2f} m), horizontal {:.4f} m, "
      "vertical {:+.4f} m\n",
      drift.total, drift.percent, drift.path_length, drift.horizontal, vertical);
}

/// Finds an error's statistics by name; nothing if the run was too short for it.
const Statistics* find(const std::vector<NamedStatistics>& errors, const std::string& name) {
  for (const NamedStatistics& named : errors) {
    if (named.name == name) return &named.statistics;
  }
  return nullptr;
}

/// A column of a table with a row for each estimate.
struct Column {
  std::string name;
  std::function<std::optional<double>(const Evaluation&)> value;
  int decimals = 3;
  bool ranked = true;
};

/// The larger the farther off, whatever the sign.
Cell cell_of(const Evaluation& evaluation, const Column& column, bool whole) {
  const std::optional<double> value = column.value(evaluation);
  if (!value) return {"\u2013"};
  return {fmt::format("{:.{}f}", *value, column.decimals), std::abs(*value),
          whole && column.ranked};
}

std::string latex_table(const std::vector<Evaluation>& evaluations, double full_coverage,
                        const std::string& title, const std::vector<Column>& columns) {
  Table table{.title = title, .head_names = {"Method"}};
  for (const Column& column : columns) table.columns.push_back(column.name);
  for (const Evaluation& evaluation : evaluations) {
    const bool whole = evaluation.coverage >= full_coverage;
    TableRow row{.heads = {evaluation.name}};
    if (!whole) row.heads[0] += fmt::format(" ({:.0f} % covered)", 100.0 * evaluation.coverage);
    for (const Column& column : columns) row.cells.push_back(cell_of(evaluation, column, whole));
    table.rows.push_back(std::move(row));
  }
  rank_columns(table);
  return to_latex(table);
}

std::vector<Column> paper_columns() {
  std::vector<Column> columns;
  for (const auto& [name, member] : kPaperStatistics) {
    columns.push_back({name, [member = member](const Evaluation& evaluation) {
                         return evaluation.absolute.front().statistics.*member;
                       }});
  }
  return columns;
}

/// The RMSE of every error of the list that the first estimate has.
std::vector<Column> rmse_columns(const std::vector<Evaluation>& evaluations,
                                 std::vector<NamedStatistics> Evaluation::*list) {
  std::vector<Column> columns;
  for (const Evaluation& evaluation : evaluations) {
    for (const NamedStatistics& named : evaluation.*list) {
      const std::string unit = named.unit.empty() ? "" : " (" + named.unit + ")";
      const std::string title = named.name.substr(named.name.find('_') + 1);
      columns.push_back({title + unit, [list, name = named.name](const Evaluation& each) {
                           const Statistics* found = find(each.*list, name);
                           return found ? std::optional(found->rmse) : std::nullopt;
                         }});
    }
    if (!columns.empty()) break;  // estimates differ only in having none
  }
  return columns;
}

/// Segments have a column for each length that any of the estimates is long enough for.
std::vector<Column> segment_columns(const std::vector<Evaluation>& evaluations) {
  const auto column = [](std::string name, auto pick, double SegmentError::*part, int decimals) {
    return Column{std::move(name),
                  [pick, part](const Evaluation& evaluation) -> std::optional<double> {
                    const SegmentError* segment = pick(evaluation);
                    if (segment == nullptr || segment->count == 0) return std::nullopt;
                    return segment->*part;
                  },
                  decimals};
  };
  std::set<double> lengths;
  for (const Evaluation& evaluation : evaluations) {
    for (const SegmentError& segment : evaluation.segments.by_length) {
      if (segment.count > 0) lengths.insert(segment.length);
    }
  }
  std::vector<Column> columns;
  for (const double length : lengths) {
    const auto pick = [length](const Evaluation& evaluation) {
      const auto& all = evaluation.segments.by_length;
      const auto found = std::find_if(all.begin(), all.end(), [length](const SegmentError& each) {
        return each.length == length;
      });
      return found == all.end() ? nullptr : &*found;
    };
    columns.push_back(
        column(fmt::format("{:g} m (%)", length), pick, &SegmentError::translation_percent, 3));
  }
  const auto all = [](const Evaluation& evaluation) { return &evaluation.segments.all; };
  columns.push_back(column("all (%)", all, &SegmentError::translation_percent, 3));
  columns.push_back(column("all (deg/m)", all, &SegmentError::rotation_deg_per_m, 4));
  return columns;
}

std::vector<Column> drift_columns() {
  const auto drift = [](double EndDrift::*part) {
    return [part](const Evaluation& evaluation) { return evaluation.drift.*part; };
  };
  return {{"Drift (m)", drift(&EndDrift::total)},
          {"Drift (%)", drift(&EndDrift::percent)},
          {"Horizontal (m)", drift(&EndDrift::horizontal)},
          {"Vertical (m)", drift(&EndDrift::vertical)},
          {"Path (m)", drift(&EndDrift::path_length), 1, false},
          {"Coverage (%)", [](const Evaluation& e) { return 100.0 * e.coverage; }, 1, false}};
}

}  // namespace

std::string to_text(const std::vector<Evaluation>& evaluations) {
  std::string text;
  for (const Evaluation& evaluation : evaluations) {
    if (!text.empty()) text += '\n';
    append_text(text, evaluation);
  }
  return text;
}

std::string to_json(const std::vector<Evaluation>& evaluations) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Evaluation& evaluation : evaluations) json.push_back(json_of(evaluation));
  return json_text(json);
}

std::string to_csv(const std::vector<Evaluation>& evaluations) {
  std::string csv = "estimate,error,unit,count";
  for (const auto& [name, member] : kStatisticsNames) csv += fmt::format(",{}", name);
  csv += '\n';
  for (const Evaluation& evaluation : evaluations) {
    for (const NamedStatistics& named : all_statistics(evaluation)) {
      csv += fmt::format("{},{},{},{}", csv_field(evaluation.name), named.name, named.unit,
                         named.statistics.count);
      for (const auto& [name, member] : kStatisticsNames) {
        csv += fmt::format(",{}", named.statistics.*member);
      }
      csv += '\n';
    }
  }
  return csv;
}

std::string to_latex(const std::vector<Evaluation>& evaluations, double full_coverage) {
  const auto table = [&](const std::string& title, const std::vector<Column>& columns) {
    return latex_table(evaluations, full_coverage, title, columns);
  };
  std::string latex = table("Absolute pose error, translation (m)", paper_columns());
  latex += '\n' + table("Absolute pose error, RMSE of all kinds",
                        rmse_columns(evaluations, &Evaluation::absolute));
  const std::vector<Column> relative = rmse_columns(evaluations, &Evaluation::relative);
  if (!relative.empty()) latex += '\n' + table("Relative pose error, RMSE of all kinds", relative);
  latex += '\n' + table("Error over segments, mean", segment_columns(evaluations));
  return latex + '\n' + table("Drift at the end, and coverage", drift_columns());
}

}  // namespace surefoot::evaluation
