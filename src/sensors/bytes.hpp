// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Numbers out of bytes.
#pragma once

#include <cstddef>
#include <cstring>

namespace surefoot {

/// A number from unaligned bytes of either byte order.
template <typename T>
[[nodiscard]] inline T load(const std::byte* bytes, bool swapped) {
  T value;
  if (!swapped) {
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  std::byte reversed[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    reversed[i] = bytes[sizeof(T) - 1 - i];
  }
  std::memcpy(&value, reversed, sizeof(T));
  return value;
}

}  // namespace surefoot
