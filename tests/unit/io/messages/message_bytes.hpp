// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What messages are put together from.
#pragma once

#include "unit/io/support.hpp"

namespace surefoot::io::test {

inline std::string word(std::uint32_t value) { return little(value); }
inline std::string zeros(std::size_t count) { return std::string(count, '\0'); }
inline const std::string kCdr("\0\1\0\0", 4);

// CDR pads to the size of what follows, counted after the first four bytes.
inline std::string padded(std::string bytes, std::size_t unit) {
  while ((bytes.size() - 4) % unit != 0) bytes += '\0';
  return bytes;
}

}  // namespace surefoot::io::test
