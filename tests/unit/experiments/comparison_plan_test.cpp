// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_plan.hpp"

#include <gtest/gtest.h>

#include <set>

namespace surefoot::experiments {
namespace {

using Place = std::tuple<int, std::size_t, std::size_t>;

Place place(const PlannedRun& run) { return {run.repeat, run.input, run.variant}; }

TEST(ComparisonPlan, RepeatsAreOutermost) {
  const std::vector<PlannedRun> runs = plan_runs(2, 3, 2);
  ASSERT_EQ(runs.size(), 12U);
  EXPECT_EQ(place(runs[0]), Place(1, 0, 0));
  EXPECT_EQ(place(runs[1]), Place(1, 0, 1));
  EXPECT_EQ(place(runs[3]), Place(1, 1, 0));
  EXPECT_EQ(place(runs[6]), Place(2, 0, 0));
}

TEST(ComparisonPlan, PartsAreTheWholeAndShareNothing) {
  const std::vector<PlannedRun> runs = plan_runs(3, 3, 1);
  std::multiset<Place> found, all;
  for (const PlannedRun& run : runs) all.insert(place(run));
  for (const std::size_t number : {1U, 2U, 3U, 4U}) {
    for (const PlannedRun& run : share_of(runs, {number, 4})) found.insert(place(run));
  }
  EXPECT_EQ(found, all);
  EXPECT_EQ(place(share_of(runs, {3, 9}).at(0)), place(runs[2]));
  EXPECT_TRUE(share_of(runs, {12, 12}).empty());
}

TEST(ComparisonPlan, ALineForEachRun) {
  const std::vector<CompareInput> inputs = {{"hall", "/a/hall", "/a/hall/gt.tum", {}}};
  const std::vector<MethodVariant> variants = {{"icp", "icp", {}}, {"p+a=1", "p", {"a=1"}}};
  EXPECT_EQ(runs_text(plan_runs(1, 2, 1), inputs, variants),
            R"({"part":"1/2","recording":"/a/hall","method":"icp","repeat":1,)"
            R"("folder":"runs/hall/icp/1"})"
            "\n"
            R"({"part":"2/2","recording":"/a/hall","method":"p+a=1","repeat":1,)"
            R"("folder":"runs/hall/p+a=1/1"})"
            "\n");
}

}  // namespace
}  // namespace surefoot::experiments
