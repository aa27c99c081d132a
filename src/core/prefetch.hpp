// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace surefoot {

inline constexpr std::size_t kCacheLine = 64;

/// Asks memory for the first bytes of something that is soon read, and that begins a cache line.
template <typename T>
void prefetch(const T& value, std::size_t bytes = sizeof(T)) {
#if defined(__GNUC__)
  for (std::size_t at = 0; at < bytes; at += kCacheLine) {
    __builtin_prefetch(reinterpret_cast<const char*>(&value) + at);
  }
#endif
}

}  // namespace surefoot
