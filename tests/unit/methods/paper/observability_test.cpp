// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The vertical stage's weights, eqs. (28)-(31): every branch, and both sides of its edges.
#include "methods/paper/observability.hpp"

#include <gtest/gtest.h>

#include "registration_fixture.hpp"

namespace surefoot {
namespace {

PaperParameters::Vertical weights_config() {
  PaperParameters::Vertical config = test::step_config().vertical;
  config.near_distance = 10.0;
  config.distance_decay = 0.04;
  config.near_gate = 0.3;
  config.near_suppression = 0.05;
  config.kernel_scale = 0.2;
  return config;
}

const double kJustBelow10 = std::nextafter(10.0, 0.0);

TEST(Observability, DistanceTermIsOneUpToTheNearDistanceAndDecaysBeyond) {
  const PaperParameters::Vertical c = weights_config();
  EXPECT_EQ(distance_observability(0.0, c), 1.0);
  EXPECT_EQ(distance_observability(kJustBelow10, c), 1.0);
  EXPECT_EQ(distance_observability(10.0, c), 1.0);  // continuous there
  EXPECT_DOUBLE_EQ(distance_observability(15.0, c), 1.0 / (1.0 + 0.04 * 25.0));
  EXPECT_DOUBLE_EQ(distance_observability(60.0, c), 1.0 / (1.0 + 0.04 * 2500.0));
}

TEST(Observability, NormalTermIsTheUprightPartOfEitherSign) {
  const PaperParameters::Vertical c = weights_config();
  EXPECT_EQ(normal_observability({0.0, 0.0, 1.0}, c), 1.0);
  EXPECT_EQ(normal_observability({0.0, 0.0, -1.0}, c), 1.0);
  EXPECT_EQ(normal_observability({1.0, 0.0, 0.0}, c), 0.0);
  EXPECT_EQ(normal_observability({0.6, 0.0, -0.8}, c), 0.8);
}

TEST(Observability, NormalPowerFlattensOrSharpensTheNormalTerm) {
  PaperParameters::Vertical c = weights_config();
  c.normal_power = 0.0;  // off, also for a wall
  EXPECT_EQ(normal_observability({0.6, 0.0, -0.8}, c), 1.0);
  EXPECT_EQ(normal_observability({1.0, 0.0, 0.0}, c), 1.0);
  c.normal_power = 0.5;
  EXPECT_DOUBLE_EQ(normal_observability({0.0, 0.6, 0.8}, c), std::sqrt(0.8));
  c.normal_power = 2.0;
  EXPECT_DOUBLE_EQ(normal_observability({0.6, 0.0, -0.8}, c), 0.64);
  EXPECT_DOUBLE_EQ(observability(15.0, {0.6, 0.0, -0.8}, c), 0.5 * 0.64);
}

TEST(Observability, ScoreIsTheProduct) {
  const PaperParameters::Vertical c = weights_config();
  EXPECT_DOUBLE_EQ(observability(5.0, {0.6, 0.0, 0.8}, c), 0.8);
  EXPECT_DOUBLE_EQ(observability(15.0, {0.6, 0.0, -0.8}, c), 0.5 * 0.8);
  EXPECT_EQ(observability(5.0, {0.0, 1.0, 0.0}, c), 0.0);
}

TEST(Observability, NearResidualsCountInFullUpToTheGateThenHardlyAtAll) {
  const PaperParameters::Vertical c = weights_config();
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(robust_term(5.0, 0.0, c), 1.0);
    EXPECT_EQ(robust_term(5.0, sign * 0.3, c), 1.0);
    EXPECT_EQ(robust_term(5.0, sign * std::nextafter(0.3, 1.0), c), 0.05);
    EXPECT_EQ(robust_term(5.0, sign * 100.0, c), 0.05);
  }
}

TEST(Observability, FarResidualsFadeByCauchysKernel) {
  const PaperParameters::Vertical c = weights_config();
  for (const double r : {0.0, 0.05, 0.2, -0.2, 0.3, 0.31, -5.0}) {
    EXPECT_DOUBLE_EQ(robust_term(20.0, r, c), 0.2 * 0.2 / (0.2 * 0.2 + r * r));
  }
  EXPECT_DOUBLE_EQ(robust_term(20.0, 0.2, c), 0.5);
}

TEST(Observability, RobustTermJumpsAtTheNearDistance) {
  const PaperParameters::Vertical c = weights_config();
  EXPECT_EQ(robust_term(kJustBelow10, 0.2, c), 1.0);
  EXPECT_DOUBLE_EQ(robust_term(10.0, 0.2, c), 0.5);
  EXPECT_EQ(robust_term(kJustBelow10, 0.4, c), 0.05);
  EXPECT_DOUBLE_EQ(robust_term(10.0, 0.4, c), 0.2);
}

}  // namespace
}  // namespace surefoot
