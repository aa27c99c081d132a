// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Random numbers by counter: a draw depends on the seed and on what it is drawn for, never on how
// many were drawn before it. So a recording is the same to the byte however it is cut into threads
// or scans. std::normal_distribution is not used: its output differs between standard libraries.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace surefoot::simulation {

/// Finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection that mixes every bit.
[[nodiscard]] constexpr std::uint64_t mix64(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// A stream of draws, addressed by counters.
class CounterRandom {
 public:
  /// Streams of one seed with different `purpose` are independent.
  constexpr CounterRandom(std::uint64_t seed, std::uint64_t purpose)
      : key_(mix64(mix64(seed + kWeyl) + purpose * kWeyl)) {}

  [[nodiscard]] constexpr std::uint64_t bits(std::uint64_t counter) const {
    return mix64(key_ + (counter + 1) * kWeyl);
  }
  /// In [0, 1), 53 bits.
  [[nodiscard]] constexpr double uniform(std::uint64_t counter) const {
    return static_cast<double>(bits(counter) >> 11) * 0x1.0p-53;
  }
  [[nodiscard]] constexpr double uniform(std::uint64_t counter, double low, double high) const {
    return low + (high - low) * uniform(counter);
  }
  /// Standard normal (Box-Muller).
  [[nodiscard]] double normal(std::uint64_t counter) const {
    const std::uint64_t word = bits(counter);
    // Two 32-bit halves: the tail ends at 6.7 sigma, which is far enough for a noise model.
    const double u = (static_cast<double>(word >> 32) + 0.5) * 0x1.0p-32;
    const double v = static_cast<double>(word & 0xffffffffULL) * 0x1.0p-32;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  }

 private:
  static constexpr std::uint64_t kWeyl = 0x9e3779b97f4a7c15ULL;
  std::uint64_t key_;
};

}  // namespace surefoot::simulation
