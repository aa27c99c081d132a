// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace surefoot::experiments {
namespace {

TEST(SweepPlanTest, ListsAndRanges) {
  const SweepPlan plan =
      sweep_plan("paper", {"deskew.mode=none,piecewise", "map.voxel_size=0.1:0.5:0.1"});
  const std::vector<std::string> labels = {"unchanged",
                                           "deskew.mode = none",
                                           "deskew.mode = piecewise",
                                           "map.voxel_size = 0.1",
                                           "map.voxel_size = 0.2",
                                           "map.voxel_size = 0.3",
                                           "map.voxel_size = 0.4",
                                           "map.voxel_size = 0.5"};
  EXPECT_EQ(plan.labels, labels);
  ASSERT_EQ(plan.variants.size(), labels.size());
  EXPECT_TRUE(plan.variants[0].settings.empty());
  EXPECT_EQ(plan.variants[3].settings, std::vector<std::string>{"map.voxel_size=0.1"});
  EXPECT_EQ(plan.variants[3].method, "paper");
  EXPECT_EQ(sweep_plan("paper", {"a.b=1:4:2"}).labels.back(), "a.b = 3");
  EXPECT_EQ(sweep_plan("paper", {"a.b=1e+3"}).variants.back().settings.front(), "a.b=1e+3");
}

TEST(SweepPlanTest, WhatIsWrongIsNamed) {
  for (const char* bad : {"a.b", "a.b=", "a.b=1:2", "a.b=1:2:0", "a.b=2:1:0.1", "a.b=1:2:nan",
                          "a.b=0:1e9:1e-9", "a.b=one:2:1", "a.b=1,1"}) {
    try {
      (void)sweep_plan("paper", {bad});
      ADD_FAILURE() << "taken: " << bad;
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find("--vary"), std::string::npos) << error.what();
    }
  }
}

evaluation::MethodResult result_with(double ape, double step, double milliseconds) {
  const auto named = [](const char* name, double rmse) {
    return evaluation::NamedStatistics{name, "m", {.rmse = rmse}};
  };
  evaluation::Evaluation figures;
  figures.absolute = {named("ape_translation", ape)};
  figures.relative = {named("rpe_translation", step)};
  evaluation::MethodResult result;
  result.verdict = {evaluation::Outcome::whole, ""};
  result.evaluation = figures;
  result.runs = {{.scans = 7, .median_ms = milliseconds, .statuses = {{"ok", 5}, {"rejected", 2}}}};
  return result;
}

TEST(SweepTest, RatiosAreGeometricMeansOverWhatNeitherLost) {
  evaluation::MethodResult lost = result_with(1.0, 1.0, 3.0);
  lost.verdict = {evaluation::Outcome::stopped, "stopped at 41 %"};
  evaluation::Comparison comparison;
  comparison.methods = {{.label = "paper"}, {.label = "paper+a.b=1"}};
  comparison.recordings = {
      {.name = "one", .results = {result_with(0.1, 0.2, 1.0), result_with(0.2, 0.2, 5.0)}},
      {.name = "two", .results = {result_with(0.1, 0.2, 1.0), result_with(0.8, 0.1, 5.0)}},
      {.name = "three", .results = {result_with(0.1, 0.2, 1.0), lost}}};
  const SweepResult sweep = sweep_of(comparison, {"unchanged", "a.b = 1"});
  ASSERT_EQ(sweep.rows.size(), 2U);
  EXPECT_DOUBLE_EQ(*sweep.rows[0].ape_ratio, 1.0);
  EXPECT_DOUBLE_EQ(*sweep.rows[1].ape_ratio, 4.0);  // of 2 and 8
  EXPECT_DOUBLE_EQ(*sweep.rows[1].step_ratio, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(sweep.rows[1].milliseconds.value(), 5.0) << "of the whole runs";
  EXPECT_EQ(sweep.rows[1].untrusted, 6U);
  const std::string table = sweep_markdown(sweep);
  EXPECT_NE(table.find("| a.b = 1   | 0.200 / 0.200 | 0.800 / 0.100 | stopped at 41 % |      4.00 "
                       "|       0.71 | 5.0 |         6 |"),
            std::string::npos)
      << table;
  EXPECT_NE(sweep_csv(sweep).find("a.b = 1,three,,,stopped at 41 %\n"), std::string::npos);
  const auto json = nlohmann::json::parse(sweep_json(sweep, comparison));
  EXPECT_EQ(json["rows"][1]["recordings"][0]["ape_rmse_m"], 0.2);
  EXPECT_EQ(json["rows"][1]["recordings"][2]["lost"], "stopped at 41 %");
}

TEST(SweepTest, WhatThereIsNoFigureOfIsNotZero) {
  evaluation::MethodResult standing = result_with(0.1, 0.0, 4.0), failed = result_with(0, 0, 0);
  standing.evaluation->relative.clear();
  failed.verdict = {evaluation::Outcome::failed, "failed"};
  failed.runs.front().error = "ended with exit code 2: no scans";
  evaluation::Comparison comparison;
  comparison.methods = {{.label = "paper"}, {.label = "paper+a.b=1"}};
  comparison.recordings = {{.name = "a|b", .results = {standing, failed}}};
  const SweepResult sweep = sweep_of(comparison, {"unchanged", "a.b = 1"});
  const std::string table = sweep_markdown(sweep);
  EXPECT_NE(table.find("a\\|b"), std::string::npos) << table;
  EXPECT_NE(table.find("| 0.100 / - |"), std::string::npos) << table;
  EXPECT_NE(table.find("\n\n- a|b, paper+a.b=1: ended with exit code 2: no scans\n"),
            std::string::npos)
      << table;
  EXPECT_NE(sweep_csv(sweep).find("unchanged,a|b,0.1,,\n"), std::string::npos) << sweep_csv(sweep);
  const auto json = nlohmann::json::parse(sweep_json(sweep, comparison));
  EXPECT_TRUE(json["rows"][0]["recordings"][0]["step_rmse_m"].is_null());
  EXPECT_TRUE(json["rows"][1]["median_ms"].is_null());
  EXPECT_EQ(json["notes"][0], "a|b, paper+a.b=1: ended with exit code 2: no scans");
}

TEST(SweepTest, RunsThatLeftNoTimesCountForNone) {
  evaluation::MethodResult killed = result_with(1.0, 1.0, 0.0);
  killed.verdict = {evaluation::Outcome::stopped, "no \"scans\""};
  killed.runs.front().scans = 0;
  evaluation::Comparison comparison;
  comparison.methods = {{.label = "paper"}};
  comparison.recordings = {{.name = "one", .results = {result_with(0.1, 0.2, 4.0)}},
                           {.name = "two, again", .results = {killed}}};
  const SweepResult sweep = sweep_of(comparison, {"unchanged"});
  EXPECT_DOUBLE_EQ(sweep.rows[0].milliseconds.value(), 4.0);
  EXPECT_NE(sweep_csv(sweep).find("unchanged,\"two, again\",,,\"no \"\"scans\"\"\"\n"),
            std::string::npos)
      << sweep_csv(sweep);
}

}  // namespace
}  // namespace surefoot::experiments
