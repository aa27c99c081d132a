// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fixed set of recordings that tables stand on.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace surefoot::simulation {

struct SuiteEntry {
  const char* scene;
  const char* robot;
  std::uint64_t scans;
};

/// Long enough for the ramps, the stairs and a lap where the scene has one.
inline constexpr std::array<SuiteEntry, 13> kStandardSuite = {{{"campus", "trot", 800},
                                                               {"campus", "run", 400},
                                                               {"campus", "wheel", 600},
                                                               {"parking", "trot", 900},
                                                               {"parking", "walk", 600},
                                                               {"stairwell", "stairs", 900},
                                                               {"playground", "trot", 700},
                                                               {"forest", "trot", 600},
                                                               {"corridor", "trot", 600},
                                                               {"rubble", "walk", 600},
                                                               {"plaza", "trot", 600},
                                                               {"plaza", "handheld", 400},
                                                               {"campus", "handheld", 600}}};

/// The suite's sets of recordings, and the seed of the first recording of each. What was tuned on
/// is never reported: no two sets share a seed. Several reporting sets show the seeds' spread.
struct SuiteSet {
  const char* name;
  std::uint64_t first_seed;
};
inline constexpr std::array<SuiteSet, 4> kSuiteSets = {
    {{"tuning", 1000}, {"reporting", 5000}, {"reporting-2", 5100}, {"reporting-3", 5200}}};

/// nullptr if there is no such set.
[[nodiscard]] constexpr const SuiteSet* find_suite_set(std::string_view name) {
  for (const SuiteSet& set : kSuiteSets) {
    if (name == set.name) return &set;
  }
  return nullptr;
}

[[nodiscard]] constexpr std::uint64_t suite_seed(const SuiteSet& set, std::size_t entry) {
  return set.first_seed + entry;
}

}  // namespace surefoot::simulation
