// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/comparison_tables.hpp"

#include <fmt/format.h>

#include <functional>

#include "evaluation/option_names.hpp"
#include "evaluation/seeds.hpp"
#include "evaluation/statistics_names.hpp"

namespace surefoot::evaluation {

namespace {

constexpr const char* kNothing = "\u2013";
constexpr double kMebibyte = 1024.0 * 1024.0;

/// A line of a table: one figure of each method on a recording.
struct Figure {
  std::string name;
  std::function<Cell(const MethodResult&)> cell;
};

Cell number(double value, int decimals, bool competes) {
  return {fmt::format("{:.{}f}", value, decimals), value, competes};
}

bool is_whole(const MethodResult& result) {
  return result.verdict.outcome == Outcome::whole && result.evaluation.has_value();
}

using Which = std::optional<Evaluation> MethodResult::*;

/// A figure of the trajectory's error: of whole runs alone.
Figure error_figure(std::string name, Which which,
                    std::function<std::optional<double>(const Evaluation&)> value) {
  return {std::move(name), [value = std::move(value), which](const MethodResult& result) {
            constexpr int decimals = 3;
            if (!is_whole(result) || !(result.*which)) return Cell{kNothing};
            const std::optional<double> found = value(*(result.*which));
            return found ? number(*found, decimals, true) : Cell{kNothing};
          }};
}

/// A statistic of one kind of error, nothing where a run is too short for it.
Figure statistic_figure(std::string name, const std::string& error, double Statistics::*member,
                        Which which = &MethodResult::evaluation, double factor = 1.0) {
  return error_figure(
      std::move(name), which, [error, member, factor](const Evaluation& evaluation) {
        const Statistics* found = find_statistics(evaluation, error);
        return found == nullptr ? std::nullopt : std::optional(factor * (found->*member));
      });
}

/// Rows for each recording. `verdict_first`: a run that is not whole has its verdict in the first.
Table make_table(const Comparison& comparison, const std::string& title,
                 const std::vector<Figure>& figures, bool verdict_first) {
  Table table{.title = title, .head_names = {"Sequence", "Figure"}};
  for (const ComparedMethod& method : comparison.methods) table.columns.push_back(method.label);
  for (const ComparedRecording& recording : comparison.recordings) {
    for (const Figure& figure : figures) {
      TableRow row{.heads = {recording.name, figure.name}};
      for (const MethodResult& result : recording.results) {
        const bool verdict = verdict_first && &figure == &figures.front() && !is_whole(result);
        row.cells.push_back(verdict ? Cell{result.verdict.text} : figure.cell(result));
      }
      table.rows.push_back(std::move(row));
    }
  }
  rank_rows(table);
  return table;
}

std::vector<Figure> absolute_figures() {
  std::vector<Figure> figures;
  for (const auto& [name, member] : kPaperStatistics) {
    figures.push_back(statistic_figure(fmt::format("{} (m)", name), "ape_translation", member));
  }
  return figures;
}

std::string stretch_text(const PairOptions& stretches) {
  const std::string_view unit = name_of(kDeltaUnitNames, stretches.unit);
  return fmt::format("{:g} {}", stretches.delta, unit);
}

std::vector<Figure> further_error_figures(const PairOptions& stretches) {
  const std::string over = stretch_text(stretches);
  return {statistic_figure(relative_figure_name(stretches), "rpe_translation", &Statistics::rmse,
                           &MethodResult::evaluation, relative_factor(stretches)),
          statistic_figure(fmt::format("Relative over {}, RMSE (deg)", over), "rpe_rotation_angle",
                           &Statistics::rmse),
          statistic_figure("Height, RMSE (m)", "ape_vertical", &Statistics::rmse),
          statistic_figure("Height, maximum (m)", "ape_vertical", &Statistics::max),
          statistic_figure("Roll and pitch since the start, RMS (deg)", "ape_tilt",
                           &Statistics::rmse, &MethodResult::from_start),
          statistic_figure("Yaw since the start, RMS (deg)", "ape_yaw", &Statistics::rmse,
                           &MethodResult::from_start),
          error_figure("Drift at the end (%)", &MethodResult::evaluation,
                       [](const Evaluation& evaluation) { return evaluation.drift.percent; })};
}

bool measured(const MethodResult& result) {
  return !result.runs.empty() && result.runs.front().scans > 0;
}

Figure time_figure(const std::string& name, double MeasuredRun::*figure) {
  return {name, [figure](const MethodResult& result) {
            if (!measured(result)) return Cell{kNothing};
            return number(spread_of(result, figure).median, 2, is_whole(result));
          }};
}

Figure spread_figure(const std::string& name, double MeasuredRun::*figure) {
  return {name, [figure](const MethodResult& result) {
            if (!measured(result)) return Cell{kNothing};
            const RepeatSpread spread = spread_of(result, figure);
            return Cell{fmt::format("{:.2f}..{:.2f}", spread.min, spread.max)};
          }};
}

std::vector<Figure> effort_figures(int repeats) {
  std::vector<Figure> figures = {time_figure("Time a scan, median (ms)", &MeasuredRun::median_ms),
                                 time_figure("Time a scan, p99 (ms)", &MeasuredRun::p99_ms)};
  if (repeats > 1) {
    figures.push_back(spread_figure("Median over the repeats (ms)", &MeasuredRun::median_ms));
    figures.push_back(spread_figure("p99 over the repeats (ms)", &MeasuredRun::p99_ms));
  }
  figures.push_back({"Peak memory (MiB)", [](const MethodResult& result) {
                       if (!measured(result)) return Cell{kNothing};
                       return number(static_cast<double>(peak_memory(result)) / kMebibyte, 1,
                                     is_whole(result));
                     }});
  return figures;
}

std::string status_text(const MethodResult& result) {
  std::string text;
  for (const auto& [status, count] : not_ok(result)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  }
  if (const std::size_t unreadable = result.runs.front().unreadable; unreadable > 0) {
    text += fmt::format("{}{} unreadable", text.empty() ? "" : ", ", unreadable);
  }
  return text.empty() ? "none" : text;
}

std::vector<Figure> trouble_figures() {
  return {{"Outcome",
           [](const MethodResult& result) {
             return Cell{result.verdict.text.empty() ? "whole" : result.verdict.text};
           }},
          {"Coverage (%)",
           [](const MethodResult& result) {
             if (!result.evaluation) return Cell{kNothing};
             return number(100.0 * result.evaluation->coverage, 1, false);
           }},
          {"Poses paired",
           [](const MethodResult& result) {
             if (!result.evaluation) return Cell{kNothing};
             const Evaluation& evaluation = *result.evaluation;
             return Cell{fmt::format("{} of {}", evaluation.pairs, evaluation.poses),
                         static_cast<double>(evaluation.pairs)};
           }},
          {"Scans that were not ok", [](const MethodResult& result) {
             return Cell{measured(result) ? status_text(result) : kNothing};
           }}};
}

void add_result_notes(const ComparedRecording& recording, const std::string& method,
                      const MethodResult& result, std::vector<std::string>& notes) {
  const std::string who = fmt::format("{}, {}", recording.name, method);
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    if (result.runs[i].error.empty()) continue;
    const std::string repeat = i == 0 ? "" : fmt::format(", repeat {}", i + 1);
    notes.push_back(fmt::format("{}{}: {}", who, repeat, result.runs[i].error));
    break;  // the others fail alike
  }
  if (!result.repeats_agree) {
    notes.push_back(fmt::format("{}: THE REPEATS' TRAJECTORIES DIFFER.", who));
  }
}

/// Figures of a few pairs say little of a run, however whole it is.
void add_pairing_notes(const Comparison& comparison, std::vector<std::string>& notes) {
  for (const ComparedRecording& recording : comparison.recordings) {
    for (std::size_t m = 0; m < recording.results.size(); ++m) {
      const std::optional<Evaluation>& evaluation = recording.results[m].evaluation;
      if (!evaluation || 2 * evaluation->pairs >= evaluation->most_pairs) continue;
      notes.push_back(fmt::format(
          "{}, {}: only {} poses are paired, of {} that could be: the figures are of "
          "these alone (--max-diff, --pair interpolate, --offset).",
          recording.name, comparison.methods[m].label, evaluation->pairs, evaluation->most_pairs));
    }
  }
}

}  // namespace

double relative_factor(const PairOptions& stretches) {
  return stretches.unit == DeltaUnit::metres ? 100.0 / stretches.delta : 1.0;
}

std::string relative_figure_name(const PairOptions& stretches) {
  const bool metres = stretches.unit == DeltaUnit::metres;
  return fmt::format("Relative over {}, RMSE ({})", stretch_text(stretches), metres ? "%" : "m");
}

std::vector<Table> comparison_tables(const Comparison& comparison) {
  std::vector<Table> tables = {
      make_table(comparison, "Absolute pose error (APE)", absolute_figures(), true),
      make_table(comparison, "Relative error, height, attitude, drift",
                 further_error_figures(comparison.options.stretches), true),
      make_table(comparison, "Time and memory", effort_figures(comparison.repeats), false),
      make_table(comparison, "What was covered, and what went wrong", trouble_figures(), false)};
  if (auto seeds = seeds_table(comparison)) tables.insert(tables.begin(), *std::move(seeds));
  return tables;
}

std::string alignment_note(const EvaluationOptions& options) {
  const std::string_view name = name_of(kAlignmentNames, options.alignment);
  return options.alignment_poses == 0
             ? fmt::format("Errors are taken after alignment '{}' over all poses.", name)
             : fmt::format("Errors are taken after alignment '{}' over the first {} poses.", name,
                           options.alignment_poses);
}

std::vector<std::string> trouble_notes(const Comparison& comparison) {
  std::vector<std::string> notes;
  for (const ComparedRecording& recording : comparison.recordings) {
    for (std::size_t m = 0; m < recording.results.size(); ++m) {
      add_result_notes(recording, comparison.methods[m].label, recording.results[m], notes);
    }
  }
  return notes;
}

std::vector<std::string> comparison_notes(const Comparison& comparison) {
  std::vector<std::string> notes = {alignment_note(comparison.options)};
  notes.push_back(
      fmt::format("Best in bold, second best underlined, among runs that cover at least "
                  "{:g} % of the truth and did not diverge.",
                  100.0 * comparison.rules.full_coverage));
  if (!seeded_scenes(comparison).empty()) {
    notes.push_back(
        fmt::format("Over the seeds of a scene: median (lowest to highest). {}: the range overlaps "
                    "with that of the smallest median, the difference is within the spread.",
                    kOverlapMark));
  }
  add_pairing_notes(comparison, notes);
  const int jobs = most_jobs(comparison);
  if (jobs > 1) {
    notes.push_back(
        fmt::format("Up to {} runs shared the machine while times were measured: times "
                    "are longer than those of a run alone.",
                    jobs));
  }
  const std::vector<std::string> troubles = trouble_notes(comparison);
  notes.insert(notes.end(), troubles.begin(), troubles.end());
  if (comparison.repeats > 1 && troubles.empty()) {
    notes.push_back(fmt::format("{} repeats each: all trajectories are the same, byte for byte.",
                                comparison.repeats));
  }
  return notes;
}

std::string tables_markdown(const Comparison& comparison, const Marks& marks) {
  std::string text;
  for (const Table& table : comparison_tables(comparison)) {
    text += fmt::format("## {}\n\n{}\n", table.title, to_markdown(table, marks));
  }
  for (const std::string& note : comparison_notes(comparison)) text += "- " + note + '\n';
  return text;
}

std::string tables_latex(const Comparison& comparison) {
  std::string text = "% needs \\usepackage{booktabs}\n";
  for (const std::string& note : comparison_notes(comparison)) text += "% " + note + '\n';
  for (const Table& table : comparison_tables(comparison)) text += '\n' + to_latex(table);
  return text;
}

std::string tables_csv(const Comparison& comparison) {
  std::string text = "table,sequence,figure,method,value,text,place\n";
  for (const Table& table : comparison_tables(comparison)) text += to_csv(table);
  return text;
}

}  // namespace surefoot::evaluation
