// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The fixed set of recordings that tables stand on.
#pragma once

#include <array>
#include <cstdint>

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

enum class SeedKind { kTuning, kReporting };

/// What was tuned on is never reported: the two kinds share no seed.
[[nodiscard]] constexpr std::uint64_t suite_seed(SeedKind kind, std::size_t entry) {
  return (kind == SeedKind::kTuning ? 1000U : 5000U) + entry;
}

}  // namespace surefoot::simulation
