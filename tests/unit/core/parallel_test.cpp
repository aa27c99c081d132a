// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parallel loops: every element once, sums in one order at any number of threads.
#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

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

TEST(Workers, WhatALoopThrowsReachesTheCaller) {
  for (const int threads : {1, 2}) {
    const auto fail = [](std::size_t i) {
      if (i == 3) throw std::runtime_error("three");
    };
    EXPECT_THROW(Workers(threads).for_each(8, fail), std::runtime_error) << threads;
  }
}

TEST(Background, WhatWasBegunIsDoneAfterTheWait) {
  for (const int threads : {1, 2, 3}) {
    const Workers workers(threads);
    std::vector<int> done;
    Background background(workers);
    for (int i = 0; i < 100; ++i) background.begin([&done, i] { done.push_back(i); });
    background.wait();
    background.wait();
    ASSERT_EQ(done.size(), 100U) << threads;
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i) << threads;
  }
}

TEST(Background, LoopsWithinItAndBesideItAreEachWhole) {
  const Workers workers(2);
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::vector<int> within(5'000, 0), beside(5'000, 0);
    const auto count = [&workers](std::vector<int>& visits) {
      workers.for_chunks(visits.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
    };
    Background background(workers);
    background.begin([&] { count(within); });
    count(beside);
    background.wait();
    EXPECT_EQ(within, std::vector<int>(5'000, 1));
    EXPECT_EQ(beside, std::vector<int>(5'000, 1));
  }
}

/// The caller goes on at once: work that waits for what the caller does afterwards comes to an end.
TEST(Background, GoesOnWhileTheCallerDoesSomethingElse) {
  const Workers workers(2);
  if (workers.threads() < 2) GTEST_SKIP() << "one thread";
  std::atomic<bool> called = false;
  Background background(workers);
  background.begin([&called] {
    while (!called) std::this_thread::yield();
  });
  called = true;
  background.wait();
}

TEST(Background, ThrowsOnceWhatTheWorkThrew) {
  for (const int threads : {1, 2}) {
    const Workers workers(threads);
    Background background(workers);
    const auto throwing = [&] {
      background.begin([] { throw std::bad_alloc(); });
      background.wait();
    };
    EXPECT_THROW(throwing(), std::bad_alloc) << threads;
    EXPECT_NO_THROW(background.wait()) << threads;
    bool done = false;
    background.begin([&done] { done = true; });
    background.wait();
    EXPECT_TRUE(done) << threads;
  }
}

TEST(Background, ItsEndWaits) {
  const Workers workers(2);
  std::atomic<int> done = 0;
  for (int i = 0; i < 20; ++i) {
    Background background(workers);
    background.begin([&done] {
      std::this_thread::yield();
      ++done;
    });
  }
  EXPECT_EQ(done, 20);
  EXPECT_NO_THROW({
    Background background(workers);
    if (workers.threads() > 1) background.begin([] { throw std::bad_alloc(); });
  });
}

}  // namespace
}  // namespace surefoot
