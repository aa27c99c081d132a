// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/statistics.hpp"
#include "surefoot/quantile.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace surefoot::evaluation {
namespace {

TEST(Statistics, OfAnEvenCount) {
  const std::array<double, 4> errors = {4.0, 1.0, 3.0, 2.0};
  const Statistics s = statistics_of(errors);
  EXPECT_EQ(s.count, 4U);
  EXPECT_DOUBLE_EQ(s.min, 1.0);
  EXPECT_DOUBLE_EQ(s.max, 4.0);
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.sse, 30.0);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(7.5));
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(1.25)) << "divided by the count";
}

TEST(Statistics, OfAnOddCountAndOfOne) {
  const std::array<double, 3> errors = {9.0, 1.0, 2.0};
  EXPECT_DOUBLE_EQ(statistics_of(errors).median, 2.0);
  const std::array<double, 1> one = {5.0};
  EXPECT_DOUBLE_EQ(statistics_of(one).median, 5.0);
  EXPECT_DOUBLE_EQ(statistics_of(one).std, 0.0);
}

TEST(Statistics, OfNothingIsAnError) {
  EXPECT_THROW((void)statistics_of({}), std::invalid_argument);
}

TEST(Quantile, IsTheNearestOfTwoAlikeTheLower) {
  EXPECT_EQ(quantile(std::vector<double>{}, 0.5), 0.0);
  EXPECT_EQ(quantile(std::vector{3.0}, 0.99), 3.0);
  EXPECT_EQ(quantile(std::vector{5.0, 1.0, 4.0, 2.0, 3.0}, 0.5), 3.0);
  EXPECT_EQ(quantile(std::vector{4.0, 1.0, 3.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile(std::vector{4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_EQ(quantile(std::vector{1, 2, 3}, 0.98), 3);
  EXPECT_EQ(quantile(std::vector{1, 2, 3}, 0.02), 1);
}

}  // namespace
}  // namespace surefoot::evaluation
