// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/method_variant.hpp"

#include <gtest/gtest.h>

namespace surefoot::experiments {
namespace {

TEST(MethodVariant, NameAlone) {
  const MethodVariant variant = parse_variant("paper-cv");
  EXPECT_EQ(variant.label, "paper-cv");
  EXPECT_EQ(variant.method, "paper-cv");
  EXPECT_TRUE(variant.settings.empty());
}

TEST(MethodVariant, WithSettings) {
  const MethodVariant variant = parse_variant("paper+deskew.segments=8+map.voxel_size=0.5");
  EXPECT_EQ(variant.method, "paper");
  EXPECT_EQ(variant.settings,
            (std::vector<std::string>{"deskew.segments=8", "map.voxel_size=0.5"}));
  const Config config = variant_config(variant, {"deskew.segments=2", "map.radius=50"});
  EXPECT_EQ(get_parameter(config, "deskew.segments"), "8")
      << "its own setting comes after the common one";
  EXPECT_EQ(config.map.radius, 50.0);
}

void expect_refused(const std::vector<std::string>& texts, const std::string& named) {
  try {
    for (const MethodVariant& variant : parse_variants(texts)) (void)variant_config(variant, {});
    ADD_FAILURE() << texts.front() << " was taken";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
  }
}

TEST(MethodVariant, NonsenseIsRefusedByName) {
  expect_refused({""}, "METHOD");
  expect_refused({"+deskew.segments=8"}, "METHOD");
  expect_refused({"magic"}, "'magic'");
  expect_refused({"paper+"}, "key=value");
  expect_refused({"paper+deskew.segments"}, "deskew.segments");
  expect_refused({"paper+deskew.segments=8+"}, "key=value");
  expect_refused({"paper+deskew.speed=1"}, "deskew.speed");
  expect_refused({"paper+deskew.segments=0"}, "paper+deskew.segments=0");
  expect_refused({"paper", "paper-cv", "paper"}, "twice");
}

}  // namespace
}  // namespace surefoot::experiments
