// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// To whole numbers, in place: SSE2 has no instruction for it, so that std::round and std::llround
// are calls into the C library, a few for every beam.
#pragma once

#include <cmath>
#include <cstdint>

namespace surefoot::simulation {

/// The nearest whole number, halves away from zero: std::llround's for what is less than 2^51,
/// but for the one number below a half and its negative, which become 1 and -1.
[[nodiscard]] inline std::int64_t rounded(double value) {
  return static_cast<std::int64_t>(value + std::copysign(0.5, value));
}

/// The nearest multiple of a unit.
[[nodiscard]] inline double rounded_to(double unit, double value) {
  return static_cast<double>(rounded(value / unit)) * unit;
}

}  // namespace surefoot::simulation
