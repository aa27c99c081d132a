// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/ablation_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluation/comparison_tables.hpp"
#include "evaluation/evaluation_json.hpp"

namespace surefoot::evaluation {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kAblationFormat = 1;  // changes when a key changes its meaning or goes

TableRow heads_of(const AblationRow& row) {
  return {{row.change.contribution, row.change.change, row.change.equations}, {}};
}

Table empty_table(const char* title) {
  return {.title = title, .head_names = {"Contribution", "Change", "Equations"}};
}

Cell ratio_cell(const std::optional<double>& ratio) {
  if (!ratio) return {"\u2013"};
  if (!std::isfinite(*ratio)) return {"lost"};
  return {fmt::format("{:.2f}", *ratio), *ratio};
}

Cell count_cell(int count) { return {std::to_string(count), count}; }

const char* verdict_of(const AblationRow& row, const Ablation& ablation) {
  if (!row.median) return "not known";
  if (is_below_spread(row, ablation)) return "below the spread";
  return *row.median > 1.0 ? "worse" : "better";
}

Table worth_table(const Ablation& ablation) {
  Table table = empty_table("What each contribution is worth");
  table.columns = {"Ratio, median", "lowest", "highest", "Worse by > 2",
                   "Better by > 2", "Lost",   "Verdict"};
  for (std::size_t m = 0; m < ablation.rows.size(); ++m) {
    const AblationRow& row = ablation.rows[m];
    table.rows.push_back(heads_of(row));
    const bool reference = m < ablation.references;
    table.rows.back().cells = {ratio_cell(row.median),
                               ratio_cell(row.low),
                               ratio_cell(row.high),
                               count_cell(row.worse),
                               count_cell(row.better),
                               count_cell(row.lost),
                               {reference ? "reference" : verdict_of(row, ablation)}};
  }
  return table;
}

Table error_table(const Ablation& ablation) {
  Table table = empty_table("APE RMSE (m)");
  table.columns = ablation.recordings;
  for (const AblationRow& row : ablation.rows) {
    table.rows.push_back(heads_of(row));
    for (std::size_t r = 0; r < row.errors.size(); ++r) {
      const bool lost = !std::isfinite(row.errors[r]);
      table.rows.back().cells.push_back(
          lost ? Cell{row.outcomes[r]} : Cell{fmt::format("{:.3f}", row.errors[r]), row.errors[r]});
    }
  }
  return table;
}

/// JSON has no infinity: what is lost is null, as what is not known.
Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// Whether there are references that can be compared with each other.
bool has_spread(const Ablation& ablation) {
  return ablation.references > 1 && ablation.rows.front().median.has_value();
}

Json json_of(const AblationRow& row, const std::string& label, const Ablation& ablation) {
  Json json = {{"contribution", row.change.contribution},
               {"change", row.change.change},
               {"equations", row.change.equations},
               {"method", label},
               {"median_ratio", number_or_null(row.median)},
               {"lowest_ratio", number_or_null(row.low)},
               {"highest_ratio", number_or_null(row.high)},
               {"worse", row.worse},
               {"better", row.better},
               {"lost", row.lost},
               {"below_spread", row.median ? Json(is_below_spread(row, ablation)) : Json(nullptr)},
               {"recordings", Json::array()}};
  for (std::size_t r = 0; r < row.errors.size(); ++r) {
    json["recordings"].push_back({{"name", ablation.recordings[r]},
                                  {"ape_rmse_m", number_or_null(row.errors[r])},
                                  {"ratio", number_or_null(row.ratios[r])},
                                  {"outcome_text", row.outcomes[r]}});
  }
  return json;
}

}  // namespace

std::vector<Table> ablation_tables(const Ablation& ablation) {
  return {worth_table(ablation), error_table(ablation)};
}

std::vector<std::string> ablation_notes(const Ablation& ablation, const Comparison& comparison) {
  std::vector<std::string> notes = {
      alignment_note(comparison.options),
      fmt::format("Ratio: APE RMSE over that of the method as it is, which is the median of its {} "
                  "references; for a reference, of the other ones. Above 1: the change makes it "
                  "worse.",
                  ablation.references),
      "Lost: failed, stopped, diverged or does not cover the truth; in the median it counts as "
      "infinitely worse."};
  notes.push_back(
      ablation.references < 2 ? "There is one reference: the spread is not known."
      : !has_spread(ablation)
          ? "No recording has references to compare: nothing is known, nor the spread."
          : fmt::format("By chance, as the references show it, a median ratio differs from 1 by up "
                        "to a factor of {:.2f} (99 %): a smaller difference is below the spread.",
                        ablation.spread));
  for (const std::string& note : trouble_notes(comparison)) notes.push_back(note);
  return notes;
}

std::string ablation_markdown(const Ablation& ablation, const Comparison& comparison) {
  std::string text;
  for (const Table& table : ablation_tables(ablation)) {
    text += fmt::format("## {}\n\n{}\n", table.title, to_markdown(table));
  }
  for (const std::string& note : ablation_notes(ablation, comparison)) text += "- " + note + '\n';
  return text;
}

std::string ablation_csv(const Ablation& ablation) {
  std::string text = "table,contribution,change,equations,column,value,text,place\n";
  for (const Table& table : ablation_tables(ablation)) text += to_csv(table);
  return text;
}

std::string ablation_json(const Ablation& ablation, const Comparison& comparison) {
  Json json = {{"format", "surefoot-ablation"},
               {"format_version", kAblationFormat},
               {"program", {{"version", comparison.version}, {"build", comparison.build}}},
               {"run_arguments", comparison.run_arguments},
               {"references", ablation.references},
               {"spread", has_spread(ablation) ? number_or_null(ablation.spread) : Json(nullptr)},
               {"notes", ablation_notes(ablation, comparison)},
               {"usual", Json::array()},
               {"rows", Json::array()}};
  for (std::size_t r = 0; r < ablation.recordings.size(); ++r) {
    json["usual"].push_back(
        {{"name", ablation.recordings[r]}, {"ape_rmse_m", number_or_null(ablation.usual[r])}});
  }
  for (std::size_t m = 0; m < ablation.rows.size(); ++m) {
    json["rows"].push_back(json_of(ablation.rows[m], comparison.methods[m].label, ablation));
  }
  return json_text(json);
}

}  // namespace surefoot::evaluation
