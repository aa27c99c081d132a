// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/comparison_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluation/comparison_tables.hpp"
#include "evaluation/evaluation_json.hpp"
#include "evaluation/seeds.hpp"

namespace surefoot::evaluation {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kComparisonFormat = 1;  // changes when a key changes its meaning or goes

Json json_of(const ComparedMethod& method) {
  Json parameters = Json::object();
  for (const auto& [name, value] : method.parameters) parameters[name] = value;
  return {{"label", method.label}, {"method", method.method}, {"parameters", parameters}};
}

Json json_of(const MeasuredRun& run) {
  Json json = {{"folder", run.folder},
               {"exit_code", run.exit_code},
               {"signal", run.signal},
               {"error", run.error},
               {"wall_s", run.wall_seconds},
               {"processor_s", run.processor_seconds},
               {"peak_memory_bytes", run.peak_memory_bytes},
               {"jobs", run.jobs},
               {"scans", run.scans},
               {"unreadable", run.unreadable},
               {"statuses", Json::object()},
               {"time_per_scan_ms", {{"median", run.median_ms}, {"p99", run.p99_ms}}}};
  for (const auto& [status, count] : run.statuses) json["statuses"][status] = count;
  return json;
}

Json json_of(const RepeatSpread& spread) {
  return {{"median", spread.median}, {"min", spread.min}, {"max", spread.max}};
}

Json json_of(const MethodResult& result, const std::string& method) {
  Json json = {{"method", method},
               {"outcome", to_string(result.verdict.outcome)},
               {"outcome_text", result.verdict.text},
               {"ranked", result.verdict.outcome == Outcome::whole},
               {"repeats_agree", result.repeats_agree},
               {"median_time_per_scan_ms", json_of(spread_of(result, &MeasuredRun::median_ms))},
               {"p99_time_per_scan_ms", json_of(spread_of(result, &MeasuredRun::p99_ms))},
               {"peak_memory_bytes", peak_memory(result)},
               {"evaluation", nullptr},
               {"evaluation_from_start", nullptr},
               {"runs", Json::array()}};
  if (result.evaluation) json["evaluation"] = evaluation::json_of(*result.evaluation);
  if (result.from_start) json["evaluation_from_start"] = evaluation::json_of(*result.from_start);
  for (const MeasuredRun& run : result.runs) json["runs"].push_back(json_of(run));
  return json;
}

Json json_of(const ComparedRecording& recording, const std::vector<ComparedMethod>& methods) {
  Json json = {{"name", recording.name},
               {"path", recording.path},
               {"truth", recording.truth},
               {"scene", recording.scene},
               {"fingerprint", recording.fingerprint},
               {"truth_length_m", recording.truth_length},
               {"truth_duration_s", recording.truth_duration},
               {"results", Json::array()}};
  for (std::size_t m = 0; m < recording.results.size(); ++m) {
    json["results"].push_back(json_of(recording.results[m], methods[m].label));
  }
  return json;
}

/// JSON has no infinity: what is lost is null.
Json json_of(const SeedSpread& spread) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return {{"median", number(spread.median)},
          {"min", number(spread.low)},
          {"max", number(spread.high)},
          {"lost", spread.lost}};
}

Json json_of(const SeededScene& scene, const Comparison& comparison) {
  Json json = {{"name", scene.name}, {"recordings", Json::array()}, {"results", Json::array()}};
  for (const std::size_t r : scene.recordings) {
    json["recordings"].push_back(comparison.recordings[r].name);
  }
  for (std::size_t m = 0; m < scene.ape.size(); ++m) {
    json["results"].push_back({{"method", comparison.methods[m].label},
                               {"ape_rmse_m", json_of(scene.ape[m])},
                               {"relative_rmse", json_of(scene.relative[m])}});
  }
  return json;
}

Json json_of(const Table& table) {
  Json json = {{"title", table.title}, {"rows", Json::array()}};
  for (const TableRow& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
      const Cell& cell = row.cells[column];
      Json entry = {{"method", table.columns[column]}, {"text", cell.text}};
      entry["value"] = cell.value ? Json(*cell.value) : Json(nullptr);
      entry["place"] =
          cell.place == Place::none ? Json(nullptr) : Json(cell.place == Place::first ? 1 : 2);
      cells.push_back(std::move(entry));
    }
    json["rows"].push_back(
        {{"sequence", row.heads[0]}, {"figure", row.heads[1]}, {"cells", cells}});
  }
  return json;
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json json = {
      {"format", "surefoot-comparison"},
      {"format_version", kComparisonFormat},
      {"program", {{"version", comparison.version}, {"build", comparison.build}}},
      {"machine", {{"processor", comparison.processor}, {"cores", comparison.processor_cores}}},
      {"repeats", comparison.repeats},
      {"most_jobs", most_jobs(comparison)},
      {"run_arguments", comparison.run_arguments},
      {"evaluation", evaluation::json_of(comparison.options)},
      {"rules",
       {{"cover", comparison.cover},
        {"full_coverage", comparison.rules.full_coverage},
        {"standing_share", comparison.rules.standing_share},
        {"least_divergence_m", comparison.rules.least_divergence}}},
      {"notes", comparison_notes(comparison)},
      {"methods", Json::array()},
      {"recordings", Json::array()},
      {"scenes", Json::array()},
      {"tables", Json::array()}};
  for (const ComparedMethod& method : comparison.methods) {
    json["methods"].push_back(json_of(method));
  }
  for (const ComparedRecording& recording : comparison.recordings) {
    json["recordings"].push_back(json_of(recording, comparison.methods));
  }
  for (const SeededScene& scene : seeded_scenes(comparison)) {
    json["scenes"].push_back(json_of(scene, comparison));
  }
  for (const Table& table : comparison_tables(comparison)) json["tables"].push_back(json_of(table));
  return json_text(json);
}

}  // namespace surefoot::evaluation
