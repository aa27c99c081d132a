// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parallel loops whose result does not depend on the number of threads: work is cut into chunks of
// a fixed size, each chunk is done by one thread, and sums are added up in the order of the chunks.
// And work that goes on while the caller does something else.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace surefoot {

/// Threads for the library's loops; one thread works in the caller's.
class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  Workers(Workers&&) noexcept;
  Workers& operator=(Workers&&) noexcept;

  /// For how to cut work; no result may depend on it.
  [[nodiscard]] int threads() const { return threads_; }

  /// body(chunk, begin, end) for every chunk of [0, size).
  template <typename Body>
  void for_chunks(std::size_t size, const Body& body) const {
    const std::size_t chunks = chunk_count(size);
    const auto run = [&](std::size_t chunk) {
      body(chunk, chunk * kChunk, std::min(size, (chunk + 1) * kChunk));
    };
    if (!pool_ || chunks < 2) {
      for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
    } else {
      run_in_pool(chunks, run);
    }
  }

  /// body(i) for every i below `count`: few bodies with much work each.
  template <typename Body>
  void for_each(std::size_t count, const Body& body) const {
    if (!pool_ || count < 2) {
      for (std::size_t i = 0; i < count; ++i) body(i);
    } else {
      run_in_pool(count, body);
    }
  }

  /// Sum of body(begin, end) over the chunks, in their order. `Sum` starts as Sum{} and has +=.
  template <typename Sum, typename Body>
  [[nodiscard]] Sum sum(std::size_t size, const Body& body) const {
    std::vector<Sum> parts(chunk_count(size));
    for_chunks(size, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      parts[chunk] = body(begin, end);
    });
    Sum total{};
    for (const Sum& part : parts) total += part;
    return total;
  }

 private:
  friend class Background;
  static constexpr std::size_t kChunk = 256;
  static std::size_t chunk_count(std::size_t size) { return (size + kChunk - 1) / kChunk; }
  void run_in_pool(std::size_t chunks, const std::function<void(std::size_t)>& run) const;

  struct Pool;
  int threads_ = 1;
  std::unique_ptr<Pool> pool_;
};

/// Work that one of the workers' threads does while the caller goes on; with one thread it is done
/// at once. What it touches is the caller's again after wait().
class Background {
 public:
  /// @param workers outlive it.
  explicit Background(const Workers& workers);
  /// Waits; what the work throws is lost.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Begins, once the work before has ended.
  void begin(std::function<void()> work);
  /// Throws what the work threw.
  void wait() const;

 private:
  struct Task;
  std::unique_ptr<Task> task_;
};

}  // namespace surefoot
