// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The registry: what it lists is found by name, and its parameters belong to who reads them.
#include "config/method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/front_end.hpp"
#include "methods/icp/icp_parameters.hpp"

namespace surefoot {
namespace {

TEST(Registry, EveryMethodIsReachedByItsName) {
  std::set<std::string> seen;
  for (const Method* method : registered_methods()) {
    EXPECT_TRUE(seen.insert(method->name).second) << method->name << " stands twice";
    EXPECT_EQ(&find_method(method->name), method);
    const Session session{method_config(method->name), Workers(1)};
    EXPECT_EQ(session.config.method, method->name);
    EXPECT_NE(make_front_end(session), nullptr) << method->name;
    ASSERT_FALSE(method->presets().empty()) << method->name;
    EXPECT_EQ(method->presets().front().name, method->name);
    for (const Preset& preset : method->presets()) {
      EXPECT_EQ(preset.config.method, method->name) << preset.name;
      EXPECT_EQ(std::count(methods().begin(), methods().end(), preset.name), 1) << preset.name;
    }
  }
  EXPECT_EQ(Config().method, registered_methods().front()->name);
}

TEST(Registry, AMethodThatDoesNotExistIsRefusedByName) {
  Config config;
  config.method = "paper-cv";  // a variant of a method
  for (const auto& use : {validate, +[](const Config& c) { (void)reads_parameter(c, "a.b"); }}) {
    try {
      use(config);
      ADD_FAILURE() << "taken";
    } catch (const ConfigError& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("'paper-cv'"), std::string::npos) << text;
      EXPECT_NE(text.find("surefoot, paper, kiss-icp"), std::string::npos) << text;
    }
  }
}

TEST(Registry, EveryParameterIsOneMethodsOwnOrShared) {
  std::multiset<std::string> owned;
  for (const Method* method : registered_methods()) {
    for (const ConfigField& field : method->fields) owned.insert(field.name);
  }
  for (const auto& shared : {input_fields(), health_fields()}) {
    for (const ConfigField& field : shared) owned.insert(field.name);
  }
  EXPECT_EQ(owned.size(), parameters().size());
  for (const ParameterInfo& info : parameters()) EXPECT_EQ(owned.count(info.name), 1U) << info.name;
}

TEST(Registry, AMethodReadsItsOwnAndNobodyElses) {
  for (const Method* method : registered_methods()) {
    const Config config = method_config(method->name);
    for (const ConfigField& field : method->fields) {
      EXPECT_TRUE(reads_parameter(config, field.name)) << method->name << ' ' << field.name;
    }
    EXPECT_TRUE(reads_parameter(config, "preprocess.max_range"));
    for (const Method* other : registered_methods()) {
      if (other == method) continue;
      for (const ConfigField& field : other->fields) {
        const bool both = std::string(field.name) == "map.radius" &&
                          config.method == "surefoot";  // whose row is the paper's
        EXPECT_EQ(reads_parameter(config, field.name), both) << method->name << ' ' << field.name;
      }
    }
  }
  EXPECT_TRUE(reads_parameter(method_config("paper-cv"), "deskew.mode"));
  EXPECT_TRUE(reads_parameter(method_config("paper"), "motion_prior.max_extrapolation"));
  EXPECT_FALSE(reads_parameter(method_config("icp"), "motion_prior.max_extrapolation"));
  for (const char* name : {"health.restart_after", "health.min_information"}) {
    EXPECT_TRUE(reads_parameter(Config(), name)) << name;
    EXPECT_TRUE(reads_parameter(method_config("paper"), name)) << name;
    EXPECT_FALSE(reads_parameter(method_config("kiss-icp"), name)) << name;
  }
  EXPECT_TRUE(reads_parameter(method_config("kiss-icp"), "health.max_correction_deg"));
  EXPECT_FALSE(reads_parameter(Config(), "health.min_match_ratio"));
  for (const char* unknown : {"", "health.", "health.courage", "knots"}) {
    EXPECT_FALSE(reads_parameter(Config(), unknown)) << unknown;
  }
}

TEST(Registry, WhatAMethodReadsAlsoExists) {
  for (const Method* method : registered_methods()) {
    for (const auto& names : {method->also_reads, method->does_not_read}) {
      for (const std::string name : names) {
        EXPECT_TRUE(std::any_of(parameters().begin(), parameters().end(),
                                [&](const ParameterInfo& info) {
                                  return name.ends_with('.') ? info.name.starts_with(name)
                                                             : info.name == name;
                                }))
            << method->name << ' ' << name;
      }
    }
  }
}

TEST(Registry, ACopyOfAConfigHasParametersOfItsOwn) {
  Config original;
  set_parameter(original, "icp.voxel_size", "2");
  Config copy = original, assigned;
  assigned = original;
  set_parameter(copy, "icp.voxel_size", "3");
  own_parameters<IcpParameters>(assigned).voxel_size = 4.0;
  EXPECT_EQ(get_parameter(original, "icp.voxel_size"), "2");
  EXPECT_EQ(get_parameter(copy, "icp.voxel_size"), "3");
  EXPECT_EQ(get_parameter(assigned, "icp.voxel_size"), "4");
  EXPECT_EQ(get_parameter(Config(), "icp.voxel_size"), "1");
}

}  // namespace
}  // namespace surefoot
