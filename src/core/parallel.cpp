// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#ifdef SUREFOOT_WITH_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#elif defined(SUREFOOT_WITH_STD_THREADS)
#include <exception>
#include <functional>
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
  // Isolated: who waits for the end of a loop does not begin with a long piece of another one.
  pool_->arena.execute([&] {
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, threads_, [&](int) { work(); }); });
  });
}

struct Background::Task {
  Workers::Pool* pool;
  bool begun = false;
  tbb::task_group group{};

  void begin(std::function<void()> work) {
    if (pool == nullptr) return work();
    begun = true;
    pool->arena.execute([&] { group.run(std::move(work)); });
  }
  void wait() {
    if (!std::exchange(begun, false)) return;
    pool->arena.execute([&] { group.wait(); });
  }
};

#elif defined(SUREFOOT_WITH_STD_THREADS)

// Begun anew for every loop: slower than oneTBB, but needs nothing, and ThreadSanitizer sees into
// them.
struct Workers::Pool {};

Workers::Workers(int threads) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());  // 0: not known
  threads_ = std::max(cores > 0 ? std::min(threads, cores) : threads, 1);
  if (threads_ > 1) pool_ = std::make_unique<Pool>();
}

void Workers::run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const {
  std::atomic<std::size_t> next = 0;
  const auto take = taking_the_next(next, chunks, run);
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(threads_));
  const auto work = [&](std::exception_ptr& by) {
    try {
      take();
    } catch (...) {
      by = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < thrown.size(); ++i) others.emplace_back(work, std::ref(thrown[i]));
    work(thrown.front());
  }
  for (const std::exception_ptr& by : thrown) {
    if (by) std::rethrow_exception(by);
  }
}

struct Background::Task {
  Workers::Pool* pool;
  std::thread thread{};
  std::exception_ptr thrown{};

  void begin(std::function<void()> work) {
    if (pool == nullptr) return work();
    thread = std::thread([this, work = std::move(work)] {
      try {
        work();
      } catch (...) {
        thrown = std::current_exception();
      }
    });
  }
  void wait() {
    if (thread.joinable()) thread.join();
    if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
  }
};

#else

struct Workers::Pool {};

Workers::Workers(int) {}

void Workers::run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const {
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
}

struct Background::Task {
  Workers::Pool* pool;

  static void begin(const std::function<void()>& work) { work(); }
  static void wait() {}
};

#endif

Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

Background::Background(const Workers& workers) : task_(new Task{workers.pool_.get()}) {}

Background::~Background() {
  try {
    wait();
  } catch (...) {  // nobody is left who could be told
  }
}

void Background::begin(std::function<void()> work) {
  wait();
  task_->begin(std::move(work));
}

void Background::wait() const { task_->wait(); }

}  // namespace surefoot
