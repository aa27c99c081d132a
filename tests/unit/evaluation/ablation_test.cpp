// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// An ablation's arithmetic, against the definitions written out with plain loops.
#include "evaluation/ablation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "evaluation/ablation_tables.hpp"

namespace surefoot::evaluation {
namespace {

constexpr double kLost = std::numeric_limits<double>::infinity();
using Errors = std::vector<std::vector<double>>;  // by method, by recording

MethodResult finished_with(double error) {
  MethodResult result;
  if (error == kLost) {
    result.verdict = {Outcome::stopped, "stopped at 41 %"};
    error = 1e-6;  // of the part that it covers: must not be looked at
  } else {
    result.verdict = {Outcome::whole, ""};
  }
  Evaluation evaluation;
  evaluation.absolute = {{"ape_translation", "m", {.count = 1, .rmse = error}}};
  result.evaluation = evaluation;
  return result;
}

Comparison comparison_of(const Errors& errors) {
  Comparison comparison{.version = "1", .build = "b"};
  for (std::size_t m = 0; m < errors.size(); ++m) {
    comparison.methods.push_back({"paper+x=" + std::to_string(m), "paper", {}});
  }
  for (std::size_t r = 0; r < errors[0].size(); ++r) {
    comparison.recordings.push_back({.name = "walk" + std::to_string(r)});
    for (const auto& method : errors) {
      comparison.recordings.back().results.push_back(finished_with(method[r]));
    }
  }
  return comparison;
}

std::vector<AblationChange> changes(std::size_t count) {
  std::vector<AblationChange> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back({"Deskewing", "change " + std::to_string(i), "(5)"});
  }
  return result;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : std::sqrt(values[n / 2 - 1] * values[n / 2]);
}

// Three references and two changes on four recordings.
const Errors kErrors = {{0.10, 0.30, 2.00, 0.05},
                        {0.12, 0.20, 1.00, 0.06},
                        {0.11, 0.70, 4.00, 0.04},
                        {0.44, 0.90, 0.50, 0.05},    // 4, 3, 0.25, 1 times
                        {0.33, 0.15, kLost, 0.20}};  // 3, 0.5, lost, 4 times

TEST(Ablation, RatiosAreToTheReferencesMedian) {
  const Ablation ablation = ablate(comparison_of(kErrors), changes(5), 3);
  for (std::size_t r = 0; r < 4; ++r) {
    const double usual = median({kErrors[0][r], kErrors[1][r], kErrors[2][r]});
    EXPECT_DOUBLE_EQ(ablation.usual[r], usual);
    EXPECT_DOUBLE_EQ(ablation.rows[3].ratios[r].value(), kErrors[3][r] / usual);
  }
  EXPECT_EQ(ablation.recordings, (std::vector<std::string>{"walk0", "walk1", "walk2", "walk3"}));
  EXPECT_NEAR(ablation.rows[3].median.value(), std::sqrt(3.0), 1e-12);  // of 0.25, 1, 3, 4
  EXPECT_NEAR(ablation.rows[3].low.value(), 0.25, 1e-12);
  EXPECT_NEAR(ablation.rows[3].high.value(), 4.0, 1e-12);
  EXPECT_EQ(ablation.rows[3].worse, 2);
  EXPECT_EQ(ablation.rows[3].better, 1);
  EXPECT_EQ(ablation.rows[3].lost, 0);
}

TEST(Ablation, AReferencesRatioIsToTheOthers) {
  const Ablation ablation = ablate(comparison_of(kErrors), changes(5), 3);
  for (std::size_t m = 0; m < 3; ++m) {
    std::vector<double> ratios;
    for (std::size_t r = 0; r < 4; ++r) {
      const double others = std::sqrt(kErrors[(m + 1) % 3][r] * kErrors[(m + 2) % 3][r]);
      EXPECT_NEAR(ablation.rows[m].ratios[r].value(), kErrors[m][r] / others, 1e-12);
      ratios.push_back(kErrors[m][r] / others);
    }
    EXPECT_NEAR(ablation.rows[m].median.value(), median(ratios), 1e-12);
  }
}

// All 3^4 ways to take one reference for each recording, instead of some at random.
TEST(Ablation, TheSpreadHolds99PercentOfTheReferencesMedians) {
  const Ablation ablation = ablate(comparison_of(kErrors), changes(5), 3);
  int within = 0, below = 0;
  for (std::size_t way = 0; way < 81; ++way) {
    std::vector<double> ratios;
    for (std::size_t r = 0, left = way; r < 4; ++r, left /= 3) {
      ratios.push_back(ablation.rows[left % 3].ratios[r].value());
    }
    const double factor = std::max(median(ratios), 1.0 / median(ratios));
    within += factor <= ablation.spread * (1.0 + 1e-12) ? 1 : 0;
    below += factor < ablation.spread * (1.0 - 1e-12) ? 1 : 0;
  }
  EXPECT_GE(within, 80);
  EXPECT_LE(below, 80);
  EXPECT_GT(ablation.spread, 1.0);
  EXPECT_EQ(ablate(comparison_of(kErrors), changes(5), 3).spread, ablation.spread);
}

TEST(Ablation, BelowTheSpreadIsAsFarOnEitherSide) {
  const Ablation ablation{.spread = 1.25};
  for (const double median : {1.0, 1.25, 0.8}) {
    EXPECT_TRUE(is_below_spread({.median = median}, ablation)) << median;
  }
  for (const double median : {1.26, 0.79, 0.0, kLost}) {
    EXPECT_FALSE(is_below_spread({.median = median}, ablation)) << median;
  }
}

TEST(Ablation, ALostRunIsInfinitelyWorseAndCountedByItself) {
  const Ablation ablation = ablate(comparison_of(kErrors), changes(5), 3);
  const AblationRow& row = ablation.rows[4];
  EXPECT_EQ(row.errors[2], kLost);
  EXPECT_EQ(row.outcomes[2], "stopped at 41 %");
  EXPECT_NEAR(row.median.value(), std::sqrt(3.0 * 4.0), 1e-12);  // of 0.5, 3, 4, lost
  EXPECT_EQ(row.high, kLost);
  EXPECT_EQ(row.worse, 2);
  EXPECT_EQ(row.better, 0);  // half is not beyond a factor of two
  EXPECT_EQ(row.lost, 1);
}

TEST(Ablation, WhereTheMethodItselfIsLostNothingIsSaid) {
  Errors errors = kErrors;
  errors[0][1] = errors[1][1] = kLost;  // two of the three references
  const Ablation ablation = ablate(comparison_of(errors), changes(5), 3);
  EXPECT_FALSE(ablation.rows[3].ratios[1].has_value());
  EXPECT_EQ(ablation.usual[1], kLost);
  EXPECT_NEAR(ablation.rows[3].median.value(), 1.0, 1e-12);  // of 0.25, 1, 4
  EXPECT_EQ(ablation.rows[0].lost, 1);
}

TEST(Ablation, WhereNothingIsComparableNothingIsKnown) {
  Errors errors = kErrors;
  for (std::vector<double>& method : errors) method = {kLost, kLost, kLost, kLost};
  errors[3] = kErrors[3];
  const Comparison comparison = comparison_of(errors);
  const Ablation ablation = ablate(comparison, changes(5), 3);
  EXPECT_FALSE(ablation.rows[3].median.has_value());
  const std::vector<Cell> cells = ablation_tables(ablation)[0].rows[3].cells;
  EXPECT_EQ(cells[0].text, "\u2013");
  EXPECT_FALSE(cells[0].value.has_value());
  EXPECT_EQ(cells[6].text, "not known");
  const nlohmann::json json = nlohmann::json::parse(ablation_json(ablation, comparison));
  for (const char* key : {"median_ratio", "lowest_ratio", "highest_ratio", "below_spread"}) {
    EXPECT_TRUE(json["rows"][3][key].is_null()) << key;
  }
  EXPECT_TRUE(json["spread"].is_null());
}

TEST(Ablation, OneReferenceAloneHasNoSpread) {
  const Ablation ablation = ablate(comparison_of({{0.2, 0.3}, {0.2, 0.3}}), changes(2), 1);
  EXPECT_EQ(ablation.spread, 1.0);
  EXPECT_TRUE(is_below_spread(ablation.rows[1], ablation));  // nothing has changed
  const std::vector<std::string> notes =
      ablation_notes(ablation, comparison_of({{0.2, 0.3}, {0.2, 0.3}}));
  EXPECT_NE(notes[3].find("spread is not known"), std::string::npos);
}

TEST(Ablation, NeedsAReferenceAndAChangeForEachMethod) {
  EXPECT_THROW((void)ablate(comparison_of(kErrors), changes(5), 0), std::invalid_argument);
  EXPECT_THROW((void)ablate(comparison_of(kErrors), changes(5), 6), std::invalid_argument);
  EXPECT_THROW((void)ablate(comparison_of(kErrors), changes(4), 3), std::invalid_argument);
}

TEST(AblationTables, SayTheSameInEveryForm) {
  const Comparison comparison = comparison_of(kErrors);
  const Ablation ablation = ablate(comparison, changes(5), 3);
  const std::vector<Table> tables = ablation_tables(ablation);
  ASSERT_EQ(tables.size(), 2U);
  const std::vector<Cell>& worth = tables[0].rows[3].cells;
  EXPECT_EQ(worth[0].text, "1.73");
  EXPECT_EQ(worth[0].value, ablation.rows[3].median);
  EXPECT_EQ(worth[3].text, "2");
  EXPECT_EQ(tables[0].rows[4].cells[2].text, "lost");
  EXPECT_EQ(tables[0].rows[0].cells[6].text, "reference");
  EXPECT_EQ(tables[0].rows[4].cells[6].text,
            is_below_spread(ablation.rows[4], ablation) ? "below the spread" : "worse");
  EXPECT_EQ(tables[1].rows[4].cells[2].text, "stopped at 41 %");
  EXPECT_EQ(tables[1].rows[3].cells[0].text, "0.440");

  const nlohmann::json json = nlohmann::json::parse(ablation_json(ablation, comparison));
  EXPECT_EQ(json["format"], "surefoot-ablation");
  EXPECT_EQ(json["references"], 3);
  EXPECT_EQ(json["spread"], ablation.spread);
  EXPECT_EQ(json["rows"][3]["median_ratio"], ablation.rows[3].median);
  EXPECT_EQ(json["rows"][3]["method"], "paper+x=3");
  EXPECT_TRUE(json["rows"][4]["highest_ratio"].is_null());
  EXPECT_TRUE(json["rows"][4]["recordings"][2]["ape_rmse_m"].is_null());
  EXPECT_EQ(json["rows"][4]["recordings"][2]["outcome_text"], "stopped at 41 %");

  const std::string csv = ablation_csv(ablation);
  EXPECT_NE(csv.find("APE RMSE (m),Deskewing,change 3,(5),walk1,0.9,0.900,\n"), std::string::npos)
      << csv;
  const std::string markdown = ablation_markdown(ablation, comparison);
  EXPECT_NE(markdown.find(" 1.73 |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("a factor of"), std::string::npos) << markdown;
}

}  // namespace
}  // namespace surefoot::evaluation
