// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/method_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/synthetic_run.hpp"

namespace surefoot::runs {
namespace {

/// Values that differ from the default, one of which the parameter's range may allow.
std::vector<std::string> other_values(const ParameterInfo& info) {
  std::vector<std::string> values;
  for (std::size_t from = 0;
       info.range.find('|') != std::string::npos && from < info.range.size();) {
    const std::size_t bar = std::min(info.range.find(" | ", from), info.range.size());
    values.push_back(info.range.substr(from, bar - from));
    from = bar + 3;
  }
  for (const char* value : {"true", "false", "3", "7", "0.3", "0.7", "1.5", "32", "500"}) {
    values.emplace_back(value);
  }
  std::erase(values, info.default_value);
  return values;
}

/// False if no other value is valid beside the others'.
bool change(Config& config, const ParameterInfo& info) {
  for (const std::string& value : other_values(info)) {
    try {
      Config changed = config;
      set_parameter(changed, info.name, value);
      validate(changed);
      if (get_parameter(changed, info.name) == get_parameter(config, info.name)) continue;
      config = changed;
      return true;
    } catch (const ConfigError&) {
    }
  }
  return false;
}

class MethodParameters : public testing::TestWithParam<std::string> {};

/// What a method reads of the shared ones is written by hand: what it calls unread must change no
/// bit.
TEST_P(MethodParameters, WhatIsNotReadChangesNothing) {
  const Config config = method_config(GetParam());
  Config changed = config;
  int unread = 0;
  for (const ParameterInfo& info : parameters()) {
    if (reads_parameter(config, info.name)) continue;
    EXPECT_TRUE(change(changed, info)) << info.name << ": " << info.range;
    ++unread;
  }
  EXPECT_GT(unread, 20);
  Twist velocity = Twist::Zero();
  velocity[0] = 0.8;
  velocity[5] = 0.2;
  const Pose start{Eigen::Quaterniond::Identity(), {-2.0, 0.5, 0.5}};
  const std::vector<Scan> scans = test::take_scans(
      test::furnished_hall(), test::constant_velocity(start, velocity), 6, {.columns = 180});
  Odometry plain(config), other(changed);
  EXPECT_TRUE(test::same_bits(test::add_scans(plain, scans), test::add_scans(other, scans)));
}

/// Every method, not its variants; but the coupled registration reads what the stages do not.
std::vector<std::string> plain_methods() {
  std::vector<std::string> names = {"paper-coupled"};
  for (const std::string& name : methods()) {
    if (method_config(name).method == name) names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, MethodParameters, testing::ValuesIn(plain_methods()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(RequireParameter, NamesWhoReadsIt) {
  EXPECT_NO_THROW(require_parameter(method_config("paper"), "deskew.segments"));
  EXPECT_NO_THROW(require_parameter(method_config("icp"), "preprocess.max_range"));
  try {
    require_parameter(method_config("icp"), "map.radius");
    ADD_FAILURE() << "taken";
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(
        text.starts_with("map.radius: method icp does not read it; what reads it: surefoot, "
                         "paper."))
        << text;
  }
}

}  // namespace
}  // namespace surefoot::runs
