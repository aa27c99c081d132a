// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace surefoot::evaluation {

namespace {

using Column = std::pair<const char*, double Statistics::*>;
constexpr std::array<Column, 7> kColumns = {{{"max", &Statistics::max},
                                             {"mean", &Statistics::mean},
                                             {"median", &Statistics::median},
                                             {"min", &Statistics::min},
                                             {"rmse", &Statistics::rmse},
                                             {"std", &Statistics::std},
                                             {"sse", &Statistics::sse}}};
// The columns of the tables that papers print.
constexpr std::array<Column, 4> kPaperColumns = {{{"Max", &Statistics::max},
                                                  {"Mean", &Statistics::mean},
                                                  {"RMSE", &Statistics::rmse},
                                                  {"Std", &Statistics::std}}};

std::vector<NamedStatistics> all_statistics(const Evaluation& evaluation) {
  std::vector<NamedStatistics> all = evaluation.absolute;
  all.insert(all.end(), evaluation.relative.begin(), evaluation.relative.end());
  return all;
}

nlohmann::ordered_json json_of(const NamedStatistics& named) {
  nlohmann::ordered_json json = {{"unit", named.unit}, {"count", named.statistics.count}};
  for (const auto& [name, member] : kColumns) json[name] = named.statistics.*member;
  return json;
}

nlohmann::ordered_json json_of(const SegmentError& segment) {
  return {{"length_m", segment.length},
          {"count", segment.count},
          {"translation_percent", segment.translation_percent},
          {"rotation_deg_per_m", segment.rotation_deg_per_m}};
}

nlohmann::ordered_json json_of(const Evaluation& evaluation) {
  const Pose& pose = evaluation.alignment.pose;
  nlohmann::ordered_json json = {
      {"estimate", evaluation.name},
      {"poses", evaluation.poses},
      {"pairs", evaluation.pairs},
      {"coverage", evaluation.coverage},
      {"alignment",
       {{"translation_m", {pose.translation.x(), pose.translation.y(), pose.translation.z()}},
        {"rotation_xyzw",
         {pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), pose.rotation.w()}},
        {"scale", evaluation.alignment.scale}}},
      {"errors", nlohmann::ordered_json::object()},
      {"segments", nlohmann::ordered_json::array()},
      {"segments_all", json_of(evaluation.segments.all)},
      {"end_drift",
       {{"path_length_m", evaluation.drift.path_length},
        {"total_m", evaluation.drift.total},
        {"horizontal_m", evaluation.drift.horizontal},
        {"vertical_m", evaluation.drift.vertical},
        {"percent", evaluation.drift.percent}}}};
  for (const NamedStatistics& named : all_statistics(evaluation)) {
    json["errors"][named.name] = json_of(named);
  }
  json["segments_all"].erase("length_m");
  for (const SegmentError& segment : evaluation.segments.by_length) {
    json["segments"].push_back(json_of(segment));
  }
  return json;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string("&%$#_{}").find(c) != std::string::npos) {
      escaped += std::string("\\") + c;
    } else if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += std::string("\\") + c + "{}";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

void append_text(std::string& text, const Evaluation& evaluation) {
  text +=
      fmt::format("{}: {} of {} poses paired, {:.1f} % of the reference covered\n", evaluation.name,
                  evaluation.pairs, evaluation.poses, 100.0 * evaluation.coverage);
  text += fmt::format("  {:<22}{:>5}", "", "");
  for (const auto& [name, member] : kColumns) text += fmt::format("{:>12}", name);
  text += '\n';
  for (const NamedStatistics& named : all_statistics(evaluation)) {
    text += fmt::format("  {:<22}{:>5}", named.name, named.unit);
    for (const auto& [name, member] : kColumns) {
      text += fmt::format("{:>12.6g}", named.statistics.*member);
    }
    text += '\n';
  }
  for (const SegmentError& segment : evaluation.segments.by_length) {
    if (segment.count == 0) continue;
    text +=
        fmt::format("  segments of {:g} m: {:.4f} %, {:.6f} deg/m ({} segments)\n", segment.length,
                    segment.translation_percent, segment.rotation_deg_per_m, segment.count);
  }
  const SegmentError& segments = evaluation.segments.all;
  if (segments.count > 0) {
    text += fmt::format("  segments of all lengths: {:.4f} %, {:.6f} deg/m ({} segments)\n",
                        segments.translation_percent, segments.rotation_deg_per_m, segments.count);
  }
  const EndDrift& drift = evaluation.drift;
  text += fmt::format(
      "  end drift {:.4f} m ({:.4f} % of {:.2f} m), horizontal {:.4f} m, "
      "vertical {:+.4f} m\n",
      drift.total, drift.percent, drift.path_length, drift.horizontal, drift.vertical);
}

/// Smallest and second smallest of the values in a column; equal values share a place.
struct Podium {
  double first, second;
};

Podium podium(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const double none = -1.0;  // errors are never negative
  return {values.empty() ? none : values[0], values.size() < 2 ? none : values[1]};
}

std::string latex_number(double value, const Podium& best) {
  const std::string number = fmt::format("{:.3f}", value);
  if (value == best.first) return "\\textbf{" + number + "}";
  return value == best.second ? "\\underline{" + number + "}" : number;
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
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string to_csv(const std::vector<Evaluation>& evaluations) {
  std::string csv = "estimate,error,unit,count";
  for (const auto& [name, member] : kColumns) csv += fmt::format(",{}", name);
  csv += '\n';
  for (const Evaluation& evaluation : evaluations) {
    for (const NamedStatistics& named : all_statistics(evaluation)) {
      csv += fmt::format("{},{},{},{}", csv_field(evaluation.name), named.name, named.unit,
                         named.statistics.count);
      for (const auto& [name, member] : kColumns) {
        csv += fmt::format(",{}", named.statistics.*member);
      }
      csv += '\n';
    }
  }
  return csv;
}

std::string to_latex(const std::vector<Evaluation>& evaluations, double full_coverage) {
  std::array<Podium, kPaperColumns.size()> best{};
  for (std::size_t column = 0; column < kPaperColumns.size(); ++column) {
    std::vector<double> values;
    for (const Evaluation& evaluation : evaluations) {
      if (evaluation.coverage < full_coverage) continue;
      values.push_back(evaluation.absolute.front().statistics.*kPaperColumns[column].second);
    }
    best[column] = podium(std::move(values));
  }
  std::string latex = "\\begin{tabular}{lrrrr}\n\\toprule\nMethod";
  for (const auto& [name, member] : kPaperColumns) latex += fmt::format(" & {}", name);
  latex += " \\\\\n\\midrule\n";
  for (const Evaluation& evaluation : evaluations) {
    const bool whole = evaluation.coverage >= full_coverage;
    latex += latex_text(evaluation.name);
    if (!whole) latex += fmt::format(" ({:.0f}\\,\\% covered)", 100.0 * evaluation.coverage);
    for (std::size_t column = 0; column < kPaperColumns.size(); ++column) {
      const double value = evaluation.absolute.front().statistics.*kPaperColumns[column].second;
      latex += " & " + latex_number(value, whole ? best[column] : Podium{-1.0, -1.0});
    }
    latex += " \\\\\n";
  }
  return latex + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace surefoot::evaluation
