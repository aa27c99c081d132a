// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The scenes that the program brings along, one file each. `seed` moves what grows and what is
// strewn about, never the route or the buildings.
#pragma once

#include <cstdint>

#include "simulation/scene.hpp"

namespace surefoot::simulation {

[[nodiscard]] Scene campus(std::uint64_t seed);
[[nodiscard]] Scene parking(std::uint64_t seed);
[[nodiscard]] Scene stairwell(std::uint64_t seed);
[[nodiscard]] Scene playground(std::uint64_t seed);
[[nodiscard]] Scene forest(std::uint64_t seed);
[[nodiscard]] Scene corridor(std::uint64_t seed);
[[nodiscard]] Scene rubble(std::uint64_t seed);
[[nodiscard]] Scene plaza(std::uint64_t seed);

}  // namespace surefoot::simulation
