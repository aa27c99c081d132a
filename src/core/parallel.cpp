// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>

#ifdef SUREFOOT_WITH_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#elif defined(SUREFOOT_WITH_STD_THREADS)
#include <thread>
#endif

namespace surefoot {

namespace {

/// What one thread does: whatever is next, so that nobody waits long for who has the most to do.
[[maybe_unused]] auto taking_the_next(std::atomic<std::size_t>& next, std::size_t chunks,
                                      const std::function<void(std::size_t)>& run) {
  return [&next, &run, chunks] {
    for (std::size_t chunk = next++; chunk < chunks; chunk = next++) run(chunk);
  };
}

}  // namespace

#ifdef SUREFOOT_WITH_TBB

struct Workers::Pool {
  explicit Pool(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

Workers::Workers(int threads) {
  // More than the machine has would make oneTBB print a warning, and gain nothing.
  threads_ = std::max(std::min(threads, tbb::info::default_concurrency()), 1);
  if (threads_ > 1) pool_ = std::make_unique<Pool>(threads_);
}

void Workers::run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const {
  std::atomic<std::size_t> next = 0;
  const auto work = taking_the_next(next, chunks, run);
  pool_->arena.execute([&] { tbb::parallel_for(0, threads_, [&](int) { work(); }); });
}

#elif defined(SUREFOOT_WITH_STD_THREADS)

// Begun anew for every loop: slow, but ThreadSanitizer sees into them.
struct Workers::Pool {};

Workers::Workers(int threads) : threads_(std::max(threads, 1)) {
  if (threads_ > 1) pool_ = std::make_unique<Pool>();
}

void Workers::run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const {
  std::atomic<std::size_t> next = 0;
  const auto work = taking_the_next(next, chunks, run);
  std::vector<std::jthread> others;
  for (int i = 1; i < threads_; ++i) others.emplace_back(work);
  work();
}

#else

struct Workers::Pool {};

Workers::Workers(int) {}

void Workers::run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const {
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
}

#endif

Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

}  // namespace surefoot
