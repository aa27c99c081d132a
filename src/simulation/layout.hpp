// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a scene is drawn from: one number for how it is built, one for what grows and stands in it.
#pragma once

#include <cstdint>

#include "simulation/random.hpp"

namespace surefoot::simulation {

/// The layout that every scene had before layouts were drawn. Recordings that share a layout share
/// buildings, ground, ramps, stairs and route.
inline constexpr std::uint64_t kFirstLayout = 1;

struct SceneSeeds {
  std::uint64_t layout = kFirstLayout;  ///< buildings, ground, ramps, stairs, route
  std::uint64_t things = 1;             ///< what grows, what is strewn about, who walks
  /// Both the same.
  [[nodiscard]] static SceneSeeds of(std::uint64_t seed) { return {seed, seed}; }
};

/// Measures of a layout: the first one's are given, all others are drawn.
class LayoutDraws {
 public:
  /// @param purpose one a scene.
  constexpr LayoutDraws(std::uint64_t layout, std::uint64_t purpose)
      : first_(layout == kFirstLayout), random_(layout, purpose + 1'000'000) {}

  [[nodiscard]] constexpr bool first() const { return first_; }
  /// @param number of the measure within its scene.
  [[nodiscard]] constexpr double between(std::uint64_t number, double first, double low,
                                         double high) const {
    return first_ ? first : random_.uniform(number, low, high);
  }
  /// Whole numbers, both ends included.
  [[nodiscard]] constexpr int whole(std::uint64_t number, int first, int low, int high) const {
    const auto choices = static_cast<std::uint64_t>(high - low) + 1;
    return first_ ? first : low + static_cast<int>(random_.bits(number) % choices);
  }

 private:
  bool first_;
  CounterRandom random_;
};

}  // namespace surefoot::simulation
