// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "evaluation/comparison_json.hpp"
#include "evaluation/comparison_tables.hpp"
#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

constexpr int kPoses = 400;

/// A method that wanders off by `off` [m], and ends with pose `poses`.
MethodResult method_result(double off, int poses, double milliseconds) {
  const Trajectory reference = test::winding_walk(kPoses);
  Trajectory estimate = test::winding_walk(poses);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    estimate[i].pose.translation.z() += off * std::sin(0.1 * static_cast<double>(i));
  }
  MethodResult result;
  result.evaluation = evaluate("e", reference, estimate, {});
  result.from_start = evaluate("e", reference, estimate, {.alignment = AlignmentMethod::origin});
  result.verdict = judge(reference, estimate, *result.evaluation, {});
  for (const double factor : {1.0, 3.0, 2.0}) {
    result.runs.push_back({.folder = "runs/walk/m/1",
                           .exit_code = 0,
                           .peak_memory_bytes = static_cast<std::uint64_t>(factor * 1048576.0),
                           .scans = 400,
                           .median_ms = factor * milliseconds,
                           .p99_ms = 2.0 * factor * milliseconds,
                           .statuses = {{"ok", 397}, {"first_scan", 1}, {"degenerate", 2}}});
  }
  return result;
}

MethodResult failed_result() {
  MethodResult result;
  result.verdict = {Outcome::failed, "failed"};
  result.runs.push_back({.signal = 9, .error = "ended by signal 9"});
  return result;
}

/// Third, best, second, stopped (with the smallest error of all), failed.
Comparison five_methods() {
  Comparison comparison{.version = "1", .build = "b", .repeats = 3};
  comparison.options.stretches = {.delta = 2.0, .unit = DeltaUnit::metres, .all_pairs = true};
  for (const char* label : {"third", "best", "second", "stopped", "dead"}) {
    comparison.methods.push_back({label, "paper", {{"deskew.segments", "4"}}});
  }
  ComparedRecording recording{.name = "walk", .path = "/r/walk", .truth = "/r/walk/gt.tum"};
  recording.results = {method_result(0.3, kPoses, 5.0), method_result(0.1, kPoses, 7.0),
                       method_result(0.2, kPoses, 6.0), method_result(0.001, 150, 1.0),
                       failed_result()};
  comparison.recordings = {recording};
  return comparison;
}

const Cell& cell(const Table& table, const std::string& figure, std::size_t method) {
  for (const TableRow& row : table.rows) {
    if (row.heads[1] == figure) return row.cells.at(method);
  }
  ADD_FAILURE() << "no figure " << figure;
  return table.rows.at(0).cells.at(0);
}

TEST(ComparisonTables, WhatStoppedIsShownAsSuchAndRankedNowhere) {
  const std::vector<Table> tables = comparison_tables(five_methods());
  ASSERT_EQ(tables.size(), 4U);
  for (const Table& table : tables) {
    for (const TableRow& row : table.rows) {
      for (const std::size_t method : {3U, 4U}) {
        EXPECT_EQ(row.cells[method].place, Place::none) << table.title << ", " << row.heads[1];
      }
    }
  }
  for (const Table* errors : {&tables[0], &tables[1]}) {
    EXPECT_EQ(errors->rows[0].cells[3].text, "stopped at 37 %");
    EXPECT_EQ(errors->rows[0].cells[4].text, "failed");
    for (const TableRow& row : errors->rows) EXPECT_FALSE(row.cells[3].value.has_value());
  }
  for (const char* figure : {"Maximum (m)", "Mean (m)", "RMSE (m)", "std (m)"}) {
    EXPECT_EQ(cell(tables[0], figure, 0).place, Place::none) << figure;
    EXPECT_EQ(cell(tables[0], figure, 1).place, Place::first) << figure;
    EXPECT_EQ(cell(tables[0], figure, 2).place, Place::second) << figure;
  }
}

TEST(ComparisonTables, FiguresAreTheEvaluations) {
  const Comparison comparison = five_methods();
  const std::vector<Table> tables = comparison_tables(comparison);
  const Evaluation& best = *comparison.recordings[0].results[1].evaluation;
  const double rmse = best.absolute[0].statistics.rmse;
  EXPECT_EQ(cell(tables[0], "RMSE (m)", 1).value, rmse);
  EXPECT_EQ(cell(tables[1], "Relative over 2 m, RMSE (%)", 1).value,
            50.0 * best.relative[0].statistics.rmse);
  EXPECT_EQ(cell(tables[1], "Drift at the end (%)", 1).value, best.drift.percent);
  EXPECT_EQ(cell(tables[1], "Roll and pitch since the start, RMS (deg)", 1).value,
            comparison.recordings[0].results[1].from_start->absolute[6].statistics.rmse);
}

TEST(ComparisonTables, TimesAreMediansWithTheirSpread) {
  const std::vector<Table> tables = comparison_tables(five_methods());
  EXPECT_EQ(cell(tables[2], "Time a scan, median (ms)", 0).text, "10.00");
  EXPECT_EQ(cell(tables[2], "Time a scan, median (ms)", 0).place, Place::first);
  EXPECT_EQ(cell(tables[2], "Time a scan, median (ms)", 3).text, "2.00");
  EXPECT_EQ(cell(tables[2], "Median over the repeats (ms)", 0).text, "5.00..15.00");
  EXPECT_EQ(cell(tables[2], "p99 over the repeats (ms)", 0).text, "10.00..30.00");
  EXPECT_EQ(cell(tables[2], "Peak memory (MiB)", 0).text, "3.0");
  EXPECT_EQ(cell(tables[2], "Peak memory (MiB)", 4).text, "\u2013");
}

TEST(ComparisonTables, TheMedianOfTwoRepeatsIsTheirMean) {
  MethodResult result = method_result(0.1, kPoses, 5.0);
  result.runs.pop_back();  // 5 and 15 are left
  EXPECT_EQ(spread_of(result, &MeasuredRun::median_ms).median, 10.0);
}

TEST(ComparisonTables, TheFirstScanIsNoTrouble) {
  const std::vector<Table> tables = comparison_tables(five_methods());
  EXPECT_EQ(cell(tables[3], "Scans that were not ok", 0).text, "2 degenerate");
  EXPECT_EQ(cell(tables[3], "Outcome", 0).text, "whole");
  EXPECT_EQ(cell(tables[3], "Coverage (%)", 3).text, "37.3");
}

TEST(ComparisonTables, ScansThatCouldNotBeReadAreTold) {
  Comparison comparison = five_methods();
  for (MeasuredRun& run : comparison.recordings[0].results[0].runs) run.unreadable = 2;
  comparison.recordings[0].results[1].runs.front().statuses = {{"ok", 399}, {"first_scan", 1}};
  comparison.recordings[0].results[1].runs.front().unreadable = 1;
  const std::vector<Table> tables = comparison_tables(comparison);
  EXPECT_EQ(cell(tables[3], "Scans that were not ok", 0).text, "2 degenerate, 2 unreadable");
  EXPECT_EQ(cell(tables[3], "Scans that were not ok", 1).text, "1 unreadable");
  const nlohmann::json json = nlohmann::json::parse(to_json(comparison));
  EXPECT_EQ(json["recordings"][0]["results"][0]["runs"][0]["unreadable"], 2);
}

bool any_note(const Comparison& comparison, const std::string& part) {
  for (const std::string& note : comparison_notes(comparison)) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(ComparisonNotes, TellFiguresOfAFewPairs) {
  Comparison comparison = five_methods();
  EXPECT_FALSE(any_note(comparison, "are paired"));
  const Trajectory reference = test::winding_walk(kPoses);
  Trajectory estimate = reference;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    if (i % 100 != 0) estimate[i].stamp_ns += 30'000'000;  // --max-diff is 10 ms
  }
  comparison.recordings[0].results[0].evaluation = evaluate("e", reference, estimate, {});
  EXPECT_TRUE(any_note(comparison, "walk, third: only 4 poses are paired, of 399 that could be"))
      << tables_markdown(comparison);
  EXPECT_EQ(cell(comparison_tables(comparison)[3], "Poses paired", 0).text, "4 of 400");
}

TEST(ComparisonNotes, TellFailuresSharedMachinesAndRepeats) {
  Comparison comparison = five_methods();
  EXPECT_TRUE(any_note(comparison, "walk, dead: ended by signal 9"));
  EXPECT_FALSE(any_note(comparison, "shared the machine"));
  EXPECT_FALSE(any_note(comparison, "the same, byte for byte"));
  comparison.recordings[0].results[0].runs[2].jobs = 2;
  EXPECT_TRUE(any_note(comparison, "Up to 2 runs shared the machine"));
  comparison.recordings[0].results.pop_back();
  comparison.methods.pop_back();
  EXPECT_TRUE(any_note(comparison, "3 repeats each: all trajectories are the same"));
  comparison.recordings[0].results[1].repeats_agree = false;
  EXPECT_TRUE(any_note(comparison, "walk, best: THE REPEATS' TRAJECTORIES DIFFER"));
  EXPECT_FALSE(any_note(comparison, "the same, byte for byte"));
}

TEST(ComparisonJson, HoldsTablesAndFigures) {
  const Comparison comparison = five_methods();
  const nlohmann::json json = nlohmann::json::parse(to_json(comparison));
  EXPECT_EQ(json["format"], "surefoot-comparison");
  EXPECT_EQ(json["methods"][1]["parameters"]["deskew.segments"], "4");
  const nlohmann::json& results = json["recordings"][0]["results"];
  ASSERT_EQ(results.size(), 5U);
  EXPECT_EQ(results[3]["outcome"], "stopped");
  EXPECT_EQ(results[3]["ranked"], false);
  EXPECT_TRUE(results[4]["evaluation"].is_null());
  EXPECT_EQ(results[4]["runs"][0]["signal"], 9);
  EXPECT_EQ(results[0]["runs"][0]["statuses"]["degenerate"], 2);
  const double rmse = comparison.recordings[0].results[1].evaluation->absolute[0].statistics.rmse;
  EXPECT_EQ(results[1]["evaluation"]["errors"]["ape_translation"]["rmse"], rmse);
  const nlohmann::json& row = json["tables"][0]["rows"][2];
  EXPECT_EQ(row["figure"], "RMSE (m)");
  EXPECT_EQ(row["cells"][1]["value"], rmse);
  EXPECT_EQ(row["cells"][1]["place"], 1);
  EXPECT_TRUE(row["cells"][3]["place"].is_null());
}

TEST(ComparisonFiles, HaveEveryTable) {
  const Comparison comparison = five_methods();
  const std::string markdown = tables_markdown(comparison), latex = tables_latex(comparison),
                    csv = tables_csv(comparison);
  for (const Table& table : comparison_tables(comparison)) {
    EXPECT_NE(markdown.find("## " + table.title), std::string::npos);
    EXPECT_NE(latex.find("% " + table.title), std::string::npos);
    EXPECT_NE(csv.find(csv_field(table.title) + ","), std::string::npos);
  }
  EXPECT_EQ(csv.rfind("table,sequence,figure,method,value,text,place\n", 0), 0U);
}

}  // namespace
}  // namespace surefoot::evaluation
