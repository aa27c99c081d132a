// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parallel loops: every element once, sums in one order at any number of threads.
#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace surefoot {
namespace {

TEST(Workers, EveryElementIsVisitedOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    const Workers workers(threads);
    for (const std::size_t size : {0U, 1U, 255U, 256U, 257U, 10'000U}) {
      std::vector<int> visits(size, 0);
      workers.for_chunks(size, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(size, 1));
    }
  }
}

TEST(Workers, SumsHaveTheSameBitsAtAnyNumberOfThreads) {
  test::Random random(1);
  std::vector<double> values;
  for (int i = 0; i < 20'000; ++i) values.push_back(random.normal(1e6) + random.normal(1e-6));
  const auto sum = [&](int threads) {
    return Workers(threads).sum<double>(values.size(), [&](std::size_t begin, std::size_t end) {
      double part = 0.0;
      for (std::size_t i = begin; i < end; ++i) part += values[i];
      return part;
    });
  };
  const double alone = sum(1);
  for (const int threads : {2, 3, 8}) {
    for (int repeat = 0; repeat < 5; ++repeat) EXPECT_EQ(sum(threads), alone);
  }
}

TEST(Workers, MoreThreadsThanTheMachineHasPrintNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Workers workers(1000);
  const int sum = workers.sum<int>(
      10'000, [](std::size_t begin, std::size_t end) { return static_cast<int>(end - begin); });
  EXPECT_EQ(sum, 10'000);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace surefoot
