// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The parameter table: every row there and back, everything wrong refused with a full message.
#include "surefoot/config.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "config/config_fields.hpp"
#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {
namespace {

bool is_number(const ConfigField& field) {
  Config config;
  const FieldSlot slot = field.slot(config);
  return std::holds_alternative<double*>(slot) || std::holds_alternative<int*>(slot);
}

/// The message of the ConfigError that setting a parameter throws; empty if it throws none.
std::string refusal(const char* name, const std::string& value) {
  Config config;
  try {
    set_parameter(config, name, value);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

TEST(Config, EveryParameterIsDescribed) {
  std::set<std::string> names;
  for (const ParameterInfo& info : parameters()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " stands twice";
    EXPECT_FALSE(info.default_value.empty()) << info.name;
    EXPECT_FALSE(info.range.empty()) << info.name;
    EXPECT_FALSE(info.help.empty()) << info.name;
    EXPECT_FALSE(info.source.empty()) << info.name;
  }
  EXPECT_GT(names.size(), 40U);
}

TEST(Config, DefaultsAreTheTablesAndAreValid) {
  const Config config;
  validate(config);
  for (const ParameterInfo& info : parameters()) {
    Config other;
    set_parameter(other, info.name, info.default_value);
    EXPECT_EQ(get_parameter(other, info.name), get_parameter(config, info.name));
  }
}

TEST(Config, EveryNumberComesBackToTheSameValueFromBothEndsOfItsRange) {
  for (const ConfigField& field : config_fields()) {
    if (!is_number(field)) continue;
    for (const double share : {0.0, 0.37, 1.0}) {
      Config config, again;
      const FieldSlot slot = field.slot(config);
      const double value = field.min + share * (field.max - field.min);
      if (const auto* number = std::get_if<double*>(&slot)) **number = value;
      if (const auto* number = std::get_if<int*>(&slot)) **number = static_cast<int>(value);
      set_parameter(again, field.name, get_parameter(config, field.name));
      const FieldSlot slot_again = field.slot(again);
      if (std::holds_alternative<double*>(slot)) {
        EXPECT_EQ(*std::get<double*>(slot), *std::get<double*>(slot_again)) << field.name;
      } else {
        EXPECT_EQ(*std::get<int*>(slot), *std::get<int*>(slot_again)) << field.name;
      }
    }
  }
}

/// Who is told a range may give its ends.
TEST(Config, TheEndsOfAToldRangeAreTaken) {
  for (const ConfigField& field : config_fields()) {
    if (!is_number(field)) continue;
    Config config;
    const std::string told = range_text(field, config);
    const std::size_t gap = told.find(" .. ");
    ASSERT_NE(gap, std::string::npos) << told;
    EXPECT_NO_THROW(set_parameter(config, field.name, told.substr(0, gap))) << told;
    EXPECT_NO_THROW(set_parameter(config, field.name, told.substr(gap + 4))) << told;
  }
}

TEST(Config, LargeWholeNumbersComeBackAsWholeNumbers) {
  for (const char* name : {"preprocess.min_points", "health.min_matches", "health.restart_after"}) {
    for (const char* value : {"99999", "100000", "1000000"}) {
      Config config;
      set_parameter(config, name, value);
      EXPECT_EQ(get_parameter(config, name), value) << name;
      EXPECT_NO_THROW(validate(config)) << name << " = " << value;
    }
  }
}

TEST(Config, SettingOneParameterChangesNoOther) {
  for (const ConfigField& field : config_fields()) {
    if (!is_number(field)) continue;
    Config config;
    const std::string text = std::to_string(static_cast<int>(field.max));
    set_parameter(config, field.name, text);
    for (const ConfigField& other : config_fields()) {
      if (std::string(other.name) == field.name) continue;
      EXPECT_EQ(get_parameter(config, other.name), get_parameter(Config(), other.name));
    }
  }
}

TEST(Config, EveryWordOfAChoiceComesBack) {
  const std::pair<const char*, std::vector<const char*>> choices[] = {
      {"deskew.mode", {"none", "constant_velocity", "piecewise"}},
      {"registration.mode", {"decoupled", "coupled"}},
      {"registration.coupled_residual", {"point_to_point", "point_to_plane"}},
      {"vertical.residual", {"point_to_point", "point_to_plane"}},
      {"level.mode", {"ground", "mount", "none"}}};
  for (const auto& [name, words] : choices) {
    for (const char* word : words) {
      Config config;
      set_parameter(config, name, word);
      EXPECT_EQ(get_parameter(config, name), word);
    }
    const std::string message = refusal(name, "sideways");
    for (const char* word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
  }
}

TEST(Config, ValuesOutOfRangeAreRefusedNamingKeyValueRangeAndUnit) {
  for (const ConfigField& field : config_fields()) {
    if (!is_number(field)) continue;
    const ParameterInfo* info = nullptr;
    for (const ParameterInfo& row : parameters()) info = row.name == field.name ? &row : info;
    ASSERT_NE(info, nullptr);
    for (const double value : {field.min - 1.0, field.max + 1.0}) {
      const std::string text = std::to_string(static_cast<long>(value));
      const std::string message = refusal(field.name, text);
      for (const std::string& part : {info->name, text, info->range, info->unit}) {
        EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
      }
    }
  }
}

TEST(Config, NonsenseIsRefusedAndChangesNothing) {
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "1e999", "4x", "0x10", "1,5", "--1", "four", "1 2", "\n3"}) {
    for (const char* name : {"deskew.segments", "deskew.clamp_z", "deskew.mode"}) {
      Config config;
      EXPECT_THROW(set_parameter(config, name, text), ConfigError) << name << " = " << text;
      EXPECT_EQ(get_parameter(config, name), get_parameter(Config(), name));
    }
  }
  EXPECT_NE(refusal("deskew.segments", "4.5"), "");
}

TEST(Config, UnknownNamesAreRefusedByName) {
  Config config;
  for (const char* name : {"", "deskew", "deskew.", "Deskew.segments", "deskew.segments "}) {
    EXPECT_THROW(set_parameter(config, name, "1"), ConfigError);
    EXPECT_THROW((void)get_parameter(config, name), ConfigError);
  }
  EXPECT_NE(refusal("deskew.segmets", "4").find("deskew.segmets"), std::string::npos);
}

TEST(Config, ValidateFindsWhatWasAssignedPastTheTable) {
  for (const ConfigField& field : config_fields()) {
    if (!is_number(field)) continue;
    Config config;
    const FieldSlot slot = field.slot(config);
    if (const auto* number = std::get_if<double*>(&slot)) {
      **number = std::numeric_limits<double>::quiet_NaN();
    }
    if (const auto* number = std::get_if<int*>(&slot)) **number = -1000;
    EXPECT_THROW(validate(config), ConfigError) << field.name;
  }
}

/// Whether a method's parameters are accepted with these values.
bool valid(const std::string& method,
           const std::vector<std::pair<const char*, const char*>>& values) {
  Config config = method_config(method);
  for (const auto& [name, value] : values) set_parameter(config, name, value);
  try {
    validate(config);
  } catch (const ConfigError&) {
    return false;
  }
  return true;
}

TEST(Config, ValidateFindsContradictions) {
  EXPECT_FALSE(valid("icp", {{"preprocess.min_range", "50"}, {"preprocess.max_range", "20"}}));
  EXPECT_FALSE(valid("surefoot", {{"knots.min_points", "500"}}));
  EXPECT_FALSE(valid("surefoot", {{"knots.kernel_decay", "0.99"}}));
  EXPECT_FALSE(valid("surefoot", {{"knots.max_iterations", "7"}}));
  EXPECT_TRUE(valid("surefoot", {{"knots.max_iterations", "8"}}));
  EXPECT_TRUE(valid("surefoot", {{"knots.kernel_decay", "0"}}));
  EXPECT_TRUE(valid("surefoot", {{"knots.kernel_start", "0.1"}, {"knots.max_iterations", "5"}}));
  EXPECT_FALSE(valid("paper", {{"registration.max_distance", "2"},  //
                               {"registration.relaxed_distance", "1"}}));
  // A search farther than eight cells of the map.
  EXPECT_TRUE(valid("paper", {{"map.voxel_size", "0.5"}, {"registration.relaxed_distance", "4"}}));
  EXPECT_FALSE(
      valid("paper", {{"map.voxel_size", "0.5"}, {"registration.relaxed_distance", "4.01"}}));
  EXPECT_FALSE(valid("icp", {{"icp.max_correspondence_distance", "1.5"}}));
  EXPECT_FALSE(valid("floam", {{"floam.scan_line", "20"}}));
  EXPECT_FALSE(valid("ct-icp", {{"ct_icp.default_radius", "4.01"}}));
  EXPECT_FALSE(valid("ct-icp", {{"ct_icp.max_num_neighbors", "19"}}));
}

TEST(Config, WhatAnotherMethodWouldRefuseIsNoContradiction) {
  EXPECT_TRUE(valid("surefoot", {{"registration.max_distance", "3"}, {"floam.scan_line", "20"}}));
  EXPECT_TRUE(valid("paper", {{"knots.min_points", "500"}, {"icp.voxel_size", "0.5"}}));
}

TEST(Config, MethodsAreValidAndDifferFromThePapersWhereTheirNameSays) {
  for (const std::string& name : methods()) validate(method_config(name));
  const auto paper = [](const char* name) {
    return own_parameters<PaperParameters>(method_config(name));
  };
  EXPECT_EQ(paper("paper").deskew.mode, DeskewMode::piecewise);
  EXPECT_EQ(paper("paper").registration.mode, RegistrationMode::decoupled);
  EXPECT_EQ(paper("paper").registration.target, TargetKind::point);
  EXPECT_EQ(paper("paper-surface").registration.target, TargetKind::surface);
  EXPECT_EQ(paper("paper-cv").deskew.mode, DeskewMode::constant_velocity);
  EXPECT_EQ(paper("paper-no-deskew").deskew.mode, DeskewMode::none);
  EXPECT_EQ(paper("paper-coupled").registration.mode, RegistrationMode::coupled);
  EXPECT_THROW((void)method_config("magic"), ConfigError);
}

TEST(Config, ThePapersMethodHasItsOwnValues) {
  // Section 3.2 states these; not up to a sweep.
  const auto deskew = own_parameters<PaperParameters>(method_config("paper")).deskew;
  EXPECT_EQ(deskew.segments, 4);
  EXPECT_EQ(deskew.clamp_z, 0.5);
  EXPECT_EQ(deskew.clamp_roll, 0.2);
  EXPECT_EQ(deskew.clamp_pitch, 0.2);
}

}  // namespace
}  // namespace surefoot
