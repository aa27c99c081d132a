// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace surefoot::report {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// Of the numbers' bytes as this (little-endian) machine has them.
template <typename T>
[[nodiscard]] std::string base64_of(std::span<const T> numbers) {
  return base64(std::as_bytes(numbers));
}

}  // namespace surefoot::report
