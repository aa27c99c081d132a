// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/ablation_plan.hpp"

#include <gtest/gtest.h>

#include <set>

namespace surefoot::experiments {
namespace {

std::vector<std::string> values(const Config& config) {
  std::vector<std::string> result;
  for (const ParameterInfo& info : parameters()) {
    result.push_back(get_parameter(config, info.name));
  }
  return result;
}

class AblationPlans : public testing::TestWithParam<std::string> {};

TEST_P(AblationPlans, EveryChangeIsPossibleAndChangesExactlyWhatItNames) {
  const AblationPlan plan = ablation_plan(GetParam());
  ASSERT_EQ(plan.variants.size(), plan.changes.size());
  EXPECT_EQ(plan.variants[0].label, GetParam());
  const std::vector<std::string> usual = values(method_config(GetParam()));
  std::set<std::vector<std::string>> seen;
  for (std::size_t i = 0; i < plan.variants.size(); ++i) {
    const std::vector<std::string> changed = values(variant_config(plan.variants[i], {}));
    EXPECT_TRUE(seen.insert(changed).second) << plan.variants[i].label << " is there twice";
    std::size_t different = 0;
    for (std::size_t p = 0; p < usual.size(); ++p) different += changed[p] != usual[p] ? 1 : 0;
    EXPECT_EQ(different, plan.variants[i].settings.size()) << plan.variants[i].label;
  }
}

TEST_P(AblationPlans, BeginsWithTheMethodAsItIsAndFourControls) {
  const AblationPlan plan = ablation_plan(GetParam());
  EXPECT_EQ(plan.references, 5U);
  for (std::size_t i = 0; i < plan.changes.size(); ++i) {
    const bool control = plan.changes[i].contribution == plan.changes[0].contribution;
    EXPECT_EQ(control, i < plan.references) << plan.changes[i].change;
  }
}

// A control that is far from what it controls shows more than chance.
TEST_P(AblationPlans, ControlsAreWithinATwentieth) {
  const AblationPlan plan = ablation_plan(GetParam());
  const Config usual = method_config(GetParam());
  for (std::size_t i = 1; i < plan.references; ++i) {
    const Config changed = variant_config(plan.variants[i], {});
    for (const std::string& setting : plan.variants[i].settings) {
      const std::string name = setting.substr(0, setting.find('='));
      EXPECT_NEAR(std::stod(get_parameter(changed, name)) / std::stod(get_parameter(usual, name)),
                  1.0, 0.05 + 1e-9)
          << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, AblationPlans, testing::ValuesIn(ablated_methods()));

TEST(AblationPlan, OtherMethodsAreRefused) {
  for (const char* method : {"kiss-icp", "magic", ""}) {
    try {
      (void)ablation_plan(method);
      ADD_FAILURE() << method << " was taken";
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find("paper, surefoot"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace surefoot::experiments
