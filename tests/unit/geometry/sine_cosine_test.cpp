// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Sines and cosines near a centre against the standard library's.
#include "geometry/sine_cosine.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace surefoot {
namespace {

constexpr double kReach = SineCosineNear::kReach;

TEST(SineCosineNear, IsTheLibrarysToTheLastDigitWithinReach) {
  test::Random random(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const double centre = random.uniform(-20.0, 20.0);
    const double angle = centre + random.uniform(-kReach, kReach);
    const SineCosine near = SineCosineNear(centre)(angle);
    ASSERT_NEAR(near.sine, std::sin(angle), 2.3e-16) << centre << ' ' << angle;
    ASSERT_NEAR(near.cosine, std::cos(angle), 2.3e-16) << centre << ' ' << angle;
  }
}

TEST(SineCosineNear, IsTheLibrarysToTheBitAtTheCentreAndOutOfReach) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double centre = random.uniform(-20.0, 20.0);
    const double out_of_reach =
        centre + random.uniform(1.001, 60.0) * (i % 2 == 0 ? 1 : -1) * kReach;
    for (const double angle : {centre, out_of_reach}) {
      const SineCosine near = SineCosineNear(centre)(angle);
      EXPECT_EQ(near.sine, std::sin(angle));
      EXPECT_EQ(near.cosine, std::cos(angle));
    }
  }
}

TEST(SineCosine, OfASumIsThatOfBothTogether) {
  test::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.uniform(-7.0, 7.0), b = random.uniform(-7.0, 7.0);
    const SineCosine sum = SineCosine(a) + SineCosine(b);
    EXPECT_NEAR(sum.sine, std::sin(a + b), 1e-15);
    EXPECT_NEAR(sum.cosine, std::cos(a + b), 1e-15);
  }
}

}  // namespace
}  // namespace surefoot
