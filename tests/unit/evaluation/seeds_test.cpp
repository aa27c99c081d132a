// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/seeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluation/comparison_json.hpp"
#include "evaluation/comparison_tables.hpp"

namespace surefoot::evaluation {
namespace {

MethodResult result_of(double ape, Outcome outcome = Outcome::whole) {
  MethodResult result;
  result.verdict = {outcome, outcome == Outcome::whole ? "" : "diverged"};
  Evaluation evaluation;
  evaluation.absolute = {{"ape_translation", "m", {.count = 1, .rmse = ape}}};
  evaluation.relative = {{"rpe_translation", "m", {.count = 1, .rmse = 0.5 * ape}}};
  result.evaluation = evaluation;
  return result;
}

/// Two scenes of three and of two seeds, one recording that is one of a kind.
Comparison three_methods() {
  Comparison comparison;
  comparison.options.stretches = {.delta = 10.0, .unit = DeltaUnit::metres};
  for (const char* label : {"good", "near", "far"}) comparison.methods.push_back({label, "paper"});
  const auto add = [&](const char* scene, double good, double near, const MethodResult& far) {
    comparison.recordings.push_back({.name = std::string("r") + scene, .scene = scene});
    comparison.recordings.back().results = {result_of(good), result_of(near), far};
  };
  add("campus-trot", 0.12, 0.20, result_of(0.9));
  add("forest-trot", 0.10, 0.10, result_of(0.1, Outcome::diverged));
  add("campus-trot", 0.10, 0.14, result_of(0.1, Outcome::diverged));
  add("", 1.0, 1.0, result_of(1.0));
  add("campus-trot", 0.15, 0.30, result_of(0.5));
  add("forest-trot", 0.30, 0.30, result_of(0.1, Outcome::diverged));
  return comparison;
}

TEST(Seeds, MedianAndEndsOfEachMethod) {
  const std::vector<SeededScene> scenes = seeded_scenes(three_methods());
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[0].name, "campus-trot");
  EXPECT_EQ(scenes[0].recordings, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(scenes[0].ape[0].median, 0.12);
  EXPECT_EQ(scenes[0].ape[0].low, 0.10);
  EXPECT_EQ(scenes[0].ape[0].high, 0.15);
  EXPECT_DOUBLE_EQ(scenes[0].relative[0].median, 0.5 * 0.12 * 100.0 / 10.0);
  EXPECT_DOUBLE_EQ(scenes[1].ape[0].median, 0.2);  // of two: the mean
  EXPECT_EQ(scenes[0].ape[2].lost, 1);
  EXPECT_EQ(scenes[0].ape[2].median, 0.9);
  EXPECT_TRUE(std::isinf(scenes[0].ape[2].high));
  EXPECT_EQ(scenes[1].ape[2].lost, 2);
}

TEST(Seeds, OneSeedAloneHasNoSpread) {
  Comparison comparison = three_methods();
  comparison.recordings.pop_back();  // of the forest's two
  const std::vector<SeededScene> scenes = seeded_scenes(comparison);
  ASSERT_EQ(scenes.size(), 1U);
  EXPECT_EQ(scenes[0].name, "campus-trot");
}

TEST(Seeds, AFigureThatNoWholeRunHasIsNotLost) {
  Comparison comparison = three_methods();
  for (ComparedRecording& recording : comparison.recordings) {
    recording.results[0].evaluation->relative.clear();  // too short for one stretch
  }
  const SeededScene scene = seeded_scenes(comparison).at(0);
  EXPECT_EQ(scene.relative[0].seeds, 0);
  EXPECT_EQ(scene.relative[0].lost, 0);
  const std::vector<Cell> cells = seeds_table(comparison)->rows[1].cells;
  EXPECT_EQ(cells[0].text, "\u2013");
  EXPECT_EQ(cells[1].place, Place::first);
}

TEST(Seeds, RangesOverlapAlsoWhereTheyOnlyTouch) {
  const SeedSpread a{.low = 1.0, .high = 2.0};
  EXPECT_TRUE(overlap(a, {.low = 2.0, .high = 3.0}));
  EXPECT_TRUE(overlap({.low = 2.0, .high = 3.0}, a));
  EXPECT_TRUE(overlap(a, {.low = 1.2, .high = 1.3}));
  EXPECT_FALSE(overlap(a, {.low = 2.1, .high = 3.0}));
  EXPECT_FALSE(overlap({.low = 2.1, .high = 3.0}, a));
}

TEST(Seeds, TheTableMarksWhatIsWithinTheSpread) {
  const std::optional<Table> table = seeds_table(three_methods());
  ASSERT_TRUE(table.has_value());
  ASSERT_EQ(table->rows.size(), 4U);
  EXPECT_EQ(table->rows[0].heads[0], "campus-trot (3 seeds)");
  EXPECT_EQ(table->rows[1].heads[1], "Relative over 10 m, RMSE (%)");
  const std::vector<Cell>& cells = table->rows[0].cells;
  EXPECT_EQ(cells[0].text, "0.120 (0.100 to 0.150)");
  EXPECT_EQ(cells[0].place, Place::first);
  EXPECT_EQ(cells[1].text, "\u2248 0.200 (0.140 to 0.300)");
  EXPECT_EQ(cells[2].text, "0.900 (0.500 to lost)");
  EXPECT_EQ(table->rows[2].cells[2].text, "lost 2 of 2");
  EXPECT_EQ(table->rows[2].cells[2].place, Place::none);
}

TEST(Seeds, StandFirstAmongTheTablesAndInTheJson) {
  Comparison comparison = three_methods();
  EXPECT_EQ(comparison_tables(comparison)[0].title, "Over the seeds of a scene");
  const nlohmann::json json = nlohmann::json::parse(to_json(comparison));
  ASSERT_EQ(json["scenes"].size(), 2U);
  EXPECT_EQ(json["scenes"][0]["recordings"].size(), 3U);
  EXPECT_EQ(json["scenes"][0]["results"][1]["ape_rmse_m"]["max"], 0.30);
  EXPECT_TRUE(json["scenes"][0]["results"][2]["ape_rmse_m"]["max"].is_null());
  EXPECT_EQ(json["recordings"][1]["scene"], "forest-trot");
  for (ComparedRecording& recording : comparison.recordings) recording.scene.clear();
  EXPECT_FALSE(seeds_table(comparison).has_value());
  EXPECT_EQ(comparison_tables(comparison).size(), 4U);
}

}  // namespace
}  // namespace surefoot::evaluation
