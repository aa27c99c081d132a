// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/tables.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

// An estimate that is `off` metres too high all the time, and ends with pose `poses`.
Evaluation too_high(const std::string& name, double off, int poses = 100) {
  const Trajectory reference = test::winding_walk(100);
  Trajectory estimate = test::winding_walk(poses);
  for (StampedPose& stamped : estimate) stamped.pose.translation.z() += off;
  return evaluate(name, reference, estimate, {.alignment = AlignmentMethod::none});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Evaluate, FillsEveryFigure) {
  const Evaluation evaluation = too_high("walk", 0.5, 50);
  EXPECT_EQ(evaluation.name, "walk");
  EXPECT_EQ(evaluation.pairs, 50U);
  EXPECT_NEAR(evaluation.coverage, 49.0 / 99.0, 1e-9);
  ASSERT_EQ(evaluation.absolute.size(), 8U);
  EXPECT_EQ(evaluation.absolute[0].name, "ape_translation");
  EXPECT_NEAR(evaluation.absolute[0].statistics.rmse, 0.5, 1e-12);
  EXPECT_EQ(evaluation.absolute[5].name, "ape_vertical");
  EXPECT_NEAR(evaluation.absolute[5].statistics.mean, 0.5, 1e-12);
  EXPECT_EQ(evaluation.relative.size(), 6U);
  EXPECT_FALSE(evaluation.segments.by_length.empty());
  EXPECT_NEAR(evaluation.drift.total, 0.0, 1e-9);
}

TEST(Evaluate, ARunTooShortForAStretchHasNoRelativeErrors) {
  const Trajectory walk = test::winding_walk(5);
  const Evaluation evaluation = evaluate(
      "short", walk, walk, {.alignment = AlignmentMethod::none, .stretches = {.delta = 50.0}});
  EXPECT_TRUE(evaluation.relative.empty());
  EXPECT_FALSE(contains(to_csv({evaluation}), "rpe"));
}

TEST(Tables, AnEndThatIsHardlyTooLowIsNotMinusZero) {
  const Trajectory reference = test::winding_walk(100);
  Trajectory estimate = reference;
  estimate.back().pose.translation.z() -= 1e-9;
  const Evaluation low = evaluate("low", reference, estimate, {.alignment = AlignmentMethod::none});
  EXPECT_TRUE(contains(to_text({low}), "vertical +0.0000 m")) << to_text({low});
}

TEST(Tables, CsvHasALineForEachErrorAndQuotesNames) {
  const std::vector<std::string> lines = lines_of(to_csv({too_high("a, \"b\"", 0.5)}));
  ASSERT_EQ(lines.size(), 15U);
  EXPECT_EQ(lines[0], "estimate,error,unit,count,max,mean,median,min,rmse,std,sse");
  EXPECT_EQ(lines[1].rfind("\"a, \"\"b\"\"\",ape_translation,m,100,0.5", 0), 0U) << lines[1];
}

TEST(Tables, JsonNamesEveryFigure) {
  const std::string json = to_json({too_high("walk", 0.5)});
  for (const char* key :
       {"\"estimate\": \"walk\"", "\"pairs\": 100", "\"coverage\": 1.0", "\"ape_tilt\"",
        "\"rpe_translation\"", "\"translation_percent\"", "\"vertical_m\"", "\"scale\": 1.0"}) {
    EXPECT_TRUE(contains(json, key)) << key;
  }
  EXPECT_NO_THROW((void)to_json({too_high("\xFF", 0.5)})) << "a name that is not UTF-8";
}

TEST(Tables, SegmentsOfWhichThereAreNoneHaveNoErrorInJson) {
  Evaluation evaluation = too_high("walk", 0.5);
  evaluation.segments = {.by_length = {{.length = 500.0}}, .all = {}};
  const nlohmann::json json = nlohmann::json::parse(to_json({evaluation}))[0];
  EXPECT_EQ(json["segments"][0]["length_m"], 500.0);
  EXPECT_EQ(json["segments"][0]["count"], 0);
  EXPECT_TRUE(json["segments"][0]["translation_percent"].is_null());
  EXPECT_TRUE(json["segments_all"]["rotation_deg_per_m"].is_null());
}

TEST(Tables, TextSaysHowMuchWasPaired) {
  EXPECT_TRUE(contains(to_text({too_high("walk", 0.5, 50)}),
                       "walk: 50 of 50 poses paired, 49.5 % of the reference covered"));
}

TEST(Tables, LatexMarksTheBestTwoButNeverARunThatStoppedEarly) {
  const std::string latex = to_latex({too_high("third", 0.3), too_high("first_one", 0.1),
                                      too_high("second", 0.2), too_high("stopped", 0.001, 50)});
  EXPECT_TRUE(contains(latex, "first\\_one & \\textbf{0.100}")) << latex;
  EXPECT_TRUE(contains(latex, "second & \\underline{0.200}")) << latex;
  EXPECT_TRUE(contains(latex, "third & 0.300")) << latex;
  EXPECT_TRUE(contains(latex, "stopped (49 \\% covered) & 0.001")) << latex;
}

TEST(Tables, LatexRanksADriftByItsSize) {
  const auto sinking = [](const std::string& name, double end) {
    const Trajectory walk = test::winding_walk(100);
    Trajectory estimate = walk;
    estimate.back().pose.translation.z() += end;
    return evaluate(name, walk, estimate, {.alignment = AlignmentMethod::none});
  };
  const std::string latex = to_latex({sinking("low", -0.5), sinking("near", 0.1)});
  EXPECT_TRUE(contains(latex, "\\underline{-0.500}")) << latex;
  EXPECT_FALSE(contains(latex, "\\textbf{-0.500}")) << latex;
}

TEST(Tables, TextLeavesOutSegmentsOfWhichThereAreNone) {
  Evaluation evaluation = too_high("walk", 0.5);
  evaluation.segments.by_length = {{.length = 2.0, .count = 1}, {.length = 500.0}};
  EXPECT_TRUE(contains(to_text({evaluation}), "segments of 2 m:"));
  EXPECT_FALSE(contains(to_text({evaluation}), "segments of 500 m:"));
}

TEST(Tables, LatexHasEveryKindOfError) {
  const std::string latex = to_latex({too_high("low", 0.1), too_high("high", 0.3)});
  for (const char* head :
       {"Max",
        "translation (m) & rotation\\_angle (deg) & rotation\\_part & full & horizontal (m) & "
        "vertical (m) & tilt (deg) & yaw (deg)",
        "distance (m) & distance\\_percent (\\%)", "1 m (\\%)", "all (deg/m)", "Drift (\\%)",
        "Coverage (\\%)"}) {
    EXPECT_TRUE(contains(latex, head)) << head << "\n" << latex;
  }
  std::size_t tables = 0;
  for (std::size_t at = 0; (at = latex.find("\\end{tabular}", at)) != std::string::npos; ++at) {
    ++tables;
  }
  EXPECT_EQ(tables, 5U);
}

TEST(Tables, LatexLeavesOutWhatARunIsTooShortFor) {
  const Trajectory walk = test::winding_walk(5);
  const std::string latex = to_latex({evaluate(
      "short", walk, walk, {.alignment = AlignmentMethod::none, .stretches = {.delta = 50.0}})});
  EXPECT_FALSE(contains(latex, "Relative pose error")) << latex;
  EXPECT_TRUE(contains(latex, "Drift at the end")) << latex;
}

TEST(Tables, LatexHasWhatOnlyALaterRunIsLongEnoughFor) {
  const Trajectory walk = test::winding_walk(5);
  const Evaluation brief = evaluate(
      "short", walk, walk, {.alignment = AlignmentMethod::none, .stretches = {.delta = 50.0}});
  const std::string latex = to_latex({brief, too_high("long", 0.1)});
  EXPECT_TRUE(contains(latex, "Relative pose error")) << latex;
}

}  // namespace
}  // namespace surefoot::evaluation
