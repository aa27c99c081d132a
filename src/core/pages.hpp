// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace surefoot {

/// An array that grows by pages: what is in it is never moved, no scan waits for all of it to be
/// copied, and what was dropped leaves its memory for what comes.
template <typename T>
class Pages {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] T& operator[](std::size_t i) { return pages_[i / kPage][i % kPage]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return pages_[i / kPage][i % kPage]; }

  /// Another one, as it is by default.
  T& add() {
    if (size_ == pages_.size() * kPage) pages_.push_back(std::make_unique<T[]>(kPage));
    return (*this)[size_++] = T{};
  }

  void clear() { size_ = 0; }

 private:
  static constexpr std::size_t kPage = 256;

  std::vector<std::unique_ptr<T[]>> pages_;
  std::size_t size_ = 0;
};

}  // namespace surefoot
