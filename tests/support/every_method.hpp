// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Tests of what every method owes its callers: each runs once per method.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "surefoot/config.hpp"

namespace surefoot::test {

/// A test that is named after the method it runs.
class EveryMethod : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] static std::string method() { return GetParam(); }
  [[nodiscard]] static Config config() { return method_config(GetParam()); }
};

inline auto each_method() { return testing::Values("surefoot", "paper"); }

inline std::string method_name(const testing::TestParamInfo<const char*>& info) {
  return info.param;
}

}  // namespace surefoot::test
