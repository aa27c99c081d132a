// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot ablate: tables that equal the comparison that they stand on, nothing done twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kReferences = 5;

class Ablate : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    write_bend_recording(scratch_.path() / "left", 0.6, 5);
    write_bend_recording(scratch_.path() / "right", -0.8, 5);
  }
  [[nodiscard]] std::string content(const std::string& file) const {
    return file_content(scratch_.path() / file);
  }
  [[nodiscard]] json parsed(const std::string& file) const {
    return json::parse(content(file), nullptr, false);
  }

  ScratchFolder scratch_;
};

/// By method, from compare.json; infinite where a run is not whole.
double error_in(const json& comparison, std::size_t method) {
  const json& result = comparison["recordings"][0]["results"][method];
  if (result["outcome"] != "whole") return HUGE_VAL;
  return result["evaluation"]["errors"]["ape_translation"]["rmse"];
}

/// Without one of its parts a method may lose a recording altogether.
bool any_failed(const json& comparison) {
  const json& results = comparison["recordings"][0]["results"];
  return std::any_of(results.begin(), results.end(),
                     [](const json& result) { return result["outcome"] == "failed"; });
}

TEST_P(Ablate, RatiosAreThoseOfTheComparison) {
  const std::vector<std::string> command = {"ablate", "left", "--method", GetParam(),
                                            "-j",     "2",    "-o",       "out"};
  const ProcessResult printed = run_surefoot(command, scratch_.path());
  const json ablation = parsed("out/ablation.json"), comparison = parsed("out/compare.json");
  ASSERT_TRUE(ablation.is_object() && comparison.is_object()) << printed;
  EXPECT_EQ(printed.exit_code, any_failed(comparison) ? 1 : 0) << printed;
  EXPECT_EQ(ablation["references"], kReferences);
  EXPECT_EQ(ablation["rows"][0]["method"], GetParam());
  ASSERT_GT(ablation["rows"].size(), 15U);
  ASSERT_EQ(ablation["rows"].size(), comparison["methods"].size());
  std::vector<double> references;
  for (std::size_t m = 0; m < kReferences; ++m) references.push_back(error_in(comparison, m));
  // A control that changes nothing says of nothing that it is within the spread.
  std::set<double> different(references.begin(), references.end());
  EXPECT_EQ(different.size(), kReferences);
  std::sort(references.begin(), references.end());
  for (std::size_t m = kReferences; m < ablation["rows"].size(); ++m) {
    EXPECT_EQ(ablation["rows"][m]["method"], comparison["methods"][m]["label"]);
    const double error = error_in(comparison, m);
    const json& ratio = ablation["rows"][m]["recordings"][0]["ratio"];
    EXPECT_EQ(ratio.is_null(), std::isinf(error)) << ablation["rows"][m];
    if (ratio.is_number()) {
      EXPECT_DOUBLE_EQ(ratio, error / references[kReferences / 2]);
    }
  }
  const std::string markdown = content("out/ablation.md");
  EXPECT_EQ(printed.output.substr(0, markdown.size()), markdown);
  EXPECT_NE(content("out/ablation.csv").find("What each contribution is worth,"),
            std::string::npos);
#ifdef SUREFOOT_HAS_PICTURES
  EXPECT_NE(content("out/figures/ablation.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(content("out/figures/ablation.png").substr(1, 3), "PNG");
#endif

  const ProcessResult again = run_surefoot(command, scratch_.path());
  EXPECT_EQ(again.exit_code, printed.exit_code) << again;
  const std::string done = std::to_string(ablation["rows"].size()) + " done before";
  EXPECT_NE(again.errors.find(done), std::string::npos) << again;
  EXPECT_EQ(content("out/ablation.md"), markdown);
}

TEST_P(Ablate, ARecordingWithoutTruthIsRefused) {
  fs::remove(scratch_.path() / "right/gt.tum");
  const ProcessResult refused =
      run_surefoot({"ablate", "left", "right", "--method", GetParam()}, scratch_.path());
  EXPECT_EQ(refused.exit_code, 2) << refused;
  EXPECT_NE(refused.errors.find("right/gt.tum"), std::string::npos) << refused;
  EXPECT_FALSE(fs::exists(scratch_.path() / "results")) << refused;
}

INSTANTIATE_TEST_SUITE_P(Methods, Ablate, testing::Values("paper", "surefoot"));

}  // namespace
}  // namespace surefoot::test
