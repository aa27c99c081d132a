// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "evaluation/comparison_tables.hpp"

namespace surefoot::evaluation {

namespace {

constexpr double kLost = std::numeric_limits<double>::infinity();

/// A figure of a whole run.
using FigureOf = std::function<std::optional<double>(const Evaluation&)>;

std::optional<double> ape_rmse(const Evaluation& evaluation) {
  return evaluation.absolute.front().statistics.rmse;
}

/// None for a run that is too short for one stretch.
FigureOf relative_rmse(const PairOptions& stretches) {
  return [factor = relative_factor(stretches)](const Evaluation& evaluation) {
    const Statistics* found = find_statistics(evaluation, "rpe_translation");
    return found == nullptr ? std::nullopt : std::optional(factor * found->rmse);
  };
}

SeedSpread spread_of(const Comparison& comparison, const std::vector<std::size_t>& recordings,
                     std::size_t method, const FigureOf& figure) {
  std::vector<double> values;
  for (const std::size_t r : recordings) {
    const MethodResult& result = comparison.recordings[r].results[method];
    const bool whole = result.verdict.outcome == Outcome::whole && result.evaluation.has_value();
    const std::optional<double> value = whole ? figure(*result.evaluation) : kLost;
    if (value) values.push_back(*value);
  }
  if (values.empty()) return {.median = kLost, .low = kLost, .high = kLost};
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {.median = 0.5 * (values[(n - 1) / 2] + values[n / 2]),
          .low = values.front(),
          .high = values.back(),
          .seeds = static_cast<int>(n),
          .lost = static_cast<int>(std::count(values.begin(), values.end(), kLost))};
}

std::string end_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : "lost";
}

Cell cell_of(const SeedSpread& spread) {
  if (spread.seeds == 0) return {"\u2013"};
  if (!std::isfinite(spread.median)) {
    return {fmt::format("lost {} of {}", spread.lost, spread.seeds)};
  }
  return {
      fmt::format("{:.3f} ({} to {})", spread.median, end_text(spread.low), end_text(spread.high)),
      spread.median, true};
}

TableRow row_of(const SeededScene& scene, const std::string& figure,
                const std::vector<SeedSpread>& spreads) {
  TableRow row{
      .heads = {fmt::format("{} ({} seeds)", scene.name, scene.recordings.size()), figure}};
  for (const SeedSpread& spread : spreads) row.cells.push_back(cell_of(spread));
  const auto best = std::min_element(
      spreads.begin(), spreads.end(),
      [](const SeedSpread& a, const SeedSpread& b) { return a.median < b.median; });
  for (std::size_t m = 0; m < spreads.size(); ++m) {
    const bool other = m != static_cast<std::size_t>(best - spreads.begin());
    if (other && row.cells[m].value && overlap(spreads[m], *best)) {
      row.cells[m].text.insert(0, kOverlapMark);
    }
  }
  return row;
}

}  // namespace

std::vector<SeededScene> seeded_scenes(const Comparison& comparison) {
  std::vector<SeededScene> scenes;
  for (std::size_t r = 0; r < comparison.recordings.size(); ++r) {
    const std::string& name = comparison.recordings[r].scene;
    if (name.empty()) continue;
    auto scene = std::find_if(scenes.begin(), scenes.end(),
                              [&](const SeededScene& s) { return s.name == name; });
    if (scene == scenes.end()) scene = scenes.insert(scene, {.name = name});
    scene->recordings.push_back(r);
  }
  std::erase_if(scenes, [](const SeededScene& scene) { return scene.recordings.size() < 2; });
  for (SeededScene& scene : scenes) {
    for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
      scene.ape.push_back(spread_of(comparison, scene.recordings, m, ape_rmse));
      scene.relative.push_back(
          spread_of(comparison, scene.recordings, m, relative_rmse(comparison.options.stretches)));
    }
  }
  return scenes;
}

bool overlap(const SeedSpread& a, const SeedSpread& b) {
  return a.low <= b.high && b.low <= a.high;
}

std::optional<Table> seeds_table(const Comparison& comparison) {
  const std::vector<SeededScene> scenes = seeded_scenes(comparison);
  if (scenes.empty()) return std::nullopt;
  Table table{.title = "Over the seeds of a scene", .head_names = {"Sequence", "Figure"}};
  for (const ComparedMethod& method : comparison.methods) table.columns.push_back(method.label);
  const std::string relative = relative_figure_name(comparison.options.stretches);
  for (const SeededScene& scene : scenes) {
    table.rows.push_back(row_of(scene, "APE, RMSE (m)", scene.ape));
    table.rows.push_back(row_of(scene, relative, scene.relative));
  }
  rank_rows(table);
  return table;
}

}  // namespace surefoot::evaluation
