// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fixed set of recordings that tables stand on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace surefoot::simulation {

struct SuiteEntry {
  const char* scene;
  const char* robot;
  std::uint64_t scans;
};

/// Long enough for the ramps, the stairs and a lap where the scene has one. The last kNatureEntries
/// came later: sets made before do not hold them.
inline constexpr std::size_t kNatureEntries = 5;
inline constexpr std::array<SuiteEntry, 18> kStandardSuite = {{{"campus", "trot", 800},
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
                                                               {"campus", "handheld", 600},
                                                               {"hillside", "trot", 800},
                                                               {"hilltop", "trot", 600},
                                                               {"forest-path", "trot", 800},
                                                               {"forest-path", "walk", 600},
                                                               {"foyer", "trot", 500}}};

/// The suite's sets of recordings, and the seed of the first recording of each. What was tuned on
/// is never reported: no two sets share a seed. Several reporting sets show the seeds' spread.
struct SuiteSet {
  const char* name;
  std::uint64_t first_seed;
  /// Whether every recording has a layout of its own, and nature is there; else all have the first
  /// layout, so that these sets share buildings, ramps, stairs and most routes.
  bool own_layouts;

  [[nodiscard]] constexpr std::span<const SuiteEntry> entries() const {
    const std::size_t count = kStandardSuite.size() - (own_layouts ? 0 : kNatureEntries);
    return {kStandardSuite.data(), count};
  }
};
inline constexpr std::array<SuiteSet, 22> kSuiteSets = {
    {{"tuning", 1000, false},      {"reporting", 5000, false},   {"reporting-2", 5100, false},
     {"reporting-3", 5200, false}, {"tuning-2", 1100, true},     {"reporting-4", 5300, true},
     {"reporting-5", 5400, true},  {"reporting-6", 6100, true},  {"reporting-7", 6200, true},
     {"reporting-8", 6300, true},  {"reporting-9", 6400, true},  {"reporting-10", 6500, true},
     {"reporting-11", 6600, true}, {"reporting-12", 6700, true}, {"reporting-13", 6800, true},
     {"reporting-14", 6900, true}, {"reporting-15", 7000, true}, {"reporting-16", 7100, true},
     {"reporting-17", 7200, true}, {"reporting-18", 7300, true}, {"reporting-19", 7400, true},
     {"reporting-20", 7500, true}}};

/// The folder of an entry's recording in that of the set.
[[nodiscard]] inline std::string suite_folder_name(const SuiteEntry& entry) {
  return std::string(entry.scene) + '-' + entry.robot;
}

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
